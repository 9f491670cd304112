// A window of the desktop. Invariant: the SDL window exists as long as this object.
#pragma once

#include <memory>
#include <optional>

#include <cairn/engine/platform.h>

#include "render/viewport.h"

struct SDL_Window;

namespace cairn::engine {

class SdlWindow final : public Window {
  public:
    /// SDL's video must have been started.
    static Result<std::unique_ptr<SdlWindow>> create(const WindowDef& def);

    const std::string& title() const override { return title_; }
    void set_title(const std::string& title) override;
    Size logical_size() const override { return logical_; }
    void set_logical_size(Size size) override { logical_ = size; }
    /// The logical size that the events now being read will lead to, before the game knows of it: where the
    /// mouse is after a resize is told in the new size. Nothing: as it is.
    void expect_logical_size(std::optional<Size> size) { expected_ = size; }
    Size size() const override;
    void set_size(Size size) override;
    bool is_resizable() const override;
    void set_resizable(bool resizable) override;
    bool is_fullscreen() const override;
    void set_fullscreen(bool fullscreen) override;
    bool is_visible() const override;

    SDL_Window* native() const { return window_.get(); }
    const WindowDef& def() const { return def_; }

    /// Turns positions and movements in the desktop's points, as SDL reports them, into logical pixels.
    Vec2 position_from_points(Vec2 points) const;
    Vec2 movement_from_points(Vec2 points) const;
    /// The same for shares of the window, 0 .. 1, as SDL reports fingers.
    Vec2 position_from_share(Vec2 share) const;

  private:
    struct Destroy {
        void operator()(SDL_Window* window) const;
    };

    SdlWindow(const WindowDef& def, SDL_Window* window)
        : def_(def), title_(def.title), logical_(def.size), window_(window) {}
    Viewport viewport() const;
    /// Output pixels per point: above 1 on high-DPI screens.
    Vec2 pixels_per_point() const;

    WindowDef def_;
    std::string title_;
    Size logical_;
    std::optional<Size> expected_;
    std::unique_ptr<SDL_Window, Destroy> window_;
};

}  // namespace cairn::engine
