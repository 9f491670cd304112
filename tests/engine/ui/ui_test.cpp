// Menus by key, mouse, finger and gamepad, without a picture and with one.
#include <catch2/catch.hpp>

#include <cairn/engine/ui.h>

#include "engine/support/drawing.h"
#include "ui/shortened_text.h"

using namespace cairn::engine;

namespace {

/// A label, two buttons side by side, a slider, a choice, a disabled button, a toggle and a text field.
struct Menu {
    enum { kLabel, kPlay, kQuit, kVolume, kDetail, kLocked, kSound, kName };

    Menu() : ui({320, 240}, {.width = 400, .row_height = 40, .gap = 10, .padding = 20}) {
        ui.add({.kind = WidgetKind::Label, .text = "Welcome"});
        ui.add({.kind = WidgetKind::Button, .text = "Play"});
        ui.add({.kind = WidgetKind::Button, .text = "Quit", .shares_row = true});
        ui.add({.kind = WidgetKind::Slider, .text = "Volume", .value = 0.5, .step = 0.1});
        ui.add({.kind = WidgetKind::Choice, .text = "Detail", .choices = {"low", "middle", "high"}});
        ui.add({.kind = WidgetKind::Button, .text = "Locked", .is_enabled = false});
        ui.add({.kind = WidgetKind::Toggle, .text = "Sound"});
        ui.add({.kind = WidgetKind::TextField, .text = "Name", .max_length = 5});
    }
    void key(Key key, bool repeat = false) {
        ui.apply({.kind = InputKind::KeyPressed, .key = key, .is_repeat = repeat});
        ui.apply({.kind = InputKind::KeyReleased, .key = key});
    }
    void type(const std::string& text) { ui.apply({.kind = InputKind::TextEntered, .text = text}); }
    void button(GamepadButton button) {
        ui.apply({.kind = InputKind::GamepadPressed, .number = 1, .gamepad_button = button});
        ui.apply({.kind = InputKind::GamepadReleased, .number = 1, .gamepad_button = button});
    }
    void stick(GamepadAxis axis, float value) {
        ui.apply({.kind = InputKind::GamepadMoved, .number = 1, .gamepad_axis = axis, .value = value});
    }
    Vec2 middle(int place) const {
        const Rect r = ui.area(place);
        return {r.x + 0.5f * r.width, r.y + 0.5f * r.height};
    }
    void mouse(InputKind kind, Vec2 at) {
        ui.apply({.kind = kind, .button = MouseButton::Left, .position = at});
    }
    void click(Vec2 at) {
        mouse(InputKind::MousePressed, at);
        mouse(InputKind::MouseReleased, at);
    }
    /// "pressed 1, changed 3": what happened since the last call.
    std::string happened() {
        std::string text;
        for (const UiEvent& event : ui.take_events()) {
            const char* names[] = {"pressed", "changed", "cancelled"};
            text += (text.empty() ? "" : ", ") + std::string(names[static_cast<int>(event.kind)]) +
                    (event.widget >= 0 ? ' ' + std::to_string(event.widget) : "");
        }
        return text;
    }
    double value(int place) const { return ui.widgets()[place].value; }

    Ui ui;
};

}  // namespace

TEST_CASE_METHOD(Menu,
                 "the focus begins at the first thing that can be used and goes round, past what cannot") {
    CHECK(ui.focus() == kPlay);
    std::vector<int> way;
    for (int i = 0; i < 5; ++i) {
        key(Key::Down);
        way.push_back(ui.focus());
    }
    CHECK(way == std::vector<int>{kVolume, kDetail, kSound, kName, kPlay});
    key(Key::Up);
    CHECK(ui.focus() == kName);
    key(Key::Tab);
    CHECK(ui.focus() == kPlay);
}

