// cairn.ui and the methods of Ui. Invariant: what the author gave for a widget is called once for each thing
// that the player does to it, from ui:update and from nowhere else.
#include <algorithm>
#include <cmath>

#include <cairn/engine/ui.h>

#include "bind/context.h"
#include "bind/fields.h"
#include "bind/graphics_objects.h"
#include "bind/modules.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using engine::Widget;
using engine::WidgetKind;

/// User value 1 is a table, number of the widget -> function; at 0 what is called for back.
struct UiObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Ui;
    engine::Ui ui;
    engine::FontId font;
    std::optional<double> x;  ///< of the middle, as the author said
    std::optional<double> y;
    float width;  ///< as the author said: no more than the screen has is taken
    float max_height;
    engine::Size screen{};    ///< for which it is laid out
    std::uint64_t frame = 0;  ///< of the last update
};

}  // namespace

template <>
struct Argument<UiObject*> {
    static constexpr std::string_view kType = "Ui";
    static UiObject* get(lua_State* L, int index) {
        auto* ui = object_at<UiObject>(L, index);
        if (ui == nullptr) argument_error(L, index, "a Ui");
        return ui;
    }
};

namespace {

/// More rows than anybody scrolls through.
constexpr std::size_t kMaxWidgets = 1000;

constexpr Field kX = optional_field(
    "x", FieldType::Number, "px; the panel's middle; absent: that of the screen, also when its size changes");
constexpr Field kY = optional_field("y", FieldType::Number, "px");
constexpr Field kWidth = above(number_field("width", 420, "420", "px"), 40, 8192);
constexpr Field kMaxHeight = above(
    number_field("max_height", 640, "640", "px of the panel; what does not fit is scrolled"), 100, 8192);
constexpr Field kRowHeight =
    above(number_field("row_height", 46, "46", "px; less is hard to hit with a finger"), 10, 400);
constexpr Field kFontSize = within(number_field("font_size", 20, "20", "px"), 4, 256);
constexpr Field kTitle{"title", FieldType::String, "", "above the rows"};
constexpr Field kAccent =
    optional_field("accent", FieldType::Table, "{r, g, b}: of the title, the focus and values");
constexpr Field kBack =
    optional_field("back", FieldType::Function, "called for escape and the gamepad's \"b\"");
constexpr const Field* kUiOwn[] = {&kX,        &kY,     &kWidth,  &kMaxHeight, &kRowHeight,
                                   &kFontSize, &kTitle, &kAccent, &kBack};
constexpr FieldSet kUiFields{kUiOwn};

constexpr Field kText{"text", FieldType::String, "", "what stands on it"};
constexpr Field kEnabled = boolean_field("enabled", true, "whether it can be used");
constexpr Field kSameRow = boolean_field("same_row", false, "stands beside the widget before it");
constexpr Field kAction = optional_field("action", FieldType::Function, "called when it is pressed");
constexpr Field kToggleValue = boolean_field("value", false, "");
constexpr Field kToggleChanged = optional_field("changed", FieldType::Function, "called with true or false");
constexpr Field kLow = number_field("low", 0, "0", "");
constexpr Field kHigh = number_field("high", 1, "1", "above low");
constexpr Field kStep =
    above(number_field("step", 0.1, "0.1", "what one press changes; steps begin at low"), 0);
constexpr Field kSliderValue =
    optional_field("value", FieldType::Number, "from low to high; absent: 0, or the end next to it");
constexpr Field kSliderChanged = optional_field("changed", FieldType::Function, "called with the number");
constexpr Field kChoices = required_field("choices", FieldType::Table, "a list of strings");
constexpr Field kChoiceValue = integer_field("value", 1, "1", "counts from 1");
constexpr Field kChoiceChanged =
    optional_field("changed", FieldType::Function, "called with the number and the string");
constexpr Field kEntry{"value", FieldType::String, "", "at most max_length characters"};
constexpr Field kMaxLength = within(integer_field("max_length", 32, "32", "characters"), 1, 1000);
constexpr Field kEntryChanged = optional_field("changed", FieldType::Function, "called with the text");

constexpr const Field* kCommonOwn[] = {&kText, &kEnabled, &kSameRow};
constexpr FieldSet kCommonFields{kCommonOwn};
constexpr const Field* kLabelOwn[] = {&kText, &kSameRow};
constexpr FieldSet kLabelFields{kLabelOwn};
constexpr const Field* kButtonOwn[] = {&kAction};
constexpr FieldSet kButtonFields{kButtonOwn, {&kCommonFields}};
constexpr const Field* kToggleOwn[] = {&kToggleValue, &kToggleChanged};
constexpr FieldSet kToggleFields{kToggleOwn, {&kCommonFields}};
constexpr const Field* kSliderOwn[] = {&kSliderValue, &kLow, &kHigh, &kStep, &kSliderChanged};
constexpr FieldSet kSliderFields{kSliderOwn, {&kCommonFields}};
constexpr const Field* kChoiceOwn[] = {&kChoices, &kChoiceValue, &kChoiceChanged};
constexpr FieldSet kChoiceFields{kChoiceOwn, {&kCommonFields}};
constexpr const Field* kTextOwn[] = {&kEntry, &kMaxLength, &kEntryChanged};
constexpr FieldSet kTextFields{kTextOwn, {&kCommonFields}};

/// Puts the function on top of the stack, which is popped, behind a widget of the Ui at an index.
void keep_function(lua_State* L, int ui_index, lua_Integer number) {
    lua_getiuservalue(L, ui_index, 1);
    lua_insert(L, -2);
    lua_rawseti(L, -2, number);
    lua_pop(L, 1);
}

/// Lays it out for the screen as it is now.
void follow_screen(lua_State* L, UiObject& self) {
    const Services& services = context_of(L).services;
    const engine::Size screen = services.window.logical_size();
    if (self.screen == screen) return;
    self.screen = screen;
    const engine::Vec2 center = {static_cast<float>(self.x.value_or(0.5 * screen.width)),
                                 static_cast<float>(self.y.value_or(0.5 * screen.height))};
    self.ui.fit_into(center, std::min(self.width, static_cast<float>(screen.width)),
                     std::min(self.max_height, static_cast<float>(screen.height)));
    for (int place = 0; place < static_cast<int>(self.ui.widgets().size()); ++place)
        self.ui.fit_text(services.renderer, self.font, place);
    self.ui.scroll_to_focus();
}

Pushed new_ui(lua_State* L, std::optional<TableArgument> fields) {
    if (!fields) lua_newtable(L);
    const FieldReader reader(L, fields ? fields->index : -1, kUiFields);
    const Services& services = context_of(L).services;
    engine::UiStyle style;
    style.row_height = reader.real(kRowHeight);
    if (reader.push(kAccent)) {
        float* const parts[] = {&style.accent.r, &style.accent.g, &style.accent.b};
        for (int i = 0; i < 3; ++i) {
            if (lua_rawgeti(L, -1, i + 1) != LUA_TNUMBER)
                reader.fail(kAccent, "must be {r, g, b}, numbers from 0 to 1");
            *parts[i] = static_cast<float>(lua_tonumber(L, -1));
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
    }
    const std::optional<double> x = reader.optional_number(kX);
    const std::optional<double> y = reader.optional_number(kY);
    const float width = reader.real(kWidth);
    const float max_height = reader.real(kMaxHeight);
    const std::string title(reader.text(kTitle));
    const engine::FontId font =
        value_or_raise(L, services.renderer.load_font("fonts/default.ttf", reader.real(kFontSize)));
    const bool has_back = reader.push(kBack);
    auto& made = new_object<UiObject>(L, 1, engine::Ui({}, style), font, x, y, width, max_height);
    made.ui.title = title;
    follow_screen(L, made);
    lua_newtable(L);
    lua_setiuservalue(L, -2, 1);
    if (has_back) {
        lua_insert(L, -2);
        keep_function(L, lua_gettop(L) - 1, 0);
    }
    return {1};
}

// ---- Widgets. The Ui stands at index 1, as the receiver does.

Widget common(const FieldReader& reader, WidgetKind kind) {
    Widget widget;
    widget.kind = kind;
    widget.text = reader.text(kText);
    widget.is_enabled = reader.boolean(kEnabled);
    widget.shares_row = reader.boolean(kSameRow);
    return widget;
}

void fit_text(lua_State* L, UiObject& self, int place) {
    self.ui.fit_text(context_of(L).services.renderer, self.font, place);
}

std::int64_t add(lua_State* L, UiObject& self, Widget widget, const FieldReader& reader,
                 const Field* function) {
    if (self.ui.widgets().size() >= kMaxWidgets)
        call_error(L, std::to_string(kMaxWidgets) + " widgets are there already; is a clear missing?");
    const double value = widget.value;
    const int place = self.ui.add(std::move(widget));
    fit_text(L, self, place);
    self.ui.set_value(place, value);
    if (function != nullptr && reader.push(*function)) keep_function(L, 1, place + 1);
    return place + 1;
}

std::int64_t add_label(lua_State* L, UiObject* self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kLabelFields);
    Widget widget;
    widget.text = reader.text(kText);
    widget.shares_row = reader.boolean(kSameRow);
    return add(L, *self, std::move(widget), reader, nullptr);
}
std::int64_t add_button(lua_State* L, UiObject* self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kButtonFields);
    return add(L, *self, common(reader, WidgetKind::Button), reader, &kAction);
}
std::int64_t add_toggle(lua_State* L, UiObject* self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kToggleFields);
    Widget widget = common(reader, WidgetKind::Toggle);
    widget.value = reader.boolean(kToggleValue) ? 1 : 0;
    return add(L, *self, std::move(widget), reader, &kToggleChanged);
}
/// "from 0 to 1".
std::string slider_rule(const Widget& slider) {
    char text[80];
    std::snprintf(text, sizeof text, "from %.7g to %.7g", slider.low, slider.high);
    return text;
}

