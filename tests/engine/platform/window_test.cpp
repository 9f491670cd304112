// A real window, as under Xvfb. Without a display these tests are skipped with a message.
#include <SDL.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>

#include <cairn/engine/platform.h>
#include <cairn/engine/renderer.h>

#include "engine/support/drawing.h"
#include "support/source_path.h"

using namespace cairn::engine;

namespace {

bool has_display() {
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"})
        if (std::getenv(variable)) return true;
    WARN("skipped: there is no display; run the tests under xvfb-run");
    return false;
}

struct WindowGame {
    explicit WindowGame(WindowScaling scaling = WindowScaling::Fit,
                        std::optional<Size> window_size = std::nullopt) {
        files = std::move(*Files::create({}));
        REQUIRE(files->mount(cairn::test::source_path("assets")));
        PlatformDef def;
        def.window.title = "window test";
        def.window.size = {320, 200};
        def.window.scaling = scaling;
        def.window.window_size = window_size;
        def.window.has_vsync = false;
        auto made = Platform::create(def);
        if (!made) FAIL(made.error().message);
        platform = std::move(*made);
        renderer = std::move(*platform->create_renderer(*files));
    }

    std::vector<InputEvent> events() {
        std::vector<InputEvent> all;
        platform->poll_events(all);
        return all;
    }

    /// The only events of a kind, without those that the desktop sends by itself.
    std::vector<InputEvent> events_of(InputKind kind) {
        std::vector<InputEvent> some;
        for (InputEvent& event : events())
            if (event.kind == kind) some.push_back(std::move(event));
        return some;
    }

    std::unique_ptr<Files> files;
    std::unique_ptr<Platform> platform;
    std::unique_ptr<Renderer> renderer;
};

SDL_Event sdl_event(Uint32 type) {
    SDL_Event event;
    SDL_zero(event);
    event.type = type;
    return event;
}

}  // namespace

TEST_CASE("a window shows what is drawn and gives it back as a picture") {
    if (!has_display()) return;
    WindowGame game;
    CHECK_FALSE(game.platform->is_headless());
    CHECK(game.platform->window().logical_size() == Size{320, 200});
    for (int frame = 0; frame < 3; ++frame) {
        (void)game.events();
        game.renderer->begin_frame({0, 0, 1, 1});
        game.renderer->fill_rectangle({100, 50, 60, 40}, {1, 0, 0, 1});
        game.renderer->fill_circle({250, 120}, 30, {0, 1, 0, 1});
        const auto image = game.renderer->capture();
        REQUIRE(image);
        REQUIRE(image->size == Size{320, 200});
        CHECK(rgb(*image, 99, 60) == 0x0000ffu);
        CHECK(rgb(*image, 100, 60) == 0xff0000u);
        CHECK(rgb(*image, 159, 89) == 0xff0000u);
        CHECK(rgb(*image, 160, 89) == 0x0000ffu);
        CHECK(rgb(*image, 250, 120) == 0x00ff00u);
        game.renderer->end_frame();
    }
    CHECK(game.renderer->stats().draw_calls == 1);
}

TEST_CASE("text and images arrive in a window as they do in memory") {
    if (!has_display()) return;
    const auto draw = [](Renderer& renderer) {
        const auto font = renderer.load_font("fonts/default.ttf", 20);
        REQUIRE(font);
        const auto texture = renderer.create_texture({{2, 1}, {255, 0, 0, 255, 0, 0, 255, 255}});
        REQUIRE(texture);
        renderer.begin_frame({0.1f, 0.2f, 0.3f, 1});
        renderer.draw_text(*font, "Cairn", {.position = {20, 20}});
        renderer.draw_image(*texture, {.position = {150, 40}, .rotation_rad = 0.5f, .scale = {30, 30}});
        renderer.draw_line({10, 180}, {300, 120}, 3, {1, 1, 0, 1});
        auto image = renderer.capture();
        REQUIRE(image);
        renderer.end_frame();
        return std::move(*image);
    };
    Image expected;
    {
        Drawing memory({320, 200});
        expected = draw(*memory.renderer);
    }
    WindowGame game;
    const Image image = draw(*game.renderer);
    REQUIRE(image.size == expected.size);
    // A driver rounds and filters a little differently: rarely, and never by much over the whole picture.
    double difference = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        difference += std::abs(static_cast<int>(image.rgba[i]) - static_cast<int>(expected.rgba[i]));
    CHECK(difference / static_cast<double>(image.rgba.size()) < 0.25);
}