TEST_CASE_METHOD(Menu, "left and right go along a row, and a row below is entered at the same side") {
    key(Key::Right);
    CHECK(ui.focus() == kQuit);
    key(Key::Right);
    CHECK(ui.focus() == kQuit);
    key(Key::Left);
    CHECK(ui.focus() == kPlay);
    key(Key::Right);
    key(Key::Up);
    key(Key::Down);
    CHECK(ui.focus() == kPlay);  // the row above has one column only
}

TEST_CASE_METHOD(Menu, "buttons are pressed, values changed, and back asked for by key") {
    key(Key::Return);
    CHECK(happened() == "pressed 1");
    ui.set_focus(kVolume);
    for (int i = 0; i < 3; ++i) key(Key::Right);
    CHECK(value(kVolume) == Approx(0.8));
    CHECK(happened() == "changed 3, changed 3, changed 3");
    for (int i = 0; i < 9; ++i) key(Key::Right);
    CHECK(value(kVolume) == 1);
    CHECK(happened() == "changed 3, changed 3");  // at the end nothing changes
    ui.set_focus(kDetail);
    key(Key::Left);
    CHECK(value(kDetail) == 2);
    key(Key::Space);
    CHECK(value(kDetail) == 0);
    ui.set_focus(kSound);
    key(Key::Space);
    CHECK(value(kSound) == 1);
    (void)happened();
    key(Key::Space, /*repeat=*/true);
    key(Key::Escape);
    CHECK(happened() == "cancelled");
}

TEST_CASE_METHOD(Menu, "a gamepad does the same, and a direction held repeats after a while") {
    button(GamepadButton::DpadDown);
    CHECK(ui.focus() == kVolume);
    button(GamepadButton::A);
    button(GamepadButton::B);
    CHECK(happened() == "cancelled");
    stick(GamepadAxis::LeftX, 0.3f);  // too little
    CHECK(value(kVolume) == 0.5);
    stick(GamepadAxis::LeftX, 0.9f);
    stick(GamepadAxis::LeftX, 0.7f);  // still the same press
    CHECK(value(kVolume) == Approx(0.6));
    for (int i = 0; i < 23; ++i) ui.update();
    CHECK(value(kVolume) == Approx(0.6));
    ui.update();
    CHECK(value(kVolume) == Approx(0.7));
    for (int i = 0; i < 7; ++i) ui.update();
    CHECK(value(kVolume) == Approx(0.8));
    stick(GamepadAxis::LeftX, 0);
    for (int i = 0; i < 60; ++i) ui.update();
    CHECK(value(kVolume) == Approx(0.8));
    stick(GamepadAxis::LeftY, -1);  // down
    CHECK(ui.focus() == kDetail);
    ui.apply({.kind = InputKind::GamepadDisconnected, .number = 1});
    for (int i = 0; i < 60; ++i) ui.update();
    CHECK(ui.focus() == kDetail);
}

TEST_CASE_METHOD(Menu, "the mouse points, presses what it lets go on, and drags sliders") {
    mouse(InputKind::MouseMoved, middle(kSound));
    CHECK(ui.focus() == kSound);
    click(middle(kSound));
    CHECK(happened() == "changed 6");
    mouse(InputKind::MousePressed, middle(kPlay));
    mouse(InputKind::MouseReleased, middle(kSound));  // let go elsewhere
    CHECK(happened() == "");
    click(middle(kLocked));
    CHECK(happened() == "");
    const Rect volume = ui.area(kVolume);
    mouse(InputKind::MousePressed, {volume.x + 0.9f * volume.width, volume.y + 5});
    CHECK(value(kVolume) > 0.5);
    mouse(InputKind::MouseMoved, {volume.x - 500, volume.y + 300});  // far outside it still holds
    CHECK(value(kVolume) == 0);
    mouse(InputKind::MouseReleased, {volume.x - 500, volume.y + 300});
    (void)happened();
    const Rect detail = ui.area(kDetail);
    click({detail.x + 0.95f * detail.width, detail.y + 5});
    CHECK(value(kDetail) == 1);
    click({detail.x + 0.6f * detail.width, detail.y + 5});
    CHECK(value(kDetail) == 0);
    click({5, 5});
    CHECK(happened() == "changed 4, changed 4");
}

