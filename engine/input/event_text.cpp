// Input events as lines of text, for recordings that people can read and compare.
// Invariant: input_event_from_text(to_text(e)) is e in every field that e's kind uses; numbers are written
// with the fewest digits that give back the same float.
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include <cairn/engine/input.h>

namespace cairn::engine {
namespace {

constexpr std::array<std::string_view, kInputKindCount> kKindNames = {
    "key_pressed",      "key_released",  "text_entered",      "mouse_moved",          "mouse_pressed",
    "mouse_released",   "wheel_moved",   "gamepad_connected", "gamepad_disconnected", "gamepad_pressed",
    "gamepad_released", "gamepad_moved", "touch_pressed",     "touch_moved",          "touch_released",
    "window_resized",   "focus_gained",  "focus_lost",        "quit_requested",
};

void append(std::string& line, std::string_view word) {
    line.append(" ").append(word);
}

void append(std::string& line, float number) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    append(line, std::string_view(digits.data(), end.ptr));
}

void append(std::string& line, Vec2 v) {
    append(line, v.x);
    append(line, v.y);
}

/// Every byte outside printable ASCII, the space and '%' as %XX, so that a text is one word of one line.
std::string escape(std::string_view text) {
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte > ' ' && byte < 0x7f && c != '%') {
            out += c;
        } else {
            out += '%';
            out += kHex[byte >> 4];
            out += kHex[byte & 15];
        }
    }
    return out;
}

std::optional<std::string> unescape(std::string_view word) {
    std::string out;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (word[i] != '%') {
            out += word[i];
            continue;
        }
        unsigned byte = 0;
        if (i + 2 >= word.size()) return std::nullopt;
        const auto end = std::from_chars(word.data() + i + 1, word.data() + i + 3, byte, 16);
        if (end.ec != std::errc{} || end.ptr != word.data() + i + 3) return std::nullopt;
        out += static_cast<char>(byte);
        i += 2;
    }
    return out;
}

/// Takes the words of a line one by one; the first fault is kept and the rest reads as nothing.
class WordReader {
  public:
    explicit WordReader(std::string_view line) : line_(line), rest_(line) {}

    std::string_view word(std::string_view what) {
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        const std::string_view word = rest_.substr(0, rest_.find(' '));
        rest_.remove_prefix(word.size());
        if (word.empty()) fail("ends before the " + std::string(what));
        return word;
    }

    float number(std::string_view what) {
        const std::string_view text = word(what);
        float value = 0;
        const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = end.ec == std::errc{} && end.ptr == text.data() + text.size();
        if (!whole || !std::isfinite(value)) fail("'" + std::string(text) + "' is not a finite number");
        return value;
    }

    /// A whole number from 1.
    int number_up_to(int most) {
        const std::string_view text = word("number");
        int value = 0;
        const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = end.ec == std::errc{} && end.ptr == text.data() + text.size();
        if (!whole || value < 1 || value > most)
            fail("'" + std::string(text) + "' is not a whole number from 1 to " + std::to_string(most));
        return value;
    }

    Vec2 vector(std::string_view what) {
        const float x = number(what);
        return {x, number(what)};
    }

    template <typename T>
    T named(std::string_view what, std::optional<T> (*find)(std::string_view)) {
        const std::string_view name = word(what);
        const std::optional<T> value = find(name);
        if (!value) fail("there is no " + std::string(what) + " '" + std::string(name) + "'");
        return value.value_or(T{});
    }

    bool at_end() {
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        return rest_.empty();
    }

    std::string_view rest() const { return rest_; }

    void fail(const std::string& reason) {
        if (!error_) error_ = Error{"input event '" + std::string(line_) + "': " + reason};
    }

    const std::optional<Error>& error() const { return error_; }

  private:
    std::string_view line_;
    std::string_view rest_;
    std::optional<Error> error_;
};

std::optional<InputKind> kind_from_name(std::string_view name) {
    for (std::size_t i = 0; i < kKindNames.size(); ++i)
        if (kKindNames[i] == name) return static_cast<InputKind>(i);
    return std::nullopt;
}

}  // namespace

std::string_view input_kind_name(InputKind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}

