// The look of menus. Invariant: drawing changes nothing but the picture; scissor and transform are as before.
#include <algorithm>
#include <cmath>

#include <cairn/engine/ui.h>

#include "ui/shortened_text.h"
#include "ui/slider_number.h"

namespace cairn::engine {
namespace {

constexpr float kCornerRadius = 10;

std::vector<Vec2> rounded(const Rect& r, float radius) {
    constexpr int kSteps = 8;
    constexpr float kQuarterTurn = 1.57079633f;
    const float c = std::min(radius, 0.5f * std::min(r.width, r.height));
    const Vec2 centers[] = {{r.x + r.width - c, r.y + r.height - c},
                            {r.x + c, r.y + r.height - c},
                            {r.x + c, r.y + c},
                            {r.x + r.width - c, r.y + c}};
    std::vector<Vec2> points;
    for (int corner = 0; corner < 4; ++corner)
        for (int step = 0; step <= kSteps; ++step) {
            const float angle =
                (static_cast<float>(corner) + static_cast<float>(step) / kSteps) * kQuarterTurn;
            points.push_back(centers[corner] + Vec2{std::cos(angle), std::sin(angle)} * c);
        }
    return points;
}

Color faded(Color color, float factor) {
    color.a *= factor;
    return color;
}

Color mixed(Color a, Color b, float share) {
    return {a.r + (b.r - a.r) * share, a.g + (b.g - a.g) * share, a.b + (b.b - a.b) * share,
            a.a + (b.a - a.a) * share};
}

/// Draws one widget; the functions share what is the same for all of them.
class Painter {
  public:
    Painter(Renderer& renderer, FontId font, const UiStyle& style)
        : renderer_(renderer), font_(font), style_(style), line_(renderer.line_height(font)) {}

    /// One line, shortened to what fits.
    void text(const std::string& text, const Rect& in, TextAlign align, Color color,
              KeptEnd kept = KeptEnd::Front) {
        float x = in.x;
        if (align == TextAlign::Center) x += 0.5f * in.width;
        if (align == TextAlign::Right) x += in.width;
        renderer_.draw_text(
            font_, shortened_text(renderer_, font_, text, in.width, kept),
            {.position = {x, in.y + 0.5f * (in.height - line_)}, .color = color, .align = align});
    }

    /// As many lines as it takes; Ui::fit_text has made room for them.
    void paragraph(const std::string& text, const Rect& in, Color color) {
        const float height = renderer_.measure_text(font_, text, in.width).y;
        renderer_.draw_text(font_, text,
                            {.position = {in.x, in.y + 0.5f * (in.height - height)},
                             .color = color,
                             .align = TextAlign::Center,
                             .wrap_width = in.width});
    }

    void widget(const Widget& w, const Rect& r, const Rect& track, bool is_focused, bool is_pressed,
                bool is_editing) {
        const Color text_color = faded(style_.text, w.is_enabled ? 1 : 0.4f);
        if (w.kind == WidgetKind::Label) return paragraph(w.text, r, faded(style_.text, 0.75f));
        Color fill =
            is_focused ? mixed(style_.widget, style_.accent, is_pressed ? 0.45f : 0.2f) : style_.widget;
        if (!w.is_enabled) fill = faded(fill, 0.5f);
        renderer_.fill_convex_polygon(rounded(r, kCornerRadius), fill);
        if (is_focused) renderer_.outline_polygon(rounded(r, kCornerRadius), 2, style_.accent);
        const float margin = style_.text_margin();
        const Rect inner = {r.x + margin, r.y, r.width - 2 * margin, r.height};
        const Rect right = {track.x, r.y, inner.x + inner.width - track.x, r.height};
        const Rect left = {inner.x, r.y, track.x - kTextGap - inner.x, r.height};
        switch (w.kind) {
            case WidgetKind::Button:
                return text(w.text, inner, TextAlign::Center, text_color);
            case WidgetKind::Toggle: {
                const Rect knob = toggle(w, inner);
                return text(w.text, {inner.x, r.y, knob.x - kTextGap - inner.x, r.height}, TextAlign::Left,
                            text_color);
            }
            case WidgetKind::Slider: {
                const float taken = slider(w, track, left.width);
                return text(w.text, {left.x, r.y, left.width - taken, r.height}, TextAlign::Left, text_color);
            }
            case WidgetKind::Choice: {
                text(w.text, left, TextAlign::Left, text_color);
                arrow({right.x + 6, r.y + 0.5f * r.height}, -1);
                arrow({right.x + right.width - 6, r.y + 0.5f * r.height}, 1);
                constexpr float kArrow = 6 + 9 + 4;
                if (!w.choices.empty())
                    text(w.choices[static_cast<std::size_t>(w.value)],
                         {right.x + kArrow, r.y, right.width - 2 * kArrow, r.height}, TextAlign::Center,
                         style_.accent);
                return;
            }
            case WidgetKind::TextField:
                text(w.text, left, TextAlign::Left, text_color);
                return text(w.entry + (is_editing ? "|" : ""), right, TextAlign::Right, style_.accent,
                            KeptEnd::Back);
            case WidgetKind::Label:
                return;
        }
    }

