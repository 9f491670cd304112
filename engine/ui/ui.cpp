// The behaviour of menus. Invariant: every change of a widget by the player leaves exactly one event.
#include <algorithm>
#include <cmath>
#include <utility>

#include <cairn/engine/ui.h>
#include <cairn/engine/utf8.h>

namespace cairn::engine {
namespace {

/// In 1/60 s: long enough not to repeat unasked, short enough to run through a list.
constexpr int kRepeatAfter = 24;
constexpr int kRepeatEvery = 7;
constexpr float kStickPress = 0.6f;
constexpr float kStickRelease = 0.4f;

bool contains(const Rect& r, Vec2 p) {
    return p.x >= r.x && p.y >= r.y && p.x < r.x + r.width && p.y < r.y + r.height;
}

bool is_usable(const Widget& widget) {
    return widget.kind != WidgetKind::Label && widget.is_enabled;
}

int character_count(std::string_view text) {
    int count = 0;
    while (!text.empty()) {
        take_character(text);
        ++count;
    }
    return count;
}

bool has_broken_characters(std::string_view text) {
    while (!text.empty()) {
        // What it puts in place of a broken byte has three bytes where it is meant.
        const std::size_t before = text.size();
        if (take_character(text) == 0xfffd && before - text.size() == 1) return true;
    }
    return false;
}

bool has_control_characters(std::string_view text) {
    while (!text.empty()) {
        const char32_t c = take_character(text);
        if (c < 0x20 || (c >= 0x7f && c < 0xa0)) return true;
    }
    return false;
}

void remove_last_character(std::string& text) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
    if (!text.empty()) text.pop_back();
}

/// -1, 0 or 1 with a gap between pressing and releasing.
int stick_direction(float value, int before) {
    const float needed = before == 0 ? kStickPress : kStickRelease;
    if (value >= needed && before >= 0) return 1;
    if (value <= -needed && before <= 0) return -1;
    return std::fabs(value) >= kStickPress ? (value > 0 ? 1 : -1) : 0;
}

}  // namespace

std::string missing_of_entry(std::string_view entry, int max_length) {
    if (has_broken_characters(entry)) return "no bytes that are not UTF-8";
    if (has_control_characters(entry)) return "no control characters";
    if (character_count(entry) <= max_length) return "";
    return "at most " + std::to_string(max_length) + (max_length == 1 ? " character" : " characters");
}

int Ui::add(Widget widget) {
    widgets_.push_back(std::move(widget));
    keep_focus();
    return static_cast<int>(widgets_.size()) - 1;
}

void Ui::clear() {
    widgets_.clear();
    events_.clear();
    focus_ = pressed_ = -1;
    is_editing_ = false;
    scroll_ = 0;
}

void Ui::set_value(int place, double value) {
    Widget& w = widgets_[place];
    if (w.kind == WidgetKind::Choice) {
        w.low = 0;
        w.high = static_cast<double>(w.choices.size()) - 1;
    }
    w.value = std::clamp(value, w.low, std::max(w.low, w.high));
}

void Ui::set_entry(int place, std::string entry) {
    widgets_[place].entry = std::move(entry);
}

void Ui::set_enabled(int place, bool enabled) {
    widgets_[place].is_enabled = enabled;
    keep_focus();
}

// ---- Layout

std::vector<Ui::Row> Ui::rows() const {
    std::vector<Row> rows;
    for (int i = 0; i < static_cast<int>(widgets_.size()); ++i) {
        if (widgets_[i].shares_row && !rows.empty()) {
            ++rows.back().count;
        } else {
            const float top = rows.empty() ? 0 : rows.back().top + rows.back().height + style_.gap;
            rows.push_back({i, 1, top, style_.row_height});
        }
        rows.back().height = std::max(rows.back().height, widgets_[i].height);
    }
    return rows;
}

int Ui::row_of(const std::vector<Row>& rows, int place) const {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (place >= rows[i].first && place < rows[i].first + rows[i].count) return static_cast<int>(i);
    return -1;
}

float Ui::rows_height() const {
    const std::vector<Row> all = rows();
    return all.empty() ? 0 : all.back().top + all.back().height;
}