std::int64_t add_slider(lua_State* L, UiObject* self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kSliderFields);
    Widget widget = common(reader, WidgetKind::Slider);
    widget.low = reader.number(kLow);
    widget.high = reader.number(kHigh);
    widget.step = reader.number(kStep);
    if (!(widget.high > widget.low)) reader.fail(kHigh, "must be above low");
    const auto value = reader.optional_number(kSliderValue);
    if (value && !(*value >= widget.low && *value <= widget.high))
        reader.fail(kSliderValue, "must be " + slider_rule(widget));
    widget.value = value.value_or(std::clamp(0.0, widget.low, widget.high));
    return add(L, *self, std::move(widget), reader, &kSliderChanged);
}
std::int64_t add_choice(lua_State* L, UiObject* self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kChoiceFields);
    Widget widget = common(reader, WidgetKind::Choice);
    reader.push(kChoices);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
        if (lua_rawgeti(L, -1, i) != LUA_TSTRING)
            call_error(
                L, "choices[" + std::to_string(i) + "] is " + describe_value(L, -1) + "; expected a string");
        widget.choices.emplace_back(lua_tostring(L, -1));
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    if (widget.choices.empty()) reader.fail(kChoices, "must not be empty");
    const std::int64_t value = reader.integer(kChoiceValue);
    if (value < 1 || value > count) reader.fail(kChoiceValue, "must be from 1 to " + std::to_string(count));
    widget.value = static_cast<double>(value - 1);
    return add(L, *self, std::move(widget), reader, &kChoiceChanged);
}
std::int64_t add_text(lua_State* L, UiObject* self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kTextFields);
    Widget widget = common(reader, WidgetKind::TextField);
    widget.entry = reader.text(kEntry);
    widget.max_length = static_cast<int>(reader.integer(kMaxLength));
    if (const std::string missing = engine::missing_of_entry(widget.entry, widget.max_length);
        !missing.empty())
        reader.fail(kEntry, "must have " + missing);
    return add(L, *self, std::move(widget), reader, &kEntryChanged);
}

