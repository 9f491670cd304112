// The inspector's window: tabs with pages, and the body that is selected marked in the picture.
#include <chrono>
#include <imgui.h>
#include <utility>

#include "bind/physics_objects.h"
#include "debug/inspector.h"
#include "debug/inspector/gui.h"
#include "debug/inspector/pages.h"

namespace cairn::scripting {
namespace {

using engine::InputEvent;
using engine::InputKind;
using Clock = std::chrono::steady_clock;

/// Keeps what is logged while it exists, and passes it on.
class LogKeeper {
  public:
    LogKeeper()
        : next_(engine::set_log_sink(
              [this](engine::LogLevel level, std::string_view text) { keep(level, text); })) {}
    ~LogKeeper() { static_cast<void>(engine::set_log_sink(next_)); }
    LogKeeper(const LogKeeper&) = delete;
    LogKeeper& operator=(const LogKeeper&) = delete;

    [[nodiscard]] const std::vector<LogLine>& lines() const { return lines_; }

  private:
    void keep(engine::LogLevel level, std::string_view text) {
        constexpr std::size_t kMostLines = 1000;
        if (lines_.size() == kMostLines) lines_.erase(lines_.begin(), lines_.begin() + kMostLines / 2);
        lines_.push_back({level, std::string(text)});
        if (next_) return next_(level, text);
        // Past this sink, to standard error.
        engine::LogSink own = engine::set_log_sink({});
        engine::log(level, text);
        static_cast<void>(engine::set_log_sink(std::move(own)));
    }

    std::vector<LogLine> lines_;
    engine::LogSink next_;
};

class ImguiInspector final : public Inspector {
  public:
    explicit ImguiInspector(std::unique_ptr<Gui> gui) : gui_(std::move(gui)) {}

    void take_events(std::vector<InputEvent>& events, const Game& game) override {
        std::erase_if(events, [&](const InputEvent& event) {
            if (gui_->take(event)) return true;
            if (event.kind == InputKind::MousePressed && event.button == engine::MouseButton::Left &&
                pick(game.context(), event.position)) {
                is_picking_ = true;
                return true;
            }
            // The end of a click that the game never saw.
            return event.kind == InputKind::MouseReleased && event.button == engine::MouseButton::Left &&
                   std::exchange(is_picking_, false);
        });
    }

    void draw(const Game& game, bool can_change) override {
        const Context& context = game.context();
        const Clock::time_point now = Clock::now();
        const float elapsed_s = std::chrono::duration<float>(now - std::exchange(then_, now)).count();
        if (selection_.world >= context.worlds.size()) selection_ = {};
        mark_selection(context);
        if (std::exchange(is_new_, false)) {
            gui_->begin(elapsed_s);
            show_window(game, can_change);
            Gui::discard();
        }
        gui_->begin(elapsed_s);
        show_window(game, can_change);
        gui_->end();
    }

  private:
    void show_window(const Game& game, bool can_change) {
        const engine::Size size = game.context().services.renderer.logical_size();
        const auto width = static_cast<float>(size.width);
        const auto height = static_cast<float>(size.height);
        ImGui::SetNextWindowPos({0.62f * width, 20}, ImGuiCond_FirstUseEver);
        ImGui::SetNextWindowSize({0.36f * width, 0.85f * height}, ImGuiCond_FirstUseEver);
        if (ImGui::Begin("Inspector (F10)")) show_tabs(game, can_change);
        gui_->note_window();
        ImGui::End();
    }

    void show_tabs(const Game& game, bool can_change) {
        const Context& context = game.context();
        if (!can_change)
            ImGui::TextColored({0.95f, 0.76f, 0.46f, 1}, "The run is recorded or replayed: read only.");
        if (!ImGui::BeginTabBar("pages")) return;
        if (!context.worlds.empty()) {
            physics::World& world = *context.worlds[selection_.world]->world;
            if (ImGui::BeginTabItem("World")) {
                show_world_page(context, selection_, can_change);
                ImGui::EndTabItem();
            }
            if (ImGui::BeginTabItem("Bodies", nullptr,
                                    std::exchange(shows_bodies_, false) ? ImGuiTabItemFlags_SetSelected
                                                                        : ImGuiTabItemFlags_None)) {
                show_bodies_page(world, selection_, can_change);
                ImGui::EndTabItem();
            }
            if (ImGui::BeginTabItem("Joints")) {
                show_joints_page(world, selection_, can_change);
                ImGui::EndTabItem();
            }
        }
        if (ImGui::BeginTabItem("Script")) {
            update_values(game);
            show_script_page(values_);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("Assets")) {
            show_assets_page(context);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("Log")) {
            show_log_page(log_.lines());
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }

    /// Four times a second: reading all values takes its time.
    void update_values(const Game& game) {
        const Clock::time_point now = Clock::now();
        if (now < next_values_) return;
        next_values_ = now + std::chrono::milliseconds(250);
        values_ = values_of_game(game.lua());
    }

    /// The body under a point of the picture, through the camera that was attached last.
    bool pick(const Context& context, engine::Vec2 point) {
        if (!context.world_view) return false;
        const engine::Vec2 p = context.world_view->inverse().apply(point);
        for (std::size_t i = 0; i < context.worlds.size(); ++i) {
            const physics::World& world = *context.worlds[i]->world;
            const auto shape = world.shape_at({static_cast<double>(p.x), static_cast<double>(p.y)});
            if (!shape || !*shape) continue;
            selection_ = {.world = i, .body = world.shape(**shape)->body()};
            shows_bodies_ = true;
            return true;
        }
        return false;
    }

    void mark_selection(const Context& context) const {
        if (selection_.world >= context.worlds.size() || !context.world_view) return;
        const physics::World& world = *context.worlds[selection_.world]->world;
        const auto body = world.body(selection_.body);
        if (!body) return;
        const physics::Position center = body->world_center();
        const engine::Vec2 p =
            context.world_view->apply({static_cast<float>(center.x), static_cast<float>(center.y)});
        context.services.renderer.reset_transform();
        context.services.renderer.outline_circle(p, 14, 3, {1, 1, 1, 0.9f});
        context.services.renderer.outline_circle(p, 17, 2, {0, 0, 0, 0.6f});
    }

    std::unique_ptr<Gui> gui_;
    LogKeeper log_;
    Selection selection_;
    bool is_new_ = true;
    bool shows_bodies_ = false;
    bool is_picking_ = false;
    std::vector<LuaValue> values_;
    Clock::time_point next_values_{};
    Clock::time_point then_ = Clock::now();
};

}  // namespace

engine::Result<std::unique_ptr<Inspector>> Inspector::create(const Services& services) {
    auto gui = Gui::create(services.files, services.renderer);
    if (!gui) return gui.error();
    return std::unique_ptr<Inspector>(std::make_unique<ImguiInspector>(*std::move(gui)));
}

}  // namespace cairn::scripting