std::string to_text(const InputEvent& event) {
    std::string line{input_kind_name(event.kind)};
    switch (event.kind) {
        case InputKind::KeyPressed:
            append(line, key_name(event.key));
            if (event.is_repeat) append(line, "repeat");
            break;
        case InputKind::KeyReleased:
            append(line, key_name(event.key));
            break;
        case InputKind::TextEntered:
            append(line, escape(event.text));
            break;
        case InputKind::MousePressed:
        case InputKind::MouseReleased:
            append(line, mouse_button_name(event.button));
            append(line, event.position);
            break;
        case InputKind::MouseMoved:
        case InputKind::WheelMoved:
            append(line, event.position);
            append(line, event.delta);
            break;
        case InputKind::GamepadConnected:
            append(line, std::to_string(event.number));
            append(line, escape(event.text));
            break;
        case InputKind::GamepadDisconnected:
            append(line, std::to_string(event.number));
            break;
        case InputKind::GamepadPressed:
        case InputKind::GamepadReleased:
            append(line, std::to_string(event.number));
            append(line, gamepad_button_name(event.gamepad_button));
            break;
        case InputKind::GamepadMoved:
            append(line, std::to_string(event.number));
            append(line, gamepad_axis_name(event.gamepad_axis));
            append(line, event.value);
            break;
        case InputKind::TouchPressed:
        case InputKind::TouchReleased:
            append(line, std::to_string(event.number));
            append(line, event.position);
            break;
        case InputKind::TouchMoved:
            append(line, std::to_string(event.number));
            append(line, event.position);
            append(line, event.delta);
            break;
        case InputKind::WindowResized:
            append(line, event.delta);
            break;
        case InputKind::FocusGained:
        case InputKind::FocusLost:
        case InputKind::QuitRequested:
            break;
    }
    return line;
}

Result<InputEvent> input_event_from_text(std::string_view line) {
    WordReader words(line);
    InputEvent event;
    event.kind = words.named<InputKind>("kind of event", kind_from_name);
    if (words.error()) return *words.error();
    switch (event.kind) {
        case InputKind::KeyPressed:
        case InputKind::KeyReleased:
            event.key = words.named<Key>("key", key_from_name);
            if (event.kind == InputKind::KeyPressed && !words.at_end()) {
                const std::string_view flag = words.word("flag");
                event.is_repeat = flag == "repeat";
                if (!event.is_repeat) words.fail("expected 'repeat', got '" + std::string(flag) + "'");
            }
            break;
        case InputKind::TextEntered: {
            const std::optional<std::string> text = unescape(words.word("text"));
            if (!text) words.fail("'%' must be followed by two hexadecimal digits");
            event.text = text.value_or("");
            break;
        }
        case InputKind::MousePressed:
        case InputKind::MouseReleased:
            event.button = words.named<MouseButton>("mouse button", mouse_button_from_name);
            event.position = words.vector("position");
            break;
        case InputKind::MouseMoved:
        case InputKind::WheelMoved:
            event.position = words.vector("position");
            event.delta = words.vector("movement");
            break;
        case InputKind::GamepadConnected: {
            event.number = words.number_up_to(kMaxGamepads);
            const std::optional<std::string> name = unescape(words.word("name"));
            if (!name) words.fail("'%' must be followed by two hexadecimal digits");
            event.text = name.value_or("");
            break;
        }
        case InputKind::GamepadDisconnected:
            event.number = words.number_up_to(kMaxGamepads);
            break;
        case InputKind::GamepadPressed:
        case InputKind::GamepadReleased:
            event.number = words.number_up_to(kMaxGamepads);
            event.gamepad_button = words.named<GamepadButton>("gamepad button", gamepad_button_from_name);
            break;
        case InputKind::GamepadMoved:
            event.number = words.number_up_to(kMaxGamepads);
            event.gamepad_axis = words.named<GamepadAxis>("gamepad axis", gamepad_axis_from_name);
            event.value = words.number("value");
            break;
        case InputKind::TouchPressed:
        case InputKind::TouchReleased:
            event.number = words.number_up_to(kMaxTouches);
            event.position = words.vector("position");
            break;
        case InputKind::TouchMoved:
            event.number = words.number_up_to(kMaxTouches);
            event.position = words.vector("position");
            event.delta = words.vector("movement");
            break;
        case InputKind::WindowResized:
            event.delta = words.vector("size");
            break;
        case InputKind::FocusGained:
        case InputKind::FocusLost:
        case InputKind::QuitRequested:
            break;
    }
    if (!words.at_end()) words.fail("unexpected '" + std::string(words.rest()) + "' at the end");
    if (words.error()) return *words.error();
    return event;
}

}  // namespace cairn::engine