float Ui::widget_width(const Row& row) const {
    const auto count = static_cast<float>(row.count);
    return (row_width() - (count - 1) * style_.gap) / count;
}

Rect Ui::panel() const {
    const float height = std::min(style_.max_height, rows_height() + title_height() + 2 * style_.padding);
    return {center_.x - 0.5f * style_.width, center_.y - 0.5f * height, style_.width, height};
}

void Ui::fit_into(Vec2 center, float width, float max_height) {
    center_ = center;
    style_.width = width;
    style_.max_height = max_height;
}

float Ui::scroll_limit() const {
    return std::max(0.0f, rows_height() - (panel().height - title_height() - 2 * style_.padding));
}

Rect Ui::area(int place) const {
    const std::vector<Row> all = rows();
    const int index = row_of(all, place);
    if (index < 0) return {};
    const Row& row = all[index];
    const Rect outer = panel();
    const float top = outer.y + style_.padding + title_height();
    const float bottom = outer.y + outer.height - style_.padding;
    const float width = widget_width(row);
    const Rect area = {
        outer.x + style_.padding + static_cast<float>(place - row.first) * (width + style_.gap),
        top + row.top - scroll_, width, row.height};
    const bool is_visible = area.y + area.height > top && area.y < bottom;
    return is_visible ? area : Rect{};
}

void Ui::scroll_to_focus() {
    const std::vector<Row> all = rows();
    int row = row_of(all, focus_);
    if (row < 0) {
        scroll_ = std::clamp(scroll_, 0.0f, scroll_limit());
        return;
    }
    const float bottom = all[row].top + all[row].height;
    const float room = panel().height - title_height() - 2 * style_.padding;
    // What stands above it and cannot have the focus belongs to it, as far as there is room.
    while (row > 0 && !has_usable(all[row - 1]) && bottom - all[row - 1].top <= room) --row;
    const float top = all[row].top;
    scroll_ = std::clamp(scroll_, std::min(bottom - room, top), top);
    scroll_ = std::clamp(scroll_, 0.0f, scroll_limit());
}

// ---- Focus

bool Ui::has_usable(const Row& row) const {
    for (int i = row.first; i < row.first + row.count; ++i)
        if (can_focus(i)) return true;
    return false;
}

bool Ui::can_focus(int place) const {
    return place >= 0 && place < static_cast<int>(widgets_.size()) && is_usable(widgets_[place]);
}

void Ui::keep_focus() {
    if (can_focus(focus_)) return;
    is_editing_ = false;
    focus_ = -1;
    for (int i = 0; i < static_cast<int>(widgets_.size()) && focus_ < 0; ++i)
        if (can_focus(i)) focus_ = i;
}

void Ui::set_focus(int place) {
    if (!can_focus(place) || place == focus_) return;
    focus_ = place;
    is_editing_ = false;
    scroll_to_focus();
}

int Ui::widget_at(Vec2 point) const {
    const Rect outer = panel();
    const Rect inner = {outer.x, outer.y + style_.padding + title_height(), outer.width,
                        outer.height - 2 * style_.padding - title_height()};
    if (!contains(inner, point)) return -1;
    for (int i = 0; i < static_cast<int>(widgets_.size()); ++i)
        if (contains(area(i), point)) return i;
    return -1;
}

// ---- What the player does

void Ui::move(Direction direction) {
    keep_focus();
    if (focus_ < 0 || is_editing_) return;
    const std::vector<Row> all = rows();
    const int here = row_of(all, focus_);
    if (direction.x != 0) {
        const WidgetKind kind = widgets_[focus_].kind;
        if (kind == WidgetKind::Slider || kind == WidgetKind::Choice) return change(focus_, direction.x);
        for (int i = focus_ + direction.x; i >= all[here].first && i < all[here].first + all[here].count;
             i += direction.x)
            if (can_focus(i)) return set_focus(i);
        return;
    }
    // Round the end of the list, to the widget of the next row that has one, as near to this one's column as
    // it can.
    const int count = static_cast<int>(all.size());
    const int column = focus_ - all[here].first;
    for (int step = 1; step <= count; ++step) {
        const Row& row = all[((here + direction.y * step) % count + count) % count];
        int best = -1;
        for (int i = row.first; i < row.first + row.count; ++i)
            if (can_focus(i) &&
                (best < 0 || std::abs(i - row.first - column) < std::abs(best - row.first - column)))
                best = i;
        if (best >= 0) return set_focus(best);
    }
}

