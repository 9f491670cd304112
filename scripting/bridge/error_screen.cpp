// Layout from top to bottom: headline, message, source, calls, keys.
#include "bridge/error_screen.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

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

/// What the message says about the place in a line: a column, "FILE:LINE:COLUMN: ", or else a word in quotes
/// that the line has, "(field 'aim')". Otherwise its beginning.
std::size_t focus_of(const std::string& message, const ScriptPlace& place, const std::string& line) {
    const std::string start = place.file + ':' + std::to_string(place.line) + ':';
    const long column = std::strtol(message.c_str() + std::min(start.size(), message.size()), nullptr, 10);
    if (column > 0) return std::min(static_cast<std::size_t>(column - 1), line.size());
    for (std::size_t open = message.find_first_of("'\""); open != std::string::npos;) {
        const std::size_t close = message.find(message[open], open + 1);
        if (close == std::string::npos) break;
        const std::size_t found = line.find(message.substr(open + 1, close - open - 1));
        if (close > open + 1 && found != std::string::npos) return found;
        open = message.find_first_of("'\"", close + 1);
    }
    return 0;
}

/// The nearest place before, that is none inside of a character of UTF-8.
std::size_t character_start(const std::string& text, std::size_t at) {
    while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) --at;
    return at;
}

/// The panel with the lines of source.
class SourcePanel {
  public:
    SourcePanel(const engine::Renderer& renderer, engine::FontId font, float width)
        : renderer_(renderer), font_(font), width_(width) {}

    /// What is shown of a line: as much as fits beside its number. Of the faulty one as much as fits below
    /// too, and what is around its fault if that is not all.
    [[nodiscard]] std::string shown(const SourceLine& line) const {
        constexpr std::size_t kBefore = 160;  // two rows or so
        std::string beginning = cut(line.text, line.is_faulty);
        if (!line.is_faulty || line.focus <= kBefore || beginning == line.text) return beginning;
        return cut("…" + line.text.substr(character_start(line.text, line.focus - kBefore)), true);
    }

    [[nodiscard]] float height(const std::string& text) const {
        return std::max(renderer_.measure_text(font_, text, width_).y, renderer_.line_height(font_));
    }

  private:
    static constexpr std::size_t kLongest =
        1024;                              // no screen shows more, and generated files have endless lines
    static constexpr float kMostRows = 6;  // which leave room for the calls

    [[nodiscard]] bool fits(const std::string& text, bool is_wrapped) const {
        if (!is_wrapped) return renderer_.measure_text(font_, text).x <= width_;
        return height(text) < (kMostRows + 0.5f) * renderer_.line_height(font_);
    }

    /// The beginning that fits, with an ellipsis for the rest.
    [[nodiscard]] std::string cut(std::string text, bool is_wrapped) const {
        const bool is_too_long = text.size() > kLongest;
        if (is_too_long) text.resize(kLongest);
        if (!is_too_long && fits(text, is_wrapped)) return text;
        const auto beginning = [&](std::size_t length) {
            return text.substr(0, character_start(text, length)) + "…";
        };
        std::size_t enough = 0;
        std::size_t too_many = text.size();
        while (too_many - enough > 1) {
            const std::size_t middle = enough + (too_many - enough) / 2;
            (fits(beginning(middle), is_wrapped) ? enough : too_many) = middle;
        }
        return beginning(enough);
    }

    const engine::Renderer& renderer_;
    engine::FontId font_;
    float width_;
};

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
        SourceLine shown{line, without_tabs(source), line == place->line};
        if (shown.is_faulty)
            shown.focus = without_tabs(source.substr(0, focus_of(error.message, *place, source))).size();
        screen.excerpt.push_back(std::move(shown));
    }
    return screen;
}

namespace {

void draw_excerpt(const std::vector<SourceLine>& excerpt, engine::Renderer& renderer, engine::FontId font,
                  Column& column) {
    const auto width = static_cast<float>(renderer.logical_size().width);
    const float margin = width / 16;
    const float line = renderer.line_height(font);
    const float padding = line / 2;
    const float number_width = renderer.measure_text(font, "00000").x;
    const float left = margin + number_width + line;
    const float text_width = width - margin - left;
    const SourcePanel panel(renderer, font, text_width);
    std::vector<std::string> texts;
    float height = 0;
    for (const SourceLine& source : excerpt) {
        texts.push_back(panel.shown(source));
        height += panel.height(texts.back());
    }
    renderer.fill_rectangle(
        {margin - padding, column.y() - padding, width - 2 * (margin - padding), height + 2 * padding},
        kPanel);
    for (std::size_t i = 0; i < excerpt.size(); ++i) {
        const SourceLine& source = excerpt[i];
        const Color color = source.is_faulty ? kHeadline : kQuiet;
        const float rows = panel.height(texts[i]);
        if (source.is_faulty)
            renderer.fill_rectangle({margin - padding, column.y(), padding / 2, rows}, kHeadline);
        renderer.draw_text(font, std::to_string(source.number),
                           {.position = {margin + number_width, column.y()},
                            .color = color,
                            .align = engine::TextAlign::Right});
        renderer.draw_text(font, texts[i],
                           {.position = {left, column.y()}, .color = color, .wrap_width = text_width});
        column.skip(rows);
    }
    column.skip(static_cast<float>(renderer.logical_size().height) / 40 + padding);
}

}  // namespace

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
    if (!screen.excerpt.empty()) draw_excerpt(screen.excerpt, renderer, *small, column);
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
