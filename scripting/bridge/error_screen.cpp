// Layout from top to bottom: headline, message, source, calls, keys.
#include "bridge/error_screen.h"

#include <algorithm>

namespace cairn::scripting {
namespace {

using engine::Color;
using engine::Vec2;

constexpr Color kBackground{0.13f, 0.16f, 0.20f, 1};
constexpr Color kPanel{0.10f, 0.12f, 0.15f, 1};
constexpr Color kHeadline{0.95f, 0.76f, 0.46f, 1};
constexpr Color kText{0.92f, 0.93f, 0.94f, 1};
constexpr Color kButton{0.20f, 0.24f, 0.29f, 1};
constexpr Color kQuiet{0.60f, 0.65f, 0.70f, 1};

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        lines.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return lines;
}

/// Tabs have no width that fonts agree on.
std::string without_tabs(const std::string& line) {
    std::string out;
    for (const char c : line) out += c == '\t' ? std::string(4, ' ') : std::string(1, c);
    return out;
}

/// As much of a line as fits into a width, with an ellipsis for the rest.
std::string cut_to_width(const engine::Renderer& renderer, engine::FontId font, std::string text,
                         float width) {
    constexpr std::size_t kLongest = 1024;  // no screen shows more, and generated files have endless lines
    const bool is_too_long = text.size() > kLongest;
    if (is_too_long) text.resize(kLongest);
    if (!is_too_long && renderer.measure_text(font, text).x <= width) return text;
    const auto cut = [&](std::size_t length) {
        while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xc0) == 0x80)
            --length;  // inside UTF-8
        return text.substr(0, length) + "…";
    };
    std::size_t fits = 0;
    std::size_t too_many = text.size();
    while (too_many - fits > 1) {
        const std::size_t middle = fits + (too_many - fits) / 2;
        (renderer.measure_text(font, cut(middle)).x <= width ? fits : too_many) = middle;
    }
    return cut(fits);
}

struct Button {
    ErrorChoice choice;
    const char* label;
};
constexpr Button kButtons[] = {{ErrorChoice::TryAgain, "R: try again"},
                               {ErrorChoice::Copy, "C: copy the message"},
                               {ErrorChoice::Quit, "Esc: quit"}};

engine::Rect area_of(std::size_t button, engine::Size screen) {
    const auto width = static_cast<float>(screen.width);
    const auto height = static_cast<float>(screen.height);
    const float margin = width / 16;
    const float gap = width / 64;
    const float wide = (width - 2 * margin - 2 * gap) / 3;
    return {margin + static_cast<float>(button) * (wide + gap), height - height / 9, wide, height / 14};
}

/// Writes lines one below the other.
class Column {
  public:
    Column(engine::Renderer& renderer, engine::FontId font, float x, float y, float width)
        : renderer_(renderer), font_(font), x_(x), y_(y), width_(width) {}

    void write(const std::string& text, Color color) {
        renderer_.draw_text(font_, text, {.position = {x_, y_}, .color = color, .wrap_width = width_});
        y_ += std::max(renderer_.measure_text(font_, text, width_).y, renderer_.line_height(font_));
    }
    void skip(float height) { y_ += height; }
    [[nodiscard]] float y() const { return y_; }
    void use(engine::FontId font) { font_ = font; }

  private:
    engine::Renderer& renderer_;
    engine::FontId font_;
    float x_;
    float y_;
    float width_;
};

}  // namespace

ErrorScreen make_error_screen(const ScriptError& error, const engine::Files& files) {
    constexpr int kLinesAround = 3;
    ErrorScreen screen{error, {}};
    const auto place = place_of(error.message);
    if (!place) return screen;
    std::string text = error.source;
    if (text.empty()) {
        auto read = files.read_text(place->file);
        if (!read) return screen;
        text = *std::move(read);
    }
    const std::vector<std::string> lines = split_lines(text);
    const int last = std::min(place->line + kLinesAround, static_cast<int>(lines.size()));
    for (int line = std::max(1, place->line - kLinesAround); line <= last; ++line) {
        const std::string& source = lines[static_cast<std::size_t>(line - 1)];
        screen.excerpt.push_back({line, without_tabs(source), line == place->line});
    }
    return screen;
}