void Ui::assign(int place, double value) {
    const double before = widgets_[place].value;
    set_value(place, value);
    if (widgets_[place].value != before) events_.push_back({UiEvent::Kind::Changed, place});
}

void Ui::change(int place, int steps) {
    const Widget& w = widgets_[place];
    if (w.kind == WidgetKind::Choice) {
        const auto count = static_cast<int>(w.choices.size());
        if (count > 0) assign(place, ((static_cast<int>(w.value) + steps) % count + count) % count);
    } else if (w.kind == WidgetKind::Slider) {
        // To the next of the steps, which begin at the low end, whatever the value was and however 0.1
        // rounds.
        constexpr double kRounding = 1e-6;
        const double here = (w.value - w.low) / w.step;
        const double from = steps > 0 ? std::floor(here + kRounding) : std::ceil(here - kRounding);
        assign(place, w.low + (from + steps) * w.step);
    }
}

void Ui::accept() {
    keep_focus();
    if (focus_ < 0) return;
    const Widget& w = widgets_[focus_];
    switch (w.kind) {
        case WidgetKind::Button:
            events_.push_back({UiEvent::Kind::Pressed, focus_});
            break;
        case WidgetKind::Toggle:
            assign(focus_, w.value == 0 ? 1 : 0);
            break;
        case WidgetKind::Choice:
            change(focus_, 1);
            break;
        case WidgetKind::TextField:
            is_editing_ = !is_editing_;
            break;
        case WidgetKind::Slider:
        case WidgetKind::Label:
            break;
    }
}

void Ui::cancel() {
    if (std::exchange(is_editing_, false)) return;
    events_.push_back({UiEvent::Kind::Cancelled, -1});
}

Rect Ui::slider_track(int place) const {
    constexpr float kLeastTrack = 60;
    const Rect r = area(place);
    const float end = r.width - 0.5f * style_.row_height;
    // Half of the row, or less where that leaves the text more room.
    const float wanted = std::min(widgets_[place].text_width, end - kLeastTrack);
    const float start = std::max(0.5f * r.width, wanted);
    return {r.x + start, r.y, end - start, r.height};
}

void Ui::drag(Vec2 point) {
    if (pressed_ < 0 || widgets_[pressed_].kind != WidgetKind::Slider) return;
    const Rect track = slider_track(pressed_);
    const Widget& w = widgets_[pressed_];
    if (!(track.width > 0)) return;
    const double share = std::clamp((point.x - track.x) / track.width, 0.0f, 1.0f);
    // The high end need not be on a step, and can be reached by keys too.
    assign(pressed_, share == 1 ? w.high : w.low + std::round(share * (w.high - w.low) / w.step) * w.step);
}

void Ui::press(Vec2 point) {
    const int place = widget_at(point);
    is_editing_ = false;
    pressed_ = can_focus(place) ? place : -1;
    if (pressed_ < 0) return;
    set_focus(pressed_);
    drag(point);
}

void Ui::release(Vec2 point) {
    const int place = std::exchange(pressed_, -1);
    if (place < 0 || widget_at(point) != place) return;
    // The left half of a choice goes back.
    if (widgets_[place].kind == WidgetKind::Choice) {
        const Rect r = area(place);
        return change(place, point.x < r.x + 0.75f * r.width && point.x >= r.x + 0.5f * r.width ? -1 : 1);
    }
    accept();
}

void Ui::hold(Direction direction) {
    held_ = direction;
    held_updates_ = 0;
    if (direction.x != 0 || direction.y != 0) move(direction);
}

void Ui::edit_key(Key key) {
    std::string& entry = widgets_[focus_].entry;
    if (key == Key::Backspace && !entry.empty()) {
        remove_last_character(entry);
        events_.push_back({UiEvent::Kind::Changed, focus_});
    } else if (key == Key::Return || key == Key::KeypadEnter || key == Key::Escape || key == Key::Tab) {
        is_editing_ = false;
    }
}