// ---- What they are and become

int to_place(lua_State* L, const UiObject& self, std::int64_t number) {
    const auto count = static_cast<std::int64_t>(self.ui.widgets().size());
    if (number < 1 || number > count) argument_error(L, 2, "a widget, from 1 to " + std::to_string(count));
    return static_cast<int>(number - 1);
}

/// `widget 3 "Volume"`, for messages.
std::string widget_name(int place, const Widget& widget) {
    return "widget " + std::to_string(place + 1) + ' ' + quote_text(widget.text);
}

/// Pushes what a widget is set to, as its `changed` gets it, and gives the number of values.
int push_widget_value(lua_State* L, const Widget& widget) {
    switch (widget.kind) {
        case WidgetKind::Label:
        case WidgetKind::Button:
            return 0;
        case WidgetKind::Toggle:
            lua_pushboolean(L, widget.value != 0 ? 1 : 0);
            return 1;
        case WidgetKind::Slider:
            lua_pushnumber(L, widget.value);
            return 1;
        case WidgetKind::Choice: {
            const std::string& text = widget.choices[static_cast<std::size_t>(widget.value)];
            lua_pushinteger(L, static_cast<lua_Integer>(widget.value) + 1);
            lua_pushlstring(L, text.data(), text.size());
            return 2;
        }
        case WidgetKind::TextField:
            lua_pushlstring(L, widget.entry.data(), widget.entry.size());
            return 1;
    }
    return 0;
}

