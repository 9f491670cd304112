// The bridge to Dear ImGui 1.86, which Debian 12 has: keys by its key map, lists of triangles with 16-bit
// indices.
#include "debug/inspector/gui.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace cairn::scripting {
namespace {

using engine::InputEvent;
using engine::InputKind;
using engine::Key;

constexpr float kFontSize = 15;

constexpr std::array<std::pair<ImGuiKey_, Key>, 22> kKeys{{
    {ImGuiKey_Tab, Key::Tab},
    {ImGuiKey_LeftArrow, Key::Left},
    {ImGuiKey_RightArrow, Key::Right},
    {ImGuiKey_UpArrow, Key::Up},
    {ImGuiKey_DownArrow, Key::Down},
    {ImGuiKey_PageUp, Key::PageUp},
    {ImGuiKey_PageDown, Key::PageDown},
    {ImGuiKey_Home, Key::Home},
    {ImGuiKey_End, Key::End},
    {ImGuiKey_Insert, Key::Insert},
    {ImGuiKey_Delete, Key::Delete},
    {ImGuiKey_Backspace, Key::Backspace},
    {ImGuiKey_Space, Key::Space},
    {ImGuiKey_Enter, Key::Return},
    {ImGuiKey_Escape, Key::Escape},
    {ImGuiKey_KeyPadEnter, Key::KeypadEnter},
    {ImGuiKey_A, Key::A},
    {ImGuiKey_C, Key::C},
    {ImGuiKey_V, Key::V},
    {ImGuiKey_X, Key::X},
    {ImGuiKey_Y, Key::Y},
    {ImGuiKey_Z, Key::Z},
}};

/// Sticks of worn gamepads rest anywhere within this.
constexpr float kStickRest = 0.2f;

constexpr std::array<std::pair<ImGuiNavInput_, engine::GamepadButton>, 10> kGamepadButtons{{
    {ImGuiNavInput_Activate, engine::GamepadButton::A},
    {ImGuiNavInput_Cancel, engine::GamepadButton::B},
    {ImGuiNavInput_Menu, engine::GamepadButton::X},
    {ImGuiNavInput_Input, engine::GamepadButton::Y},
    {ImGuiNavInput_DpadLeft, engine::GamepadButton::DpadLeft},
    {ImGuiNavInput_DpadRight, engine::GamepadButton::DpadRight},
    {ImGuiNavInput_DpadUp, engine::GamepadButton::DpadUp},
    {ImGuiNavInput_DpadDown, engine::GamepadButton::DpadDown},
    {ImGuiNavInput_TweakSlow, engine::GamepadButton::LeftShoulder},
    {ImGuiNavInput_TweakFast, engine::GamepadButton::RightShoulder},
}};

void note_modifiers(ImGuiIO& io) {
    const auto is_down = [&](Key key) { return io.KeysDown[static_cast<std::size_t>(key)]; };
    io.KeyCtrl = is_down(Key::LeftControl) || is_down(Key::RightControl);
    io.KeyShift = is_down(Key::LeftShift) || is_down(Key::RightShift);
    io.KeyAlt = is_down(Key::LeftAlt) || is_down(Key::RightAlt);
    io.KeySuper = is_down(Key::LeftMeta) || is_down(Key::RightMeta);
}

void set_style() {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 6;
    style.FrameRounding = 3;
    style.Colors[ImGuiCol_WindowBg] = {0.07f, 0.09f, 0.12f, 0.94f};
}

engine::Color color_of(ImU32 packed) {
    const auto part = [&](int shift) { return static_cast<float>(packed >> shift & 0xff) / 255; };
    return {part(IM_COL32_R_SHIFT), part(IM_COL32_G_SHIFT), part(IM_COL32_B_SHIFT), part(IM_COL32_A_SHIFT)};
}

}  // namespace

engine::Result<std::unique_ptr<Gui>> Gui::create(const engine::Files& files, engine::Renderer& renderer) {
    std::unique_ptr<Gui> gui(new Gui(renderer));
    if (auto loaded = gui->load_font(files); !loaded) return loaded.error();
    return gui;
}

Gui::Gui(engine::Renderer& renderer) : renderer_(renderer), context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // nothing is written behind the game's back
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_NavEnableGamepad;
    for (const auto& [gui_key, key] : kKeys) io.KeyMap[gui_key] = static_cast<int>(key);
    set_style();
}