TEST_CASE("the desktop's events arrive as plain input") {
    if (!has_display()) return;
    WindowGame game;
    (void)game.events();

    SDL_Event key = sdl_event(SDL_KEYDOWN);
    key.key.keysym.sym = SDLK_F5;
    SDL_PushEvent(&key);
    key.key.keysym.sym = SDLK_w;
    key.key.repeat = 1;
    SDL_PushEvent(&key);
    auto pressed = game.events_of(InputKind::KeyPressed);
    REQUIRE(pressed.size() == 2);
    CHECK(pressed[0].key == Key::F5);
    CHECK_FALSE(pressed[0].is_repeat);
    CHECK(pressed[1].key == Key::W);
    CHECK(pressed[1].is_repeat);

    SDL_Event button = sdl_event(SDL_MOUSEBUTTONDOWN);
    button.button.button = SDL_BUTTON_RIGHT;
    button.button.x = 30;
    button.button.y = 40;
    SDL_PushEvent(&button);
    auto buttons = game.events_of(InputKind::MousePressed);
    REQUIRE(buttons.size() == 1);
    CHECK(buttons[0].button == MouseButton::Right);
    CHECK(buttons[0].position == Vec2{30, 40});

    SDL_Event quit = sdl_event(SDL_QUIT);
    SDL_PushEvent(&quit);
    CHECK(game.events_of(InputKind::QuitRequested).size() == 1);
}

TEST_CASE("mouse positions are logical when the window has another size than the picture") {
    if (!has_display()) return;
    WindowGame game;
    SDL_Window* window = nullptr;
    for (Uint32 id = 1; !window && id < 64; ++id) window = SDL_GetWindowFromID(id);
    REQUIRE(window);
    SDL_SetWindowSize(window, 800, 400);  // twice as high, and 80 points of bar at either side
    (void)game.events();
    REQUIRE(game.platform->window().logical_size() == Size{320, 200});

    SDL_Event motion = sdl_event(SDL_MOUSEMOTION);
    motion.motion.x = 80 + 2 * 50;
    motion.motion.y = 2 * 60;
    motion.motion.xrel = 4;
    SDL_PushEvent(&motion);
    auto moved = game.events_of(InputKind::MouseMoved);
    REQUIRE_FALSE(moved.empty());
    CHECK(moved.back().position == Vec2{50, 60});
    CHECK(moved.back().delta == Vec2{2, 0});

    // A driver may take a frame to see the window's new size.
    Image last;
    for (int frame = 0; frame < 3; ++frame) {
        (void)game.events();
        game.renderer->begin_frame({1, 0, 0, 1});
        auto image = game.renderer->capture();
        REQUIRE(image);
        last = std::move(*image);
        game.renderer->end_frame();
    }
    REQUIRE(last.size == Size{800, 400});
    CHECK(rgb(last, 79, 200) == 0u);
    CHECK(rgb(last, 80, 200) == 0xff0000u);
    CHECK(rgb(last, 719, 200) == 0xff0000u);
    CHECK(rgb(last, 720, 200) == 0u);
}

TEST_CASE("a picture that follows the window tells its new size") {
    if (!has_display()) return;
    WindowGame game(WindowScaling::Follow);
    (void)game.events();
    SDL_Window* window = nullptr;
    for (Uint32 id = 1; !window && id < 64; ++id) window = SDL_GetWindowFromID(id);
    REQUIRE(window);
    SDL_SetWindowSize(window, 500, 300);
    const auto resized = game.events_of(InputKind::WindowResized);
    REQUIRE_FALSE(resized.empty());
    CHECK(resized.back().delta == Vec2{500, 300});
    CHECK(game.platform->window().size() == Size{500, 300});
    CHECK(game.platform->window().logical_size() == Size{320, 200});  // until the game is told
    game.platform->window().set_logical_size({500, 300});
    CHECK(game.renderer->logical_size() == Size{500, 300});
}

TEST_CASE("where the mouse is after a resize is told in the new size, before the game has taken it") {
    if (!has_display()) return;
    WindowGame game(WindowScaling::Follow);
    (void)game.events();
    game.platform->window().set_size({640, 500});
    SDL_Event motion = sdl_event(SDL_MOUSEMOTION);
    motion.motion.x = 600;
    motion.motion.y = 450;
    motion.motion.xrel = 4;
    SDL_PushEvent(&motion);
    // As in a loop that polls twice before an update is due.
    std::vector<InputEvent> events;
    game.platform->poll_events(events);
    SDL_PushEvent(&motion);
    game.platform->poll_events(events);
    std::vector<Vec2> positions;
    bool was_resized = false;
    for (const InputEvent& event : events) {
        was_resized = was_resized || event.kind == InputKind::WindowResized;
        if (event.kind == InputKind::MouseMoved && event.delta.x != 0 && was_resized)
            positions.push_back(event.position);
    }
    CHECK(game.platform->window().logical_size() == Size{320, 200});
    REQUIRE(positions.size() >= 2);
    for (const Vec2 position : positions) CHECK(position == Vec2{600, 450});
}