TEST_CASE_METHOD(Menu,
                 "the steps of a slider begin at its low end, and its high end is reached wherever it lies") {
    const int odd = ui.add({.kind = WidgetKind::Slider, .value = 4, .low = 1, .high = 10, .step = 2});
    ui.set_value(odd, 4);
    ui.set_focus(odd);
    std::vector<double> way;
    const auto press = [&](Key direction) {
        key(direction);
        way.push_back(value(odd));
    };
    for (int i = 0; i < 4; ++i) press(Key::Right);
    for (int i = 0; i < 5; ++i) press(Key::Left);
    CHECK(way == std::vector<double>{5, 7, 9, 10, 9, 7, 5, 3, 1});
    const Rect r = ui.area(odd);
    mouse(InputKind::MousePressed, {r.x + r.width - 1, r.y + 5});
    CHECK(value(odd) == 10);
    ui.apply({.kind = InputKind::MouseMoved, .position = middle(odd)});
    CHECK(value(odd) == 1);
}

TEST_CASE_METHOD(Menu, "a text field takes typed text up to its length, whole characters at a time") {
    ui.set_focus(kName);
    type("x");  // not before it was asked to
    key(Key::Return);
    CHECK(ui.is_editing());
    type("a");
    type("\xc3\xa4");
    type("b");
    key(Key::Down);  // stays in the field
    CHECK(ui.focus() == kName);
    type("cd");
    type("e");  // would be the sixth
    CHECK(ui.widgets()[kName].entry ==
          "a\xc3\xa4"
          "bcd");
    for (int i = 0; i < 4; ++i) key(Key::Backspace);
    CHECK(ui.widgets()[kName].entry == "a");
    type("\n");
    type("\x7f");
    CHECK(ui.widgets()[kName].entry == "a");
    key(Key::Escape);
    CHECK_FALSE(ui.is_editing());
    CHECK(happened().find("cancelled") == std::string::npos);
    click(middle(kName));
    CHECK(ui.is_editing());
    click(middle(kPlay));
    CHECK_FALSE(ui.is_editing());
}

TEST_CASE_METHOD(Menu, "a widget that is disabled loses the focus, and one alone gets it back") {
    ui.set_enabled(kPlay, false);
    CHECK(ui.focus() == kQuit);
    for (const int place : {kQuit, kVolume, kDetail, kSound, kName}) ui.set_enabled(place, false);
    CHECK(ui.focus() == -1);
    key(Key::Down);
    key(Key::Return);
    CHECK(happened() == "");
    ui.set_enabled(kDetail, true);
    CHECK(ui.focus() == kDetail);
    ui.clear();
    CHECK(ui.focus() == -1);
    key(Key::Return);
}

TEST_CASE("a list that does not fit is scrolled to the focus, and by the wheel") {
    Ui ui({320, 240}, {.width = 300, .row_height = 40, .gap = 10, .padding = 20, .max_height = 240});
    for (int i = 0; i < 20; ++i) ui.add({.kind = WidgetKind::Button, .text = "b"});
    const Rect panel = ui.panel();
    CHECK(panel.height == 240);
    CHECK(ui.area(0).height == 40);
    CHECK(ui.area(19).height == 0);
    const auto is_inside = [&](int place) {
        const Rect r = ui.area(place);
        return r.height > 0 && r.y >= panel.y + 20 && r.y + r.height <= panel.y + panel.height - 20;
    };
    for (int i = 0; i < 40; ++i) {
        CHECK(is_inside(ui.focus()));
        ui.apply({.kind = InputKind::KeyPressed, .key = Key::Down});
    }
    ui.set_focus(0);
    ui.apply({.kind = InputKind::WheelMoved, .position = {320, 240}, .delta = {0, -100}});
    CHECK(is_inside(19));
    // What is scrolled out of sight cannot be hit, although its place would be there.
    ui.apply({.kind = InputKind::MousePressed, .button = MouseButton::Left, .position = {320, 10}});
    CHECK(ui.focus() == 0);
}