Gui::~Gui() {
    renderer_.destroy_texture(font_);
    ImGui::DestroyContext(context_);
}

engine::Result<void> Gui::load_font(const engine::Files& files) {
    const auto file = files.read_bytes("fonts/default.ttf");
    if (!file) return file.error();
    ImGuiIO& io = ImGui::GetIO();
    // Made for the display's own pixels, and drawn in logical ones.
    const float scale = std::max(1.0f, renderer_.pixel_scale());
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;  // it is read before this function ends
    io.Fonts->AddFontFromMemoryTTF(const_cast<std::byte*>(file->data()), static_cast<int>(file->size()),
                                   kFontSize * scale, &config);
    io.FontGlobalScale = 1 / scale;
    unsigned char* pixels = nullptr;
    engine::Image image;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &image.size.width, &image.size.height);
    if (pixels == nullptr) return engine::Error{"fonts/default.ttf cannot be drawn by Dear ImGui"};
    image.rgba.assign(pixels, pixels + 4 * image.size.width * image.size.height);
    const auto texture = renderer_.create_texture(image);
    if (!texture) return texture.error();
    font_ = *texture;
    io.Fonts->ClearTexData();
    return {};
}

bool Gui::take(const InputEvent& event) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    switch (event.kind) {
        case InputKind::MouseMoved:
            io.MousePos = {event.position.x, event.position.y};
            return io.WantCaptureMouse;
        case InputKind::MousePressed:
        case InputKind::MouseReleased:
            return take_mouse_button(event);
        case InputKind::WheelMoved:
            if (!io.WantCaptureMouse) return false;
            io.MouseWheel += event.delta.y;
            io.MouseWheelH -= event.delta.x;
            return true;
        case InputKind::KeyPressed:
        case InputKind::KeyReleased:
            return take_key(event);
        case InputKind::TouchPressed:
        case InputKind::TouchMoved:
        case InputKind::TouchReleased:
            return take_touch(event);
        case InputKind::TextEntered:
            if (!io.WantTextInput) return false;
            io.AddInputCharactersUTF8(event.text.c_str());
            return true;
        case InputKind::FocusLost:
            std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
            std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
            note_modifiers(io);
            return false;
        case InputKind::GamepadConnected:
        case InputKind::GamepadDisconnected:
        case InputKind::GamepadPressed:
        case InputKind::GamepadReleased:
        case InputKind::GamepadMoved:
            return take_gamepad(event);
        case InputKind::WindowResized:
        case InputKind::FocusGained:
        case InputKind::QuitRequested:
            return false;
    }
    return false;
}

bool Gui::take_mouse_button(const InputEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    const auto button = static_cast<std::size_t>(event.button);
    // Its buttons are left, right, middle.
    constexpr std::array<std::size_t, engine::kMouseButtonCount> kOrder{0, 2, 1, 3, 4};
    io.MousePos = {event.position.x, event.position.y};
    if (event.kind == InputKind::MouseReleased) {
        io.MouseDown[kOrder[button]] = false;
        const bool was_taken = taken_buttons_[button];
        taken_buttons_[button] = false;
        return was_taken;
    }
    if (!io.WantCaptureMouse && !covers(event.position)) return false;
    io.MouseDown[kOrder[button]] = true;
    taken_buttons_[button] = true;
    return true;
}

// The first finger is the mouse too, which does the work; here the game is kept from seeing it twice.
bool Gui::take_touch(const InputEvent& event) {
    const auto finger = static_cast<std::size_t>(std::clamp(event.number, 0, engine::kMaxTouches));
    const bool was_taken = taken_touches_[finger];
    if (event.kind == InputKind::TouchPressed) taken_touches_[finger] = covers(event.position);
    if (event.kind == InputKind::TouchReleased) taken_touches_[finger] = false;
    return was_taken || taken_touches_[finger];
}