ErrorChoice choice_of(const engine::InputEvent& event, engine::Size screen) {
    using engine::GamepadButton;
    using engine::InputKind;
    using engine::Key;
    if (event.kind == InputKind::QuitRequested) return ErrorChoice::Quit;
    if (event.kind == InputKind::KeyPressed) {
        if (event.key == Key::Escape) return ErrorChoice::Quit;
        if (event.key == Key::R || event.key == Key::F5) return ErrorChoice::TryAgain;
        if (event.key == Key::C) return ErrorChoice::Copy;
    }
    if (event.kind == InputKind::GamepadPressed) {
        const GamepadButton button = event.gamepad_button;
        if (button == GamepadButton::B || button == GamepadButton::Back) return ErrorChoice::Quit;
        if (button == GamepadButton::A || button == GamepadButton::Start) return ErrorChoice::TryAgain;
        if (button == GamepadButton::X) return ErrorChoice::Copy;
    }
    // The first finger is the mouse too.
    if (event.kind == InputKind::MousePressed) {
        for (std::size_t i = 0; i < std::size(kButtons); ++i) {
            const engine::Rect area = area_of(i, screen);
            const Vec2 p = event.position - Vec2{area.x, area.y};
            if (p.x >= 0 && p.x < area.width && p.y >= 0 && p.y < area.height) return kButtons[i].choice;
        }
    }
    return ErrorChoice::None;
}

void draw_error_screen(const ErrorScreen& screen, engine::Renderer& renderer) {
    const auto width = static_cast<float>(renderer.logical_size().width);
    const auto height = static_cast<float>(renderer.logical_size().height);
    const auto large = renderer.load_font("fonts/default.ttf", std::max(14.0f, height / 24));
    const auto small = renderer.load_font("fonts/default.ttf", std::max(10.0f, height / 40));
    renderer.reset_transform();
    renderer.fill_rectangle({0, 0, width, height}, kBackground);
    if (!large || !small) return;  // without a font the message is on standard error only

    const float margin = width / 16;
    Column column(renderer, *large, margin, height / 14, width - 2 * margin);
    column.write("The game stopped", kHeadline);
    column.skip(height / 60);
    column.use(*small);
    column.write(screen.error.message, kText);
    column.skip(height / 40);
    if (!screen.excerpt.empty()) {
        const float line = renderer.line_height(*small);
        const float padding = line / 2;
        renderer.fill_rectangle({margin - padding, column.y() - padding, width - 2 * (margin - padding),
                                 line * static_cast<float>(screen.excerpt.size()) + 2 * padding},
                                kPanel);
        const float number_width = renderer.measure_text(*small, "00000").x;
        for (const SourceLine& source : screen.excerpt) {
            const Color color = source.is_faulty ? kHeadline : kQuiet;
            if (source.is_faulty)
                renderer.fill_rectangle({margin - padding, column.y(), padding / 2, line}, kHeadline);
            renderer.draw_text(*small, std::to_string(source.number),
                               {.position = {margin + number_width, column.y()},
                                .color = color,
                                .align = engine::TextAlign::Right});
            const float left = margin + number_width + line;
            renderer.draw_text(*small, cut_to_width(renderer, *small, source.text, width - margin - left),
                               {.position = {left, column.y()}, .color = color});
            column.skip(line);
        }
        column.skip(height / 40 + padding);
    }
    const float bottom = area_of(0, renderer.logical_size()).y;
    for (const std::string& call : screen.error.traceback) {
        if (column.y() > bottom - renderer.line_height(*small)) break;
        column.write(call, kQuiet);
    }
    for (std::size_t i = 0; i < std::size(kButtons); ++i) {
        const engine::Rect area = area_of(i, renderer.logical_size());
        const bool is_done = kButtons[i].choice == ErrorChoice::Copy && screen.was_copied;
        renderer.fill_rectangle(area, kButton);
        renderer.draw_text(
            *small, is_done ? "copied" : kButtons[i].label,
            {.position = {area.x + area.width / 2, area.y + (area.height - renderer.line_height(*small)) / 2},
             .color = kText,
             .align = engine::TextAlign::Center});
    }
}

}  // namespace cairn::scripting
