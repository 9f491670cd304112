// Lines of text above a graph of the last frames.
#include "debug/profiler_overlay.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <unistd.h>

#include "bind/physics_objects.h"
#include "debug/colors.h"

namespace cairn::scripting {
namespace {

using engine::Color;

constexpr Color kPhysics{0.98f, 0.72f, 0.42f, 1};
constexpr Color kScripts{0.55f, 0.78f, 0.98f, 1};
constexpr Color kDraw{0.62f, 0.86f, 0.56f, 1};
constexpr Color kPresent{0.72f, 0.66f, 0.90f, 1};
constexpr Color kBudget{0.95f, 0.35f, 0.32f, 0.8f};
constexpr double kBudget_ms = 1000.0 / 60;

[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...) {
    char line[160];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    return line;
}

/// 0 where the system does not tell.
double resident_mb() {
    long pages = 0;
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (file == nullptr) return 0;
    if (std::fscanf(file, "%*s %ld", &pages) != 1) pages = 0;
    std::fclose(file);
    return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// Of an update, what is not physics. The physics is measured per step; the rest is the scripts'.
double scripts_ms(const FrameFigures& frame) {
    return std::max(0.0, frame[FramePart::Update] - frame.physics_ms);
}

/// Lines of text, one below the other, with a color mark before those that the graph shows.
class Sheet {
  public:
    Sheet(engine::Renderer& renderer, engine::FontId font, float x, float y)
        : renderer_(renderer), font_(font), x_(x), y_(y), line_(1.2f * renderer.line_height(font)) {}

    void write(const std::string& left, const std::string& right, Color color, bool has_mark = false) {
        if (has_mark) renderer_.fill_rectangle({x_, y_ + 0.3f * line_, 0.4f * line_, 0.4f * line_}, color);
        renderer_.draw_text(font_, left, {.position = {x_ + 0.8f * line_, y_}, .color = panel::kQuiet});
        renderer_.draw_text(font_, right,
                            {.position = {x_ + 7 * line_, y_}, .color = has_mark ? color : panel::kText});
        y_ += line_;
    }
    [[nodiscard]] float y() const { return y_; }
    [[nodiscard]] float line() const { return line_; }

  private:
    engine::Renderer& renderer_;
    engine::FontId font_;
    float x_;
    float y_;
    float line_;
};

/// One column per frame, oldest at the left; the red line is what 60 pictures a second allow.
void draw_graph(engine::Renderer& renderer, const FrameMeter& meter, const engine::Rect& area) {
    constexpr double kTop_ms = 2 * kBudget_ms;
    const std::vector<FrameFigures> frames = meter.history();
    const float width = area.width / static_cast<float>(FrameMeter::kHistory);
    const auto height = [&](double ms) {
        return area.height * static_cast<float>(std::min(ms, kTop_ms) / kTop_ms);
    };
    std::vector<engine::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const FrameFigures& frame = frames[i];
        const float left = area.x + area.width - width * static_cast<float>(frames.size() - i);
        double total_ms = 0;
        const auto add = [&](double ms, Color color) {
            const float low = area.y + area.height - height(total_ms);
            total_ms += ms;
            const float high = area.y + area.height - height(total_ms);
            const auto first = static_cast<std::uint32_t>(vertices.size());
            for (const engine::Vec2 p : {engine::Vec2{left, low}, engine::Vec2{left + width, low},
                                         engine::Vec2{left + width, high}, engine::Vec2{left, high}})
                vertices.push_back({p, color});
            for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + corner);
        };
        add(frame.physics_ms, kPhysics);
        add(scripts_ms(frame), kScripts);
        add(frame[FramePart::Draw], kDraw);
        add(frame[FramePart::Present], kPresent);
    }
    renderer.draw_mesh(vertices, indices);
    const float budget = area.y + area.height - height(kBudget_ms);
    renderer.draw_line({area.x, budget}, {area.x + area.width, budget}, 1, kBudget, engine::LineCap::Butt);
}

}  // namespace