bool Gui::take_gamepad(const InputEvent& event) {
    gamepads_.apply(event);
    const int number = std::clamp(event.number, 0, engine::kMaxGamepads);
    auto& taken = taken_gamepad_buttons_[static_cast<std::size_t>(number)];
    const auto button = static_cast<std::size_t>(event.gamepad_button);
    const bool is_press = event.kind == InputKind::GamepadPressed;
    if (event.kind == InputKind::GamepadReleased) {
        const bool was_taken = taken[button];
        taken[button] = false;
        return was_taken;
    }
    if (is_press && event.gamepad_button == engine::GamepadButton::Guide) {
        taken[button] = true;
        gamepad_ = gamepad_ == number ? 0 : number;
        wants_focus_ = gamepad_ != 0;
        return true;
    }
    if (number != gamepad_) return false;
    if (event.kind == InputKind::GamepadDisconnected) gamepad_ = 0;
    if (is_press) taken[button] = true;
    // A stick that comes to rest may have been moved in the game.
    return is_press || (event.kind == InputKind::GamepadMoved && std::abs(event.value) > kStickRest);
}

void Gui::steer() {
    ImGuiIO& io = ImGui::GetIO();
    io.BackendFlags &= ~ImGuiBackendFlags_HasGamepad;
    std::fill(std::begin(io.NavInputs), std::end(io.NavInputs), 0.0f);
    if (gamepad_ == 0) return;
    io.BackendFlags |= ImGuiBackendFlags_HasGamepad;
    const engine::Gamepad& pad = gamepads_.gamepad(gamepad_);
    for (const auto& [input, button] : kGamepadButtons)
        io.NavInputs[input] = pad.is_down(button) ? 1.0f : 0.0f;
    const engine::Vec2 stick{pad.axis(engine::GamepadAxis::LeftX), pad.axis(engine::GamepadAxis::LeftY)};
    const auto beyond_rest = [](float value) {
        return std::max(0.0f, value - kStickRest) / (1 - kStickRest);
    };
    io.NavInputs[ImGuiNavInput_LStickLeft] = beyond_rest(-stick.x);
    io.NavInputs[ImGuiNavInput_LStickRight] = beyond_rest(stick.x);
    io.NavInputs[ImGuiNavInput_LStickUp] = beyond_rest(stick.y);
    io.NavInputs[ImGuiNavInput_LStickDown] = beyond_rest(-stick.y);
    if (std::exchange(wants_focus_, false)) ImGui::SetNextWindowFocus();
}

bool Gui::covers(engine::Vec2 point) const {
    const engine::Vec2 p = point - engine::Vec2{window_.x, window_.y};
    return p.x >= 0 && p.y >= 0 && p.x < window_.width && p.y < window_.height;
}

void Gui::note_window() {
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    window_ = {corner.x, corner.y, size.x, size.y};
}

bool Gui::take_key(const InputEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    const bool is_press = event.kind == InputKind::KeyPressed;
    io.KeysDown[static_cast<std::size_t>(event.key)] = is_press && io.WantCaptureKeyboard;
    note_modifiers(io);
    // Releases go on to the game, which may have seen the key go down.
    return is_press && io.WantTextInput;
}

void Gui::begin(float elapsed_s) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    const engine::Size size = renderer_.logical_size();
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    io.DeltaTime = std::clamp(elapsed_s, 1e-4f, 1.0f);
    steer();
    ImGui::NewFrame();
}

void Gui::discard() {
    ImGui::EndFrame();
}

void Gui::end() {
    ImGui::Render();
    const ImDrawData& data = *ImGui::GetDrawData();
    renderer_.reset_transform();
    renderer_.set_blend_mode(engine::BlendMode::Alpha);
    for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i]);
    renderer_.set_scissor(std::nullopt);
}

void Gui::draw_list(const ImDrawList& list) const {
    std::vector<engine::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.UserCallback != nullptr || command.ElemCount == 0) continue;
        const ImDrawIdx* const first = list.IdxBuffer.Data + command.IdxOffset;
        const auto [low, high] = std::minmax_element(first, first + command.ElemCount);
        vertices.clear();
        for (unsigned i = *low; i <= *high; ++i) {
            const ImDrawVert& vertex = list.VtxBuffer[static_cast<int>(command.VtxOffset + i)];
            vertices.push_back(
                {{vertex.pos.x, vertex.pos.y}, color_of(vertex.col), {vertex.uv.x, vertex.uv.y}});
        }
        indices.clear();
        for (unsigned i = 0; i < command.ElemCount; ++i)
            indices.push_back(static_cast<std::uint32_t>(first[i] - *low));
        const ImVec4& clip = command.ClipRect;
        renderer_.set_scissor(engine::Rect{clip.x, clip.y, clip.z - clip.x, clip.w - clip.y});
        renderer_.draw_mesh(vertices, indices, font_);
    }
}

}  // namespace cairn::scripting