Pushed widget_value(lua_State* L, UiObject* self, std::int64_t number) {
    const Widget& widget = self->ui.widgets()[to_place(L, *self, number)];
    if (push_widget_value(L, widget) == 0) lua_pushnil(L);
    if (widget.kind == WidgetKind::Choice) lua_pop(L, 1);
    return {1};
}

void set_value(lua_State* L, UiObject* self, std::int64_t number, AnyArgument value) {
    const int place = to_place(L, *self, number);
    const Widget& widget = self->ui.widgets()[place];
    const auto check = [&](bool is_right, const std::string& expected) {
        if (!is_right) argument_error(L, value.index, expected);
    };
    switch (widget.kind) {
        case WidgetKind::Label:
        case WidgetKind::Button:
            call_error(L, "labels and buttons have no value");
        case WidgetKind::Toggle:
            check(lua_isboolean(L, value.index), "true or false");
            return self->ui.set_value(place, lua_toboolean(L, value.index));
        case WidgetKind::Slider:
            check(lua_type(L, value.index) == LUA_TNUMBER && lua_tonumber(L, value.index) >= widget.low &&
                      lua_tonumber(L, value.index) <= widget.high,
                  "a number " + slider_rule(widget) + " for " + widget_name(place, widget));
            return self->ui.set_value(place, lua_tonumber(L, value.index));
        case WidgetKind::Choice: {
            check(is_integral(L, value.index) && lua_tointeger(L, value.index) >= 1 &&
                      lua_tointeger(L, value.index) <= static_cast<lua_Integer>(widget.choices.size()),
                  "the number of a choice");
            return self->ui.set_value(place, lua_tonumber(L, value.index) - 1);
        }
        case WidgetKind::TextField: {
            std::string entry(Argument<std::string_view>::get(L, value.index));
            const std::string missing = engine::missing_of_entry(entry, widget.max_length);
            check(missing.empty(), "a text with " + missing + " for " + widget_name(place, widget));
            return self->ui.set_entry(place, std::move(entry));
        }
    }
}

void set_text(lua_State* L, UiObject* self, std::int64_t number, std::string_view text) {
    const int place = to_place(L, *self, number);
    self->ui.set_text(place, std::string(text));
    fit_text(L, *self, place);
}
void set_enabled(lua_State* L, UiObject* self, std::int64_t number, bool enabled) {
    self->ui.set_enabled(to_place(L, *self, number), enabled);
}
void set_title(UiObject* self, std::string_view title) {
    self->ui.title = std::string(title);
}
std::int64_t focus(UiObject* self) {
    return self->ui.focus() + 1;
}
void set_focus(lua_State* L, UiObject* self, std::int64_t number) {
    const int place = to_place(L, *self, number);
    const Widget& widget = self->ui.widgets()[place];
    const std::string expected = "one that can be used; " + widget_name(place, widget);
    if (widget.kind == WidgetKind::Label) argument_error(L, 2, expected + " is a label");
    if (!widget.is_enabled) argument_error(L, 2, expected + " is disabled");
    self->ui.set_focus(place);
}
bool is_typing(UiObject* self) {
    return self->ui.is_editing();
}
void clear(lua_State* L, UiObject* self) {
    self->ui.clear();
    // Keeps what is called for back.
    lua_newtable(L);
    lua_getiuservalue(L, 1, 1);
    lua_rawgeti(L, -1, 0);
    lua_rawseti(L, -3, 0);
    lua_pop(L, 1);
    lua_setiuservalue(L, 1, 1);
}