void Ui::enter(const std::string& text) {
    if (!is_editing_) return;
    if (std::exchange(skips_blank_, false) && text == " ") return;
    Widget& field = widgets_[focus_];
    if (!missing_of_entry(field.entry + text, field.max_length).empty()) return;
    field.entry += text;
    events_.push_back({UiEvent::Kind::Changed, focus_});
}

void Ui::press_key(const InputEvent& event) {
    if (is_editing_) return edit_key(event.key);
    const Key key = event.key;
    if (key == Key::Up) return move({0, -1});
    if (key == Key::Down || key == Key::Tab) return move({0, 1});
    if (key == Key::Left) return move({-1, 0});
    if (key == Key::Right) return move({1, 0});
    if (event.is_repeat) return;
    if (key == Key::Return || key == Key::KeypadEnter || key == Key::Space) {
        accept();
        skips_blank_ = is_editing_ && key == Key::Space;
        return;
    }
    if (key == Key::Escape) cancel();
}

void Ui::press_button(GamepadButton button) {
    if (button == GamepadButton::DpadUp) hold({0, -1});
    if (button == GamepadButton::DpadDown) hold({0, 1});
    if (button == GamepadButton::DpadLeft) hold({-1, 0});
    if (button == GamepadButton::DpadRight) hold({1, 0});
    if (button == GamepadButton::A) accept();
    if (button == GamepadButton::B) cancel();
}

void Ui::apply(const InputEvent& event) {
    switch (event.kind) {
        case InputKind::KeyPressed:
            return press_key(event);
        case InputKind::TextEntered:
            return enter(event.text);
        case InputKind::MouseMoved:
            if (pressed_ >= 0) return drag(event.position);
            if (const int place = widget_at(event.position); !is_editing_ && can_focus(place))
                set_focus(place);
            return;
        case InputKind::MousePressed:
            if (event.button == MouseButton::Left) press(event.position);
            return;
        case InputKind::MouseReleased:
            if (event.button == MouseButton::Left) release(event.position);
            return;
        case InputKind::WheelMoved:
            scroll_ = std::clamp(scroll_ - event.delta.y * style_.row_height, 0.0f, scroll_limit());
            return;
        case InputKind::GamepadPressed:
            return press_button(event.gamepad_button);
        case InputKind::GamepadReleased:
            if (event.gamepad_button >= GamepadButton::DpadUp) hold({});
            return;
        case InputKind::GamepadMoved: {
            Direction now = stick_;
            if (event.gamepad_axis == GamepadAxis::LeftX) now.x = stick_direction(event.value, stick_.x);
            if (event.gamepad_axis == GamepadAxis::LeftY) now.y = -stick_direction(event.value, -stick_.y);
            const bool is_same = now.x == stick_.x && now.y == stick_.y;
            stick_ = now;
            // One way at a time: up and down before left and right.
            if (!is_same) hold(now.y != 0 ? Direction{0, now.y} : Direction{now.x, 0});
            return;
        }
        case InputKind::GamepadDisconnected:
        case InputKind::FocusLost:
            pressed_ = -1;
            stick_ = {};
            return hold({});
        case InputKind::KeyReleased:
        case InputKind::GamepadConnected:
        case InputKind::TouchPressed:  // the first finger is the mouse
        case InputKind::TouchMoved:
        case InputKind::TouchReleased:
        case InputKind::WindowResized:
        case InputKind::FocusGained:
        case InputKind::QuitRequested:
            return;
    }
}

void Ui::update(int updates_per_second) {
    skips_blank_ = false;  // it comes with its key
    if (held_.x == 0 && held_.y == 0) return;
    ++held_updates_;
    const int after = std::max(1, kRepeatAfter * updates_per_second / 60);
    const int every = std::max(1, kRepeatEvery * updates_per_second / 60);
    if (held_updates_ >= after && (held_updates_ - after) % every == 0) move(held_);
}

std::vector<UiEvent> Ui::take_events() {
    return std::exchange(events_, {});
}

}  // namespace cairn::engine
