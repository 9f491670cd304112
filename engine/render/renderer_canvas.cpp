// Canvases: textures that are drawn into. Invariant: the back-end's target is always State::canvas, and
// whatever was set when a canvas was begun is set again when it ends.
#include <algorithm>
#include <utility>

#include <cairn/engine/renderer.h>

#include "render/renderer_state.h"

namespace cairn::engine {
namespace {

/// Deeper than any picture within a picture; a begin without its end meets it soon.
constexpr std::size_t kMaxCanvases = 8;

}  // namespace

Result<TextureId> Renderer::create_canvas(Size size, TextureFilter filter) {
    if (size.width < 1 || size.height < 1 || size.width > kMaxImageSide || size.height > kMaxImageSide)
        return Error{"the size of a canvas is " + std::to_string(size.width) + " x " +
                     std::to_string(size.height) + ", but must be 1 to " + std::to_string(kMaxImageSide) +
                     " on each side"};
    Texture texture;
    texture.size = size;
    texture.is_canvas = true;
    if (state_->backend->keeps_pixels()) {
        const Result<BackendTexture> made = state_->backend->create_canvas(size, filter);
        if (!made) return made.error();
        texture.backend_texture = *made;
    }
    return state_->textures.insert(std::move(texture));
}

Result<void> Renderer::begin_canvas(TextureId canvas, std::optional<Color> clear) {
    State& s = *state_;
    const Texture* found = s.textures.find(canvas);
    if (!found) return Error{"the canvas is null, or was destroyed"};
    if (!found->is_canvas) return Error{"an image that was loaded cannot be drawn into"};
    if (s.suspended.size() >= kMaxCanvases)
        return Error{std::to_string(kMaxCanvases) + " canvases are in use already; is an end missing?"};
    const auto is_canvas = [&](const SuspendedTarget& target) { return target.canvas == canvas; };
    if (s.canvas == canvas || std::any_of(s.suspended.begin(), s.suspended.end(), is_canvas))
        return Error{"the canvas is being drawn into already"};

    s.batch.flush();
    s.suspended.push_back(
        {s.canvas, s.viewport, std::exchange(s.frames, {DrawingFrame{}}), s.batch.blend_mode(), s.scissor});
    s.canvas = canvas;
    s.viewport = {.output = found->size, .logical = found->size, .scale = 1, .offset = {}};
    s.backend->set_target(found->backend_texture);
    s.batch.set_blend_mode(BlendMode::Alpha);
    set_scissor(std::nullopt);
    if (clear) s.backend->clear(*clear);
    return {};
}

Result<void> Renderer::end_canvas() {
    State& s = *state_;
    if (s.suspended.empty()) return Error{"no canvas is being drawn into"};
    s.batch.flush();
    SuspendedTarget before = std::move(s.suspended.back());
    s.suspended.pop_back();
    s.canvas = before.canvas;
    s.viewport = before.viewport;
    s.frames = std::move(before.frames);
    const Texture* target = s.textures.find(s.canvas);
    s.backend->set_target(target ? target->backend_texture : 0);
    s.batch.set_blend_mode(before.blend);
    set_scissor(before.scissor);
    return {};
}

TextureId Renderer::current_canvas() const {
    return state_->canvas;
}

Size Renderer::target_size() const {
    return state_->canvas.is_null() ? logical_size() : state_->viewport.logical;
}

void Renderer::State::end_all_canvases() {
    if (!suspended.empty()) {
        batch.flush();
        viewport = suspended.front().viewport;
        frames = std::move(suspended.front().frames);
        suspended.clear();
        canvas = {};
        backend->set_target(0);
    }
    for (const TextureId texture : std::exchange(doomed, {})) destroy(texture);
}

}  // namespace cairn::engine