/// Calls what was given for what has just happened.
void tell(lua_State* L, UiObject& self) {
    for (const engine::UiEvent& event : self.ui.take_events()) {
        // What is called may take the widgets away.
        if (event.widget >= static_cast<int>(self.ui.widgets().size())) continue;
        lua_getiuservalue(L, 1, 1);
        if (lua_rawgeti(L, -1, event.widget + 1) == LUA_TFUNCTION) {
            const int count = event.widget < 0 ? 0 : push_widget_value(L, self.ui.widgets()[event.widget]);
            lua_call(L, count, 0);
        } else {
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
    }
}

void update(lua_State* L, UiObject* self) {
    Context& context = context_of(L);
    if (std::exchange(self->frame, context.frame) == context.frame) return;  // these events were applied
    follow_screen(L, *self);
    // One after the other: the second of two presses meets the menu that the first has made.
    for (std::size_t i = 0; i < context.events.size(); ++i) {
        if (context.typing.is_of_another(self->ui, i)) continue;
        self->ui.apply(context.events[i]);
        tell(L, *self);
    }
    self->ui.update(context.services.updates_per_second);
    tell(L, *self);
    context.typing.follow(L, 1, self->ui);
}

void draw(lua_State* L, UiObject* self) {
    engine::Renderer& renderer = drawing_context(L).services.renderer;
    follow_screen(L, *self);
    check_or_raise(L, renderer.push_transform());
    renderer.reset_transform();
    self->ui.draw(renderer, self->font);
    check_or_raise(L, renderer.pop_transform());
}

constexpr std::array<std::string_view, 1> kReturnsUi = {"Ui"};
constexpr std::array<std::string_view, 1> kReturnsValue = {"any"};

constexpr Function kModuleFunctions[] = {
    function_pushing<&new_ui>("new", "fields = {}", "ui", kReturnsUi, "Makes an empty panel.", &kUiFields),
};
constexpr Function kMethods[] = {
    function<&add_label>(
        "add_label", "fields", "widget",
        "Adds a text, which may take several lines; those of other widgets are shortened where "
        "there is no room for them. Widgets are numbered from 1, from the top.",
        &kLabelFields),
    function<&add_button>("add_button", "fields", "widget", "Adds a button.", &kButtonFields),
    function<&add_toggle>("add_toggle", "fields", "widget", "Adds a switch that is on or off.",
                          &kToggleFields),
    function<&add_slider>("add_slider", "fields", "widget", "Adds a number between two ends.",
                          &kSliderFields),
    function<&add_choice>("add_choice", "fields", "widget", "Adds one of several words.", &kChoiceFields),
    function<&add_text>(
        "add_text", "fields", "widget",
        "Adds a field that text is typed into while it is open: return, space, a click or the "
        "gamepad's \"a\" opens it; return, escape, tab, a click elsewhere or \"a\" and \"b\" close it. "
        "All keys, texts and buttons of gamepads meanwhile go into it alone: neither callbacks, "
        "`cairn.input` and actions nor other menus get them. Sticks still move, and releases of what was "
        "held before still come.",
        &kTextFields),
    function<&update>(
        "update", "", "",
        "Takes the events of this update, and calls what was given for the widgets. Once per update of the "
        "scene that has it."),
    function<&draw>("draw", "", "", "In screen pixels, whatever the transform; only in `cairn.draw`."),
    function_pushing<&widget_value>(
        "value", "widget", "value", kReturnsValue,
        "A boolean, a number, the number of a choice, or a text; nil of labels and buttons."),
    function<&set_value>("set_value", "widget, value", "",
                         "Without calling `changed`. A value that the widget cannot have is an error."),
    function<&set_text>("set_text", "widget, text", "", "What stands on it."),
    function<&set_enabled>("set_enabled", "widget, enabled", "", ""),
    function<&set_title>("set_title", "title", "", ""),
    function<&focus>("focus", "", "widget", "The one that keys and gamepads act on; 0: none."),
    function<&set_focus>("set_focus", "widget", "", "Of a label or a disabled widget it is an error."),
    function<&is_typing>(
        "is_typing", "", "typing",
        "Whether a text field of it is open, so that keys and buttons go there and not to the game."),
    function<&clear>("clear", "", "", "Takes all widgets out."),
};

}  // namespace

int finalize_ui(lua_State* L) {
    object_at<UiObject>(L, 1)->~UiObject();
    return 0;
}

const Module kUiModule = {"cairn.ui",
                          "Menus: a panel with rows of widgets, used with arrow keys, mouse, finger or "
                          "gamepad alike. A widget's function may "
                          "do anything, also take the menu apart. Text is typed on a keyboard only.",
                          kModuleFunctions};
const Module kUiMethods = {"Ui", "A menu.", kMethods, true};

}  // namespace cairn::scripting