TEST_CASE("a menu is drawn with its focus, and leaves scissor and transform as they were") {
    Drawing d({640, 480});
    Menu menu;
    menu.ui.title = "Options";
    d.renderer->begin_frame({0, 0, 0, 1});
    d.renderer->set_scissor(Rect{0, 0, 600, 480});
    menu.ui.set_focus(Menu::kSound);
    menu.ui.draw(*d.renderer, d.font(20));
    const Image image = d.capture();
    // The reddest pixel near the upper edge of a widget: red is what the outline's color has and the others
    // lack.
    const auto edge = [&](int place) {
        const Rect r = menu.ui.area(place);
        int most = 0;
        for (int y = -2; y <= 2; ++y)
            most = std::max<int>(most, image.pixel(static_cast<int>(r.x + 30), static_cast<int>(r.y) + y)[0]);
        return most;
    };
    CHECK(edge(Menu::kSound) > 200);
    CHECK(edge(Menu::kVolume) < 80);
    CHECK(d.renderer->scissor() == Rect{0, 0, 600, 480});
    CHECK(d.renderer->transform_depth() == 0);
    d.renderer->end_frame();
}

TEST_CASE("the track of a slider gives way to its text, but stays long enough to be dragged") {
    Drawing d({640, 480});
    // By dragging: where the number starts to grow, and where it is largest.
    const auto track_of = [&](const std::string& text) {
        Ui ui({320, 240}, {.width = 420});
        const int slider =
            ui.add({.kind = WidgetKind::Slider, .text = text, .value = 0, .low = 0, .high = 1000, .step = 1});
        ui.fit_text(*d.renderer, d.font(20), slider);
        const Rect r = ui.area(slider);
        const auto value_at = [&](float x) {
            for (const InputKind kind : {InputKind::MousePressed, InputKind::MouseReleased})
                ui.apply({.kind = kind, .button = MouseButton::Left, .position = {x, r.y + 0.5f * r.height}});
            return ui.widgets()[slider].value;
        };
        float first = r.x + r.width;
        float last = r.x;
        for (float x = r.x; x < r.x + r.width; ++x) {
            if (value_at(x) > 0) first = std::min(first, x);
            if (value_at(x) < 1000) last = std::max(last, x);
        }
        return Rect{first - r.x, 0, last - first, 0};
    };
    const auto width_of = [&](const std::string& text) {
        return d.renderer->measure_text(d.font(20), text).x;
    };
    const Rect usual = track_of("Sound");
    CHECK(usual.x == Approx(0.5f * 380).margin(2));
    const std::string longer = "How loud the music is";
    const Rect shorter = track_of(longer);
    CHECK(shorter.x > width_of(longer) + width_of("1000"));
    CHECK(shorter.x + shorter.width == Approx(usual.x + usual.width).margin(2));
    CHECK(track_of("How loud the music is that plays all day long").width == Approx(60).margin(3));
}

TEST_CASE(
    "a text that is too long for its place is shortened with an ellipsis, at the end that is asked for") {
    const Drawing d({64, 48}, false);
    const auto font = d.renderer->load_font("fonts/default.ttf", 20);
    REQUIRE(font);
    const auto width = [&](const std::string& text) { return d.renderer->measure_text(*font, text).x; };
    const std::string text = "Stra\u00dfe nach N\u00fcrnberg";
    CHECK(shortened_text(*d.renderer, *font, text, width(text)) == text);
    const std::string front = shortened_text(*d.renderer, *font, text, width("Stra\u00dfe\u2026") + 0.5f);
    CHECK(front == "Stra\u00dfe\u2026");
    CHECK(shortened_text(*d.renderer, *font, text, width("\u2026\u00fcrnberg") + 0.5f, KeptEnd::Back) ==
          "\u2026\u00fcrnberg");
    CHECK(shortened_text(*d.renderer, *font, text, 1) == "");
    CHECK(shortened_text(*d.renderer, *font, "", 0) == "");
    for (float room = 0; room < width(text); room += 3)
        for (const KeptEnd kept : {KeptEnd::Front, KeptEnd::Back})
            CHECK(width(shortened_text(*d.renderer, *font, text, room, kept)) <= room);
}

