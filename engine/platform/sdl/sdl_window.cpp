// The SDL window. Invariant: sizes are asked from SDL each time, because the desktop changes them without
// telling first.
#include "platform/sdl/sdl_window.h"

#include <SDL.h>
#include <algorithm>

namespace cairn::engine {

void SdlWindow::Destroy::operator()(SDL_Window* window) const {
    SDL_DestroyWindow(window);
}

Result<std::unique_ptr<SdlWindow>> SdlWindow::create(const WindowDef& def) {
    Uint32 flags = 0;
    if (def.is_high_dpi) flags |= SDL_WINDOW_ALLOW_HIGHDPI;
    if (def.is_resizable) flags |= SDL_WINDOW_RESIZABLE;
    if (def.is_fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    const Size points = def.window_size.value_or(def.size);
    SDL_Window* window = SDL_CreateWindow(def.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                          points.width, points.height, flags);
    if (!window) return Error{std::string("cannot open a window: ") + SDL_GetError()};
    return std::unique_ptr<SdlWindow>(new SdlWindow(def, window));
}

void SdlWindow::set_title(const std::string& title) {
    title_ = title;
    SDL_SetWindowTitle(native(), title_.c_str());
}

bool SdlWindow::is_fullscreen() const {
    return (SDL_GetWindowFlags(native()) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
}

void SdlWindow::set_fullscreen(bool fullscreen) {
    SDL_SetWindowFullscreen(native(), fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

Size SdlWindow::size() const {
    Size points;
    SDL_GetWindowSize(native(), &points.width, &points.height);
    return points;
}

void SdlWindow::set_size(Size size) {
    if (is_fullscreen()) set_fullscreen(false);
    SDL_SetWindowSize(native(), size.width, size.height);
}

bool SdlWindow::is_resizable() const {
    return (SDL_GetWindowFlags(native()) & SDL_WINDOW_RESIZABLE) != 0;
}

void SdlWindow::set_resizable(bool resizable) {
    SDL_SetWindowResizable(native(), resizable ? SDL_TRUE : SDL_FALSE);
}

bool SdlWindow::is_visible() const {
    return (SDL_GetWindowFlags(native()) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) == 0;
}

Viewport SdlWindow::viewport() const {
    Size output;
    SDL_GetWindowSizeInPixels(native(), &output.width, &output.height);
    return make_viewport(expected_.value_or(logical_), output);
}

Vec2 SdlWindow::pixels_per_point() const {
    const Size points = size();
    Size pixels;
    SDL_GetWindowSizeInPixels(native(), &pixels.width, &pixels.height);
    return {static_cast<float>(pixels.width) / static_cast<float>(std::max(points.width, 1)),
            static_cast<float>(pixels.height) / static_cast<float>(std::max(points.height, 1))};
}

Vec2 SdlWindow::position_from_points(Vec2 points) const {
    const Vec2 ratio = pixels_per_point();
    return viewport().to_logical({points.x * ratio.x, points.y * ratio.y});
}

Vec2 SdlWindow::position_from_share(Vec2 share) const {
    const Viewport view = viewport();
    return view.to_logical(
        {share.x * static_cast<float>(view.output.width), share.y * static_cast<float>(view.output.height)});
}

Vec2 SdlWindow::movement_from_points(Vec2 points) const {
    const Vec2 ratio = pixels_per_point();
    const float scale = viewport().scale;
    return {points.x * ratio.x / scale, points.y * ratio.y / scale};
}

}  // namespace cairn::engine
