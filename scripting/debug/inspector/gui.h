// Dear ImGui on this program's input and renderer. Invariant: its context lives as long as the object, and
// everything is drawn as triangles through engine::Renderer, so it works with every back-end.
#pragma once

#include <array>
#include <bitset>
#include <memory>

#include <cairn/engine/files.h>
#include <cairn/engine/input.h>
#include <cairn/engine/renderer.h>
#include <cairn/engine/result.h>

struct ImGuiContext;
struct ImDrawList;

namespace cairn::scripting {

class Gui {
  public:
    /// The error says which file of the font is wrong.
    static engine::Result<std::unique_ptr<Gui>> create(const engine::Files& files,
                                                       engine::Renderer& renderer);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// True when the event was meant for the GUI: the game must not see it.
    bool take(const engine::InputEvent& event);

    /// The widgets of a picture are made between these two.
    void begin(float elapsed_s);
    void end();
    /// Instead of `end`: nothing is drawn. Some widgets find their places only in a second picture.
    static void discard();
    /// Where the window is that was made last: what happens there is the GUI's from now on.
    void note_window();

  private:
    explicit Gui(engine::Renderer& renderer);
    engine::Result<void> load_font(const engine::Files& files);
    bool take_mouse_button(const engine::InputEvent& event);
    bool take_key(const engine::InputEvent& event);
    bool take_touch(const engine::InputEvent& event);
    /// The middle button gives a gamepad to the GUI, and back to the game.
    bool take_gamepad(const engine::InputEvent& event);
    /// What the gamepad that was given does, for the next picture.
    void steer();
    /// Dear ImGui knows what the mouse is over only after the next picture; a finger comes from nowhere.
    [[nodiscard]] bool covers(engine::Vec2 point) const;
    void draw_list(const ImDrawList& list) const;

    engine::Renderer& renderer_;
    ImGuiContext* context_;
    engine::TextureId font_;
    engine::Rect window_;
    // What went down here comes up here.
    std::bitset<engine::kMouseButtonCount> taken_buttons_;
    std::bitset<engine::kMaxTouches + 1> taken_touches_;
    std::array<std::bitset<engine::kGamepadButtonCount>, engine::kMaxGamepads + 1> taken_gamepad_buttons_;
    engine::InputState gamepads_;
    int gamepad_ = 0;  ///< the one that drives the GUI; 0: none
    bool wants_focus_ = false;
};

}  // namespace cairn::scripting
