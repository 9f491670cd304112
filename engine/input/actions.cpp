// Actions and their sources. Invariant: to_text and input_source_from_text are inverse to each other.
#include <algorithm>

#include <cairn/engine/actions.h>

namespace cairn::engine {
namespace {

constexpr std::string_view kMouse = "mouse_";
constexpr std::string_view kGamepad = "gamepad";

bool is_trigger(GamepadAxis axis) {
    return axis == GamepadAxis::LeftTrigger || axis == GamepadAxis::RightTrigger;
}

Error unknown_source(std::string_view text) {
    return Error{
        "\"" + std::string(text) +
        "\" is no source: expected a key (\"space\"), a mouse button (\"mouse_left\"), a gamepad's button "
        "(\"gamepad_a\", \"gamepad2_start\") or its stick with a direction (\"gamepad_left_x+\")"};
}

float axis_value(const InputSource& source, const Gamepad& pad) {
    return std::max(0.0f, static_cast<float>(source.direction) * pad.axis(source.axis));
}

}  // namespace

float InputSource::value(const InputState& state) const {
    switch (kind) {
        case Kind::Key:
            return state.is_down(key) ? 1.0f : 0.0f;
        case Kind::MouseButton:
            return state.is_down(mouse_button) ? 1.0f : 0.0f;
        case Kind::GamepadButton:
        case Kind::GamepadAxis:
            break;
    }
    float most = 0;
    for (int number = 1; number <= kMaxGamepads; ++number) {
        if (gamepad != 0 && gamepad != number) continue;
        const Gamepad& pad = state.gamepad(number);
        most = std::max(
            most, kind == Kind::GamepadAxis ? axis_value(*this, pad) : (pad.is_down(button) ? 1.0f : 0.0f));
    }
    return most;
}

std::string to_text(const InputSource& source) {
    const std::string pad =
        std::string(kGamepad) + (source.gamepad == 0 ? "" : std::to_string(source.gamepad)) + '_';
    switch (source.kind) {
        case InputSource::Kind::Key:
            return std::string(key_name(source.key));
        case InputSource::Kind::MouseButton:
            return std::string(kMouse) + std::string(mouse_button_name(source.mouse_button));
        case InputSource::Kind::GamepadButton:
            return pad + std::string(gamepad_button_name(source.button));
        case InputSource::Kind::GamepadAxis:
            return pad + std::string(gamepad_axis_name(source.axis)) +
                   (is_trigger(source.axis) ? ""
                    : source.direction > 0  ? "+"
                                            : "-");
    }
    return "";
}

Result<InputSource> input_source_from_text(std::string_view text) {
    InputSource source;
    if (const auto key = key_from_name(text); key && *key != Key::Unknown) {
        source.key = *key;
        return source;
    }
    if (text.starts_with(kMouse)) {
        const auto button = mouse_button_from_name(text.substr(kMouse.size()));
        if (!button) return unknown_source(text);
        source.kind = InputSource::Kind::MouseButton;
        source.mouse_button = *button;
        return source;
    }
    if (!text.starts_with(kGamepad)) return unknown_source(text);
    std::string_view part = text.substr(kGamepad.size());
    if (!part.empty() && part.front() >= '1' && part.front() < '1' + kMaxGamepads) {
        source.gamepad = part.front() - '0';
        part.remove_prefix(1);
    }
    if (part.empty() || part.front() != '_') return unknown_source(text);
    part.remove_prefix(1);
    if (const auto button = gamepad_button_from_name(part)) {
        source.kind = InputSource::Kind::GamepadButton;
        source.button = *button;
        return source;
    }
    const bool has_sign = part.ends_with('+') || part.ends_with('-');
    const auto axis = gamepad_axis_from_name(has_sign ? part.substr(0, part.size() - 1) : part);
    if (!axis || has_sign == is_trigger(*axis)) return unknown_source(text);
    source.kind = InputSource::Kind::GamepadAxis;
    source.axis = *axis;
    source.direction = part.ends_with('-') ? -1 : 1;
    return source;
}

std::optional<InputSource> pressed_source(const InputEvent& event) {
    InputSource source;
    switch (event.kind) {
        case InputKind::KeyPressed:
            if (event.is_repeat) return std::nullopt;
            source.key = event.key;
            return source;
        case InputKind::MousePressed:
            source.kind = InputSource::Kind::MouseButton;
            source.mouse_button = event.button;
            return source;
        case InputKind::GamepadPressed:
            source.kind = InputSource::Kind::GamepadButton;
            source.button = event.gamepad_button;
            return source;
        case InputKind::GamepadMoved:
            if (std::max(event.value, -event.value) < Actions::kPress) return std::nullopt;
            source.kind = InputSource::Kind::GamepadAxis;
            source.axis = event.gamepad_axis;
            source.direction = event.value > 0 ? 1 : -1;
            return source;
        case InputKind::KeyReleased:
        case InputKind::TextEntered:
        case InputKind::MouseMoved:
        case InputKind::MouseReleased:
        case InputKind::WheelMoved:
        case InputKind::GamepadConnected:
        case InputKind::GamepadDisconnected:
        case InputKind::GamepadReleased:
        case InputKind::TouchPressed:
        case InputKind::TouchMoved:
        case InputKind::TouchReleased:
        case InputKind::WindowResized:
        case InputKind::FocusGained:
        case InputKind::FocusLost:
        case InputKind::QuitRequested:
            return std::nullopt;
    }
    return std::nullopt;
}

// ---- Actions

void Actions::bind(std::string_view name, std::vector<InputSource> sources) {
    actions_[std::string(name)] = {.sources = std::move(sources)};
}

const Actions::Action* Actions::find(std::string_view name) const {
    const auto found = actions_.find(name);
    return found == actions_.end() ? nullptr : &found->second;
}

const std::vector<InputSource>* Actions::sources(std::string_view name) const {
    const Action* action = find(name);
    return action ? &action->sources : nullptr;
}

std::vector<std::string> Actions::names() const {
    std::vector<std::string> names;
    for (const auto& [name, action] : actions_) names.push_back(name);
    return names;
}

void Actions::begin_update() {
    for (auto& [name, action] : actions_) action.was_pressed = action.was_released = false;
}

bool Actions::would_be_down(const Action& action, const InputState& state) {
    float most = 0;
    for (const InputSource& source : action.sources) most = std::max(most, source.value(state));
    return most >= (action.is_down ? kRelease : kPress);
}

void Actions::settle(const InputState& state) {
    for (auto& [name, action] : actions_) action.is_down = would_be_down(action, state);
}

std::vector<Actions::Change> Actions::follow(const InputState& state) {
    std::vector<Change> changes;
    for (auto& [name, action] : actions_) {
        const bool is_down = would_be_down(action, state);
        if (is_down == action.is_down) continue;
        action.is_down = is_down;
        (is_down ? action.was_pressed : action.was_released) = true;
        changes.push_back({name, is_down});
    }
    return changes;
}

bool Actions::is_down(std::string_view name) const {
    const Action* action = find(name);
    return action && action->is_down;
}
bool Actions::was_pressed(std::string_view name) const {
    const Action* action = find(name);
    return action && action->was_pressed;
}
bool Actions::was_released(std::string_view name) const {
    const Action* action = find(name);
    return action && action->was_released;
}

float Actions::value(std::string_view name, const InputState& state) const {
    const Action* action = find(name);
    float most = 0;
    if (action)
        for (const InputSource& source : action->sources) most = std::max(most, source.value(state));
    return most;
}

}  // namespace cairn::engine
