// Keys and pictures of the tools.
#include "debug/developer_tools.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include <cairn/engine/log.h>
#include <cairn/scripting/suggest.h>

#include "bind/physics_objects.h"
#include "debug/colors.h"

namespace cairn::scripting {
namespace {

using engine::Color;
using engine::InputEvent;
using engine::InputKind;
using engine::Vec2;

constexpr Color kVeil{0.05f, 0.06f, 0.08f, 0.55f};

struct KeyHelp {
    engine::Key key;
    const char* name;
    const char* what;
};
constexpr KeyHelp kKeys[] = {
    {engine::Key::F1, "F1", "this help"},
    {engine::Key::F2, "F2",
     "physics: shapes, contacts and joints; again: islands; again: boxes and centres; off"},
    {engine::Key::F3, "F3", "profiler: where the time of a frame goes, and how exact the physics is"},
    {engine::Key::F4, "F4", "held: go back in time, up to ten seconds; then pause"},
    {engine::Key::F5, "F5", "start the game anew"},
    {engine::Key::F6, "F6", "pause, go on"},
    {engine::Key::F7, "F7", "pause, and go on by one update; held, by one after the other"},
    {engine::Key::F8, "F8", "half as fast"},
    {engine::Key::F9, "F9", "twice as fast"},
    {engine::Key::F10, "F10",
     "inspector: worlds, bodies, joints, values of the script, assets, log; a gamepad's middle button drives "
     "it"},
};

bool is_tool_key(engine::Key key) {
    return std::any_of(std::begin(kKeys), std::end(kKeys), [&](const KeyHelp& k) { return k.key == key; });
}

/// All of a world's bodies, with a margin: for worlds that no camera shows.
engine::Affine2 view_of_all(const physics::World& world, engine::Size size) {
    physics::Position low{-5, -5};
    physics::Position high{5, 5};
    bool is_first = true;
    for (const physics::DebugBox& box : world.debug_boxes()) {
        const auto body = world.body(world.shape(box.shape)->body());
        // Grounds tend to be endless.
        if (body->type() == physics::BodyType::Static && !is_first) continue;
        low = is_first ? box.lower_m
                       : physics::Position{std::min(low.x, box.lower_m.x), std::min(low.y, box.lower_m.y)};
        high = is_first ? box.upper_m
                        : physics::Position{std::max(high.x, box.upper_m.x), std::max(high.y, box.upper_m.y)};
        is_first = false;
    }
    const double width = std::max(high.x - low.x, 1e-3);
    const double height = std::max(high.y - low.y, 1e-3);
    const double scale = 0.9 * std::min(size.width / width, size.height / height);
    const double x = 0.5 * size.width - scale * 0.5 * (low.x + high.x);
    const double y = 0.5 * size.height + scale * 0.5 * (low.y + high.y);
    return {static_cast<float>(scale), 0, 0, static_cast<float>(-scale), static_cast<float>(x),
            static_cast<float>(y)};
}

}  // namespace

engine::Result<void> DeveloperTools::show(std::string_view name) {
    static const std::array<std::string, 4> kNames{"help", "debug", "profiler", "inspector"};
    if (name == "help") {
        shows_help_ = true;
    } else if (name == "debug") {
        layer_ = DebugLayer::Everything;
    } else if (name == "profiler") {
        shows_profiler_ = true;
    } else if (name == "inspector") {
        shows_inspector_ = true;
    } else {
        return engine::Error{"--show is \"" + std::string(name) + "\": no such tool" +
                             suggestion(name, kNames)};
    }
    return {};
}

void DeveloperTools::take_keys(std::vector<InputEvent>& events) {
    std::erase_if(events, [&](const InputEvent& event) {
        const bool is_press = event.kind == InputKind::KeyPressed;
        if ((!is_press && event.kind != InputKind::KeyReleased) || !is_tool_key(event.key)) return false;
        if (!is_press) time_.release(event.key);
        if (is_press && (!event.is_repeat || event.key == engine::Key::F7)) press(event.key);
        return true;
    });
}

void DeveloperTools::press(engine::Key key) {
    if (key == engine::Key::F4 && !can_change_)
        return engine::log(engine::LogLevel::Warning,
                           "a run that is recorded or replayed cannot go back in time");
    if (key != engine::Key::F1 && key != engine::Key::F5) keeps_past_ = true;
    if (time_.press(key)) return;
    if (key == engine::Key::F1) shows_help_ = !shows_help_;
    if (key == engine::Key::F2)
        layer_ = layer_ == DebugLayer::Everything ? DebugLayer::Off
                                                  : static_cast<DebugLayer>(static_cast<int>(layer_) + 1);
    if (key == engine::Key::F3) shows_profiler_ = !shows_profiler_;
    if (key == engine::Key::F10) shows_inspector_ = !shows_inspector_;
    if (key == engine::Key::F5) wants_restart_ = true;
}

bool DeveloperTools::take_restart() {
    return std::exchange(wants_restart_, false);
}

void DeveloperTools::end_frame(const Game& game) {
    const bool is_wanted = shows_profiler_ || measures_;
    if (meter_.is_on() != is_wanted) meter_.turn(is_wanted, game.context());
    meter_.end_frame(game.context(), game.state().allocated_bytes());
}

void DeveloperTools::draw(const Game& game) {
    std::string label = time_.label();
    if (time_.goes_back()) {
        char left[32];
        std::snprintf(left, sizeof left, ", %.1f s are left",
                      static_cast<double>(rewind_.steps_back()) * game.context().step_s());
        label += left;
    }
    if (!shows_help_ && !shows_profiler_ && !shows_inspector_ && layer_ == DebugLayer::Off && label.empty())
        return;
    const Context& context = game.context();
    engine::Renderer& renderer = context.services.renderer;
    // The game may have left the renderer in any state.
    while (!renderer.current_canvas().is_null() && renderer.end_canvas()) {
    }
    renderer.reset_transform();
    renderer.set_scissor(std::nullopt);
    renderer.set_blend_mode(engine::BlendMode::Alpha);
    if (layer_ != DebugLayer::Off) draw_worlds(context);
    if (shows_inspector_) draw_inspector(game);
    const float size = std::max(10.0f, static_cast<float>(renderer.logical_size().height) / 45);
    const auto font = renderer.load_font("fonts/default.ttf", size);
    if (!font) return;
    if (shows_profiler_) profiler_.draw(meter_, context, game.state().used_bytes(), *font);
    if (!label.empty()) draw_label(renderer, *font, label);
    if (shows_help_) draw_help(renderer, *font);
}

void DeveloperTools::take_input(std::vector<InputEvent>& events, const Game& game) {
    if (shows_inspector_ && inspector_ != nullptr) inspector_->take_events(events, game);
}

std::optional<ScriptError> DeveloperTools::note_update(Game& game) {
    if (!keeps_past_ || !can_change_) return std::nullopt;
    return rewind_.note(game);
}

void DeveloperTools::forget_game() {
    rewind_.forget();
    inspector_.reset();
}

void DeveloperTools::draw_inspector(const Game& game) {
    if (inspector_ == nullptr) {
        auto made = Inspector::create(game.context().services);
        if (!made) {
            shows_inspector_ = false;
            return engine::log(engine::LogLevel::Warning, made.error().message);
        }
        inspector_ = *std::move(made);
    }
    inspector_->draw(game, can_change_);
}

void DeveloperTools::draw_worlds(const Context& context) const {
    engine::Renderer& renderer = context.services.renderer;
    const engine::Size size = renderer.logical_size();
    renderer.fill_rectangle({0, 0, static_cast<float>(size.width), static_cast<float>(size.height)}, kVeil);
    for (const WorldObject* object : context.worlds) {
        const physics::World& world = *object->world;
        renderer.reset_transform();
        renderer.apply_transform(context.world_view ? *context.world_view : view_of_all(world, size));
        draw_debug(renderer, world,
                   {.islands = layer_ >= DebugLayer::Islands,
                    .boxes = layer_ == DebugLayer::Everything,
                    .centers = layer_ == DebugLayer::Everything,
                    .alpha = static_cast<float>(context.alpha)});
    }
    renderer.reset_transform();
}

void DeveloperTools::draw_label(engine::Renderer& renderer, engine::FontId font,
                                const std::string& label) const {
    const Vec2 size = renderer.measure_text(font, label);
    const float middle = 0.5f * static_cast<float>(renderer.logical_size().width);
    renderer.fill_rectangle({middle - size.x / 2 - size.y, 0, size.x + 2 * size.y, 1.5f * size.y},
                            panel::kGround);
    renderer.draw_text(
        font, label,
        {.position = {middle, 0.25f * size.y}, .color = panel::kText, .align = engine::TextAlign::Center});
}

void DeveloperTools::draw_help(engine::Renderer& renderer, engine::FontId font) const {
    const float line = 1.35f * renderer.line_height(font);
    float width = 0;
    for (const KeyHelp& key : kKeys) width = std::max(width, renderer.measure_text(font, key.what).x);
    const float key_width = renderer.measure_text(font, "F10").x + 2 * line;
    const float height = line * (static_cast<float>(std::size(kKeys)) + 1);
    const auto screen = renderer.logical_size();
    const Vec2 corner{0.5f * (static_cast<float>(screen.width) - width - key_width - line),
                      0.5f * (static_cast<float>(screen.height) - height)};
    Color ground = panel::kGround;
    ground.a = 1;  // it may lie over the profiler, whose lines would shine through
    renderer.fill_rectangle({corner.x, corner.y, width + key_width + line, height}, ground);
    float y = corner.y + line / 2;
    for (const KeyHelp& key : kKeys) {
        renderer.draw_text(font, key.name, {.position = {corner.x + line, y}, .color = panel::kText});
        renderer.draw_text(font, key.what, {.position = {corner.x + key_width, y}, .color = panel::kQuiet});
        y += line;
    }
}

}  // namespace cairn::scripting