TEST_CASE("no widget paints outside of its place, however long its texts and large its font") {
    const std::string text = "A text that nobody would ever write on a widget of this width";
    const float size = GENERATE(20.0f, 60.0f);
    for (const WidgetKind kind : {WidgetKind::Label, WidgetKind::Button, WidgetKind::Toggle,
                                  WidgetKind::Slider, WidgetKind::Choice, WidgetKind::TextField}) {
        CAPTURE(size, kind);
        Drawing d({640, 700});
        const FontId font = d.font(size);
        Ui ui({320, 350}, {.width = 300, .row_height = 40, .padding = 20});
        ui.title = text;
        const int place = ui.add({.kind = kind,
                                  .text = text,
                                  .value = 1234567.125,
                                  .low = -1e6,
                                  .high = 1e9,
                                  .step = 0.001,
                                  .choices = {},
                                  .entry = text});
        if (kind == WidgetKind::Choice) {
            ui.clear();
            ui.add({.kind = kind, .text = text, .choices = {text}});
        }
        ui.fit_text(*d.renderer, font, place);
        const Rect area = ui.area(place);
        CHECK(area.height >= d.renderer->line_height(font));
        d.renderer->begin_frame({0, 0, 0, 1});
        ui.draw(*d.renderer, font);
        const Image image = d.capture();
        d.renderer->end_frame();
        // Between the widgets' rows and the panel's sides there is nothing but the panel.
        const Rect panel = ui.panel();
        const unsigned color = rgb(image, static_cast<int>(panel.x) + 6, static_cast<int>(area.y) + 20);
        int others = 0;
        for (int y = static_cast<int>(panel.y) + 20; y < static_cast<int>(panel.y + panel.height) - 20; ++y)
            for (const int x :
                 {static_cast<int>(panel.x) + 4, static_cast<int>(area.x) - 3,
                  static_cast<int>(area.x + area.width) + 3, static_cast<int>(panel.x + panel.width) - 4})
                others += rgb(image, x, y) != color;
        CHECK(others == 0);
        if (area.y + area.height + 8 > panel.y + panel.height) continue;  // the list is scrolled
        int below = 0;
        for (int x = static_cast<int>(area.x); x < static_cast<int>(area.x + area.width); ++x)
            below += rgb(image, x, static_cast<int>(area.y + area.height) + 4) != color;
        CHECK(below == 0);
    }
}

TEST_CASE("a label takes as many lines as it needs, and what follows moves down") {
    const Drawing d({640, 480}, false);
    const auto font = d.renderer->load_font("fonts/default.ttf", 20);
    REQUIRE(font);
    Ui ui({320, 240}, {.width = 300, .row_height = 40, .gap = 8, .padding = 20});
    ui.add({.kind = WidgetKind::Label, .text = "one line"});
    ui.add({.kind = WidgetKind::Button, .text = "OK"});
    ui.fit_text(*d.renderer, *font, 0);
    CHECK(ui.area(0).height == 40);
    ui.set_text(0, "as many words as take three lines or more in a panel that is as narrow as this one is");
    ui.fit_text(*d.renderer, *font, 0);
    CHECK(ui.area(0).height >= 3 * d.renderer->line_height(*font));
    CHECK(ui.area(1).y == Approx(ui.area(0).y + ui.area(0).height + 8));
    CHECK(ui.area(1).height == 40);
    ui.apply(
        {.kind = InputKind::MousePressed, .button = MouseButton::Left, .position = {320, ui.area(1).y + 20}});
    CHECK(ui.focus() == 1);
}