  private:
    /// Gives where it is.
    Rect toggle(const Widget& w, const Rect& inner) {
        const float height = 0.5f * style_.row_height;
        const Rect r = {inner.x + inner.width - 1.8f * height, inner.y + 0.5f * (inner.height - height),
                        1.8f * height, height};
        const bool is_on = w.value != 0;
        renderer_.fill_convex_polygon(rounded(r, height), is_on ? style_.accent : faded(style_.text, 0.25f));
        const float x = is_on ? r.x + r.width - 0.5f * height : r.x + 0.5f * height;
        renderer_.fill_circle({x, r.y + 0.5f * height}, 0.38f * height, style_.text);
        return r;
    }

    /// Gives how much of the place before its track its number takes, which is no more than `room`.
    float slider(const Widget& w, const Rect& track, float room) {
        const float y = track.y + 0.5f * track.height;
        const auto share = static_cast<float>(w.high > w.low ? (w.value - w.low) / (w.high - w.low) : 0);
        const Vec2 left = {track.x, y};
        const Vec2 knob = {track.x + share * track.width, y};
        renderer_.draw_line(left, {track.x + track.width, y}, 6, faded(style_.text, 0.25f));
        if (share > 0) renderer_.draw_line(left, knob, 6, style_.accent);
        renderer_.fill_circle(knob, 0.2f * style_.row_height, style_.text);
        const float width = std::min(room, number_width(renderer_, font_, w));
        text(number_text(w.value, w.step), {track.x - kTextGap - width, track.y, width, track.height},
             TextAlign::Right, faded(style_.text, 0.75f));
        return width + kTextGap;
    }

    void arrow(Vec2 tip, int direction) {
        const float d = static_cast<float>(direction);
        const Vec2 points[] = {tip, tip + Vec2{-9 * d, -8}, tip + Vec2{-9 * d, 8}};
        renderer_.fill_convex_polygon(points, faded(style_.text, 0.6f));
    }

    Renderer& renderer_;
    FontId font_;
    const UiStyle& style_;
    float line_;
};

}  // namespace

void Ui::draw(Renderer& renderer, FontId font) const {
    const Rect outer = panel();
    renderer.fill_convex_polygon(rounded(outer, 1.6f * kCornerRadius), style_.panel);
    Painter painter(renderer, font, style_);
    const Rect head = {outer.x + style_.padding, outer.y + 0.5f * style_.padding, row_width(),
                       style_.row_height};
    if (!title.empty()) painter.text(title, head, TextAlign::Center, style_.accent);

    const std::optional<Rect> scissor = renderer.scissor();
    const float limit = scroll_limit();
    const Rect inside = {outer.x, outer.y + style_.padding + title_height() - 2, outer.width,
                         outer.height - 2 * style_.padding - title_height() + 4};
    if (limit > 0) renderer.set_scissor(inside);
    for (int i = 0; i < static_cast<int>(widgets_.size()); ++i) {
        const Rect r = area(i);
        if (r.width > 0)
            painter.widget(widgets_[i], r, slider_track(i), i == focus_, i == pressed_,
                           i == focus_ && is_editing_);
    }
    if (limit > 0) {
        // How much of the list is seen, and which part.
        const float share = inside.height / (inside.height + limit);
        const float top = inside.y + scroll_ / limit * (1 - share) * inside.height;
        renderer.draw_line({outer.x + outer.width - 8, top},
                           {outer.x + outer.width - 8, top + share * inside.height}, 4,
                           faded(style_.text, 0.3f));
        renderer.set_scissor(scissor);
    }
}

}  // namespace cairn::engine
