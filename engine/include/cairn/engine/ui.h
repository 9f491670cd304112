// Menus: a panel with rows of labels, buttons, toggles, sliders, choices and text fields, used with keys,
// mouse, finger or gamepad alike. Invariant: what a menu does depends only on the events applied and on the
// number of updates, so replays do the same; the focus is on a widget that can be used, whenever there is
// one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/geometry.h>
#include <cairn/engine/input.h>
#include <cairn/engine/renderer.h>

namespace cairn::engine {

enum class WidgetKind {
    Label,      ///< text only
    Button,     ///< does something
    Toggle,     ///< on or off: value 1 or 0
    Slider,     ///< value between low and high, in steps
    Choice,     ///< value counts the choices from 0
    TextField,  ///< entry is what the player has typed
};

struct Widget {
    WidgetKind kind = WidgetKind::Label;
    std::string text;
    bool is_enabled = true;
    bool shares_row = false;  ///< stands beside the widget before it
    double value = 0;
    double low = 0;
    double high = 1;
    double step = 0.1;
    std::vector<std::string> choices;
    std::string entry;
    int max_length = 32;   ///< of the entry, in characters
    float height = 0;      ///< logical pixels that its row has at least; fit_text sets it for labels
    float text_width = 0;  ///< what stands before the track of a slider, logical pixels; fit_text sets it
};

/// What a text would need to be the entry of a field: "at most 5 characters", "no control characters"; empty:
/// nothing more.
std::string missing_of_entry(std::string_view entry, int max_length);

struct UiStyle {
    float width = 420;      ///< logical pixels
    float row_height = 46;  ///< what a finger hits without aiming
    float gap = 8;
    float padding = 20;
    float max_height = 640;  ///< of the panel; more rows than fit are scrolled
    Color panel = {0.10f, 0.12f, 0.16f, 0.94f};
    Color widget = {0.20f, 0.24f, 0.31f, 1};
    Color accent = {0.95f, 0.68f, 0.32f, 1};
    Color text = {0.94f, 0.95f, 0.97f, 1};
};

struct UiEvent {
    enum class Kind {
        Pressed,   ///< a button
        Changed,   ///< a value or an entry
        Cancelled  ///< back: escape, or the gamepad's button at the right
    };
    Kind kind = Kind::Pressed;
    int widget = -1;  ///< place in widgets(); -1 of Cancelled
};

class Ui {
  public:
    Ui(Vec2 center, const UiStyle& style) : center_(center), style_(style) {}

    std::string title;

    /// Gives its place.
    int add(Widget widget);
    void clear();
    const std::vector<Widget>& widgets() const { return widgets_; }
    /// Takes the nearest that the widget can have.
    void set_value(int place, double value);
    /// Of a text that missing_of_entry has nothing to say of.
    void set_entry(int place, std::string entry);
    void set_text(int place, std::string text) { widgets_[place].text = std::move(text); }
    void set_enabled(int place, bool enabled);
    /// Makes rows high enough for a font, the row of a widget for labels that take several lines, and the
    /// tracks of sliders short enough for their texts. To be called for what is new or has another text;
    /// other texts that are too long are shortened where they are drawn.
    void fit_text(const Renderer& renderer, FontId font, int place);
    /// Elsewhere, and no larger than that. Labels need fit_text again, and then scroll_to_focus.
    void fit_into(Vec2 center, float width, float max_height);
    /// Moves the rows, if need be, so that the focus is in sight.
    void scroll_to_focus();
    const UiStyle& style() const { return style_; }

    int focus() const { return focus_; }  ///< -1: none
    /// Of a label or a disabled widget: stays where it is.
    void set_focus(int place);
    /// Whether typed text goes into the field that has the focus.
    bool is_editing() const { return is_editing_; }

    void apply(const InputEvent& event);
    /// Once per update, after its events: directions that are held on a gamepad repeat.
    void update(int updates_per_second = 60);
    /// What happened since the last call, in order.
    std::vector<UiEvent> take_events();

    /// Where a widget is; without area while it is scrolled out of sight.
    Rect area(int place) const;
    Rect panel() const;
    void draw(Renderer& renderer, FontId font) const;

  private:
    struct Direction {
        int x = 0;
        int y = 0;
    };

    struct Row {
        int first;
        int count;
        float top;  ///< below that of the first row
        float height;
    };
    std::vector<Row> rows() const;
    int row_of(const std::vector<Row>& rows, int place) const;
    float row_width() const { return style_.width - 2 * style_.padding; }
    float widget_width(const Row& row) const;
    float title_height() const { return title.empty() ? 0 : style_.row_height; }
    float rows_height() const;
    float scroll_limit() const;
    bool can_focus(int place) const;
    bool has_usable(const Row& row) const;
    void keep_focus();

    int widget_at(Vec2 point) const;
    Rect slider_track(int place) const;
    void move(Direction direction);
    void change(int place, int steps);
    void accept();
    void cancel();
    void assign(int place, double value);
    void press(Vec2 point);
    void drag(Vec2 point);
    void release(Vec2 point);
    void hold(Direction direction);
    void press_key(const InputEvent& event);
    void press_button(GamepadButton button);
    void edit_key(Key key);
    void enter(const std::string& text);

    Vec2 center_;
    UiStyle style_;
    std::vector<Widget> widgets_;
    std::vector<UiEvent> events_;
    int focus_ = -1;
    int pressed_ = -1;  ///< under the mouse button or finger that is down
    bool is_editing_ = false;
    bool skips_blank_ = false;  ///< that the key types which has just opened a field
    float scroll_ = 0;
    Direction held_;  ///< on a gamepad
    Direction stick_;
    int held_updates_ = 0;
};

}  // namespace cairn::engine