void ProfilerOverlay::update_slow(const Context& context) {
    constexpr int kFramesBetween = 20;
    if (frames_until_slow_-- > 0) return;
    frames_until_slow_ = kFramesBetween;
    slow_ = {};
    for (const WorldObject* object : context.worlds) {
        const physics::WorldReport report = object->world->report();
        const physics::Counts& counts = report.counts;
        slow_.counts.bodies += counts.bodies;
        slow_.counts.awake_bodies += counts.awake_bodies;
        slow_.counts.shapes += counts.shapes;
        slow_.counts.joints += counts.joints;
        slow_.counts.contacts += counts.contacts;
        slow_.counts.touching += counts.touching;
        slow_.islands += report.islands;
        const auto worst = [](double& known, float found) {
            known = std::max(known, static_cast<double>(found));
        };
        worst(slow_.penetration_m, report.max_penetration_m);
        worst(slow_.joint_error_m, report.max_joint_error_m);
        worst(slow_.joint_error_rad, report.max_joint_error_rad);
    }
    slow_.resident_mb = resident_mb();
}

void ProfilerOverlay::draw(const FrameMeter& meter, const Context& context, std::size_t lua_bytes,
                           engine::FontId font) {
    update_slow(context);
    engine::Renderer& renderer = context.services.renderer;
    const FrameFigures mean = meter.mean();
    double slowest_ms = 0;
    for (const FrameFigures& frame : meter.history()) slowest_ms = std::max(slowest_ms, frame.frame_ms);

    const float line = 1.2f * renderer.line_height(font);
    const float margin = 0.5f * line;
    const float width = 20 * line;
    const float graph_height = 5 * line;
    constexpr int kLines = 14 + static_cast<int>(physics::kStages.size());
    renderer.fill_rectangle({0, 0, width + 2 * margin, kLines * line + graph_height + 3 * margin},
                            panel::kGround);

    Sheet sheet(renderer, font, margin, margin);
    sheet.write("frame", text("%.1f ms, slowest of 240: %.1f", mean.frame_ms, slowest_ms), panel::kText);
    sheet.write("physics", text("%.2f ms", mean.physics_ms), kPhysics, true);
    for (const physics::Stage stage : physics::kStages)
        sheet.write("  " + std::string(name(stage)), text("%.3f", mean.stages[stage]), panel::kText);
    sheet.write("scripts", text("%.2f ms", scripts_ms(mean)), kScripts, true);
    sheet.write("draw", text("%.2f ms", mean[FramePart::Draw]), kDraw, true);
    sheet.write("present", text("%.2f ms", mean[FramePart::Present]), kPresent, true);
    sheet.write("overlap", text("%.3g mm at most", 1e3 * slow_.penetration_m), panel::kText);
    sheet.write("joint error",
                text("%.3g mm, %.3g mrad", 1e3 * slow_.joint_error_m, 1e3 * slow_.joint_error_rad),
                panel::kText);
    const physics::Counts& counts = slow_.counts;
    sheet.write("bodies", text("%d, %d awake; %d shapes", counts.bodies, counts.awake_bodies, counts.shapes),
                panel::kText);
    sheet.write("contacts", text("%d, %d touch", counts.contacts, counts.touching), panel::kText);
    sheet.write("joints", text("%d", counts.joints), panel::kText);
    sheet.write("islands", text("%d awake", slow_.islands), panel::kText);
    const engine::RenderStats& stats = renderer.stats();
    sheet.write("drawn", text("%d calls, %d triangles", stats.draw_calls, stats.triangles), panel::kText);
    sheet.write("memory",
                text("%.0f MB, Lua %.2f MB", slow_.resident_mb, static_cast<double>(lua_bytes) / (1 << 20)),
                panel::kText);
    sheet.write("garbage", text("%.2f kB a frame", static_cast<double>(mean.lua_allocated) / 1024),
                panel::kText);
    draw_graph(renderer, meter, {margin, sheet.y() + margin, width, graph_height});
}

}  // namespace cairn::scripting