TEST_CASE("a window can be made with a size of its own, resized and given another picture") {
    if (!has_display()) return;
    WindowGame game(WindowScaling::Fit, Size{640, 400});
    Window& window = game.platform->window();
    CHECK(window.size() == Size{640, 400});
    CHECK(window.logical_size() == Size{320, 200});
    CHECK(game.renderer->pixel_scale() == 2);
    window.set_size({800, 500});
    CHECK(window.size() == Size{800, 500});
    window.set_logical_size({400, 250});
    CHECK(game.renderer->logical_size() == Size{400, 250});
    CHECK(game.events_of(InputKind::WindowResized).empty());
    window.set_resizable(false);
    CHECK_FALSE(window.is_resizable());
    window.set_resizable(true);
    CHECK(window.is_resizable());
    window.set_fullscreen(true);
    CHECK(window.is_fullscreen());
    window.set_size({640, 400});
    CHECK_FALSE(window.is_fullscreen());
}

TEST_CASE("a gamepad that is plugged in, used and pulled out again is seen") {
    if (!has_display()) return;
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    WindowGame game;
    (void)game.events();
    const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                                 SDL_CONTROLLER_BUTTON_MAX, 0);
    REQUIRE(device >= 0);
    const auto came = game.events_of(InputKind::GamepadConnected);
    REQUIRE(came.size() == 1);
    CHECK(came[0].number == 1);
    CHECK_FALSE(came[0].text.empty());

    SDL_Joystick* joystick = SDL_JoystickFromInstanceID(SDL_JoystickGetDeviceInstanceID(device));
    REQUIRE(joystick);
    SDL_JoystickSetVirtualButton(joystick, SDL_CONTROLLER_BUTTON_B, 1);
    SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTY, -32768);
    SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTX, 2000);  // a tremor
    SDL_JoystickUpdate();
    std::vector<std::string> lines;
    for (const InputEvent& event : game.events())
        if (event.number == 1) lines.push_back(to_text(event));
    CHECK(std::count(lines.begin(), lines.end(), "gamepad_pressed 1 b") == 1);
    CHECK(std::count(lines.begin(), lines.end(), "gamepad_moved 1 left_y 1") == 1);
    for (const std::string& line : lines) CHECK(line.find("left_x") == std::string::npos);
    game.platform->rumble(1, 1, 1, 0.1);  // a virtual one cannot; nothing happens
    game.platform->rumble(7, 1, 1, 0.1);

    SDL_JoystickDetachVirtual(device);
    const auto went = game.events_of(InputKind::GamepadDisconnected);
    REQUIRE(went.size() == 1);
    CHECK(went[0].number == 1);
}

TEST_CASE("fingers get small numbers, which are given again, and the first is the mouse too") {
    if (!has_display()) return;
    WindowGame game;
    const auto finger = [](Uint32 type, SDL_FingerID id, float x, float y) {
        SDL_Event event = sdl_event(type);
        event.tfinger.fingerId = id;
        event.tfinger.x = x;
        event.tfinger.y = y;
        event.tfinger.dx = 0.25f;
        SDL_PushEvent(&event);
    };
    finger(SDL_FINGERDOWN, 123456789, 0.5f, 0.5f);
    finger(SDL_FINGERDOWN, 42, 0.25f, 0.5f);
    finger(SDL_FINGERMOTION, 123456789, 0.75f, 0.5f);
    finger(SDL_FINGERUP, 123456789, 0.75f, 0.5f);
    finger(SDL_FINGERDOWN, 77, 0.5f, 0.25f);
    finger(SDL_FINGERMOTION, 999, 0.5f, 0.25f);  // never pressed
    std::vector<std::string> lines;
    for (const InputEvent& event : game.events()) lines.push_back(to_text(event));
    // What the display itself tells stands before and after.
    const auto first = std::find(lines.begin(), lines.end(), "mouse_pressed left 160 100");
    const auto last = std::find(first, lines.end(), "touch_pressed 1 160 50");
    REQUIRE(last != lines.end());
    CHECK(std::vector<std::string>(first, last + 1) ==
          std::vector<std::string>{"mouse_pressed left 160 100", "touch_pressed 1 160 100",
                                   "touch_pressed 2 80 100", "mouse_moved 240 100 80 0",
                                   "touch_moved 1 240 100 80 0", "mouse_released left 240 100",
                                   "touch_released 1 240 100", "mouse_moved 160 50 -80 -50",
                                   "mouse_pressed left 160 50", "touch_pressed 1 160 50"});
}

TEST_CASE("a signal is told apart from a click on the close button, which a game may refuse") {
    if (!has_display()) return;
    for (const int signal : {SIGTERM, SIGINT}) {
        // Those of the test program would be left alone.
        const auto handler = std::signal(signal, SIG_DFL);
        {
            WindowGame game;
            SDL_Event close = sdl_event(SDL_QUIT);
            SDL_PushEvent(&close);
            CHECK(game.events_of(InputKind::QuitRequested).size() == 1);
            CHECK(game.platform->end_signal() == 0);
            std::raise(signal);
            CHECK(game.events_of(InputKind::QuitRequested).empty());
            CHECK(game.platform->end_signal() == signal);
            // A second one would end the program.
            CHECK(std::signal(signal, SIG_DFL) == SIG_DFL);
        }
        CHECK(std::signal(signal, handler) == SIG_DFL);
        WindowGame next;
        CHECK(next.platform->end_signal() == 0);
    }
}
