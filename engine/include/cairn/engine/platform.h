// The machine that a game runs on: a window with input events and real time, or none of them (headless).
// Invariant: the two back-ends answer the same calls, and the choice between them is made once, in create().
// The headless one touches no display, no sound device and no clock.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cairn/engine/geometry.h>
#include <cairn/engine/input.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

class Audio;
class Files;
class Renderer;

/// What the window's own size does to the game's logical size.
enum class WindowScaling {
    Fit,  ///< the logical size stays; the picture is scaled to fit, with black bars at two sides
    /// The logical size is to be the window's own. A change arrives as InputKind::WindowResized and takes
    /// effect when Window::set_logical_size is given it: so a recording can do the same.
    Follow,
};

struct WindowDef {
    std::string title = "Cairn";
    Size size = {1280, 720};  ///< logical pixels, each side in 1 .. 8192
    WindowScaling scaling = WindowScaling::Fit;
    /// Of the window itself, in the desktop's points, each side in 1 .. 8192; absent: as `size`.
    std::optional<Size> window_size = {};
    bool is_resizable = true;
    bool is_fullscreen = false;
    bool has_vsync = true;
    bool is_high_dpi = true;  ///< all pixels of a dense display are drawn; else one for each point
};

struct PlatformDef {
    bool headless = false;
    /// A headless platform draws into memory when this is set, so that pictures can be captured; otherwise
    /// its renderer is the null one.
    bool headless_drawing = false;
    WindowDef window = {};
};

class Window {
  public:
    virtual ~Window() = default;

    virtual const std::string& title() const = 0;
    virtual void set_title(const std::string& title) = 0;
    /// What the game draws into and what mouse positions are measured in.
    virtual Size logical_size() const = 0;
    /// From the next frame on. The picture is scaled to fit the window. Each side in 1 .. 8192.
    virtual void set_logical_size(Size size) = 0;
    /// Of the window itself, in the desktop's points.
    virtual Size size() const = 0;
    /// What the desktop allows of it. Leaves full screen. Each side in 1 .. 8192.
    virtual void set_size(Size size) = 0;
    virtual bool is_resizable() const = 0;
    virtual void set_resizable(bool resizable) = 0;
    virtual bool is_fullscreen() const = 0;
    virtual void set_fullscreen(bool fullscreen) = 0;
    /// False while minimised or hidden: a frame drawn then is seen by nobody.
    virtual bool is_visible() const = 0;
};

/// Of windows and of logical pictures.
inline constexpr int kMaxWindowSide = 8192;

/// Audio and renderers must be destroyed before the platform that made them, and before the Files they read.
class Platform {
  public:
    static Result<std::unique_ptr<Platform>> create(const PlatformDef& def);
    virtual ~Platform() = default;

    virtual bool is_headless() const = 0;
    virtual Window& window() = 0;

    /// At most one at a time.
    virtual Result<std::unique_ptr<Renderer>> create_renderer(const Files& files) = 0;
    virtual std::unique_ptr<Audio> create_audio(const Files& files) = 0;

    /// Appends what happened since the last call, in order. Headless: nothing but what the game itself did to
    /// the size of its window.
    virtual void poll_events(std::vector<InputEvent>& events) = 0;

    /// The number of the signal (SIGINT, SIGTERM) by which the system or a terminal asked the program to end:
    /// unlike InputKind::QuitRequested it must; a second signal ends it at once. 0: none. Headless: always 0,
    /// because there the first one ends the program.
    virtual int end_signal() const = 0;
    /// Called by the first such signal wherever the program is, by its handler: may do no more than handlers
    /// may. Null: nothing, as at first. Headless: never called.
    virtual void on_end_signal(void (*call)()) = 0;

    /// Seconds since the platform was made; only differences mean something. Headless: 0 for ever.
    virtual double now_s() const = 0;
    /// Lets other programs run. Headless: returns at once.
    virtual void sleep_s(double duration_s) = 0;

    /// Shakes a gamepad, with its heavy and its light weight, 0 .. 1 each; nothing where there is none.
    virtual void rumble(int gamepad, float low, float high, double duration_s) = 0;

    virtual Result<void> set_clipboard_text(const std::string& text) = 0;
};

}  // namespace cairn::engine
