// Layers from back to front: boxes, shapes, joints, contacts.
#include "debug/debug_draw.h"

#include <array>
#include <cmath>
#include <set>
#include <unordered_map>

#include "bind/outline_corners.h"
#include "debug/debug_pen.h"

namespace cairn::scripting {
namespace {

using engine::Color;
using engine::Vec2;
using physics::BodyType;

constexpr Color kStatic{0.55f, 0.75f, 0.60f, 1};
constexpr Color kKinematic{0.45f, 0.66f, 0.95f, 1};
constexpr Color kDynamic{0.98f, 0.72f, 0.42f, 1};
constexpr Color kSensor{0.93f, 0.86f, 0.35f, 1};
constexpr Color kNormal{0.98f, 0.32f, 0.30f, 1};
constexpr Color kGap{0.98f, 0.80f, 0.45f, 1};
constexpr Color kFriction{0.40f, 0.80f, 1.00f, 1};
constexpr Color kBox{0.80f, 0.45f, 0.95f, 0.65f};
constexpr Color kCenter{1, 1, 1, 0.9f};
constexpr float kFillAlpha = 0.34f;
constexpr float kSleepShade = 0.55f;  // of the color of a body that is awake

Color shaded(Color color, float factor) {
    return {factor * color.r, factor * color.g, factor * color.b, color.a};
}

/// Neighbouring numbers get colors far apart. Source: turning the hue by the golden section.
Color color_of_island(int island) {
    const double turns = 0.61803398875 * island;
    const auto hue = static_cast<float>(6 * (turns - std::floor(turns)));
    const auto part = [&](float shift) {
        const float k = std::fmod(shift + hue, 6.0f);
        return 0.95f * (1 - 0.6f * std::clamp(std::min(k, 4 - k), 0.0f, 1.0f));
    };
    return {part(5), part(3), part(1), 1};
}

/// What the picture shows, in metres.
struct View {
    Vec2 low;
    Vec2 high;
    [[nodiscard]] bool shows(Vec2 center, float radius) const {
        return center.x + radius >= low.x && center.x - radius <= high.x && center.y + radius >= low.y &&
               center.y - radius <= high.y;
    }
};

View view_of(const engine::Renderer& renderer) {
    const engine::Size size = renderer.target_size();
    const engine::Affine2 world_from_screen = renderer.transform().inverse();
    const auto width = static_cast<float>(size.width);
    const auto height = static_cast<float>(size.height);
    View view{world_from_screen.apply({}), world_from_screen.apply({})};
    for (const Vec2 corner : {Vec2{width, 0}, Vec2{0, height}, Vec2{width, height}}) {
        const Vec2 p = world_from_screen.apply(corner);
        view.low = {std::min(view.low.x, p.x), std::min(view.low.y, p.y)};
        view.high = {std::max(view.high.x, p.x), std::max(view.high.y, p.y)};
    }
    return view;
}

float reach_of(const physics::Outline& outline) {
    float reach = 0;
    for (int i = 0; i < outline.count; ++i) reach = std::max(reach, length(outline.points_m[i]));
    return reach + outline.radius_m;
}

/// In the frame of the body, which the transform on top leads from.
void draw_outline(const DebugPen& pen, const physics::Outline& outline, Color color, bool is_sensor) {
    constexpr float kRim_px = 1.5f;
    engine::Renderer& renderer = pen.renderer();
    const auto corner = [&](int i) { return Vec2{outline.points_m[i].x, outline.points_m[i].y}; };
    Color fill = color;
    fill.a = is_sensor ? 0.4f * kFillAlpha : kFillAlpha;
    if (outline.count == 1) {
        renderer.fill_circle(corner(0), outline.radius_m, fill);
        renderer.outline_circle(corner(0), outline.radius_m, pen.pixels(kRim_px), color);
        // A spoke tells how it is turned.
        pen.line(corner(0), corner(0) + Vec2{outline.radius_m, 0}, kRim_px, color);
    } else if (outline.count == 2 && outline.radius_m == 0) {
        pen.line(corner(0), corner(1), 2 * kRim_px, color);
    } else {
        const std::vector<Vec2> corners = rounded_corners(outline);
        renderer.fill_convex_polygon(corners, fill);
        renderer.outline_polygon(corners, pen.pixels(kRim_px), color);
    }
}

class WorldPainter {
  public:
    WorldPainter(engine::Renderer& renderer, const physics::World& world, const DebugDrawOptions& options)
        : pen_(renderer, world, options.alpha), options_(options), view_(view_of(renderer)) {}

    void draw() {
        if (options_.islands) {
            for (const physics::DebugIsland& island : pen_.world().debug_islands())
                islands_.emplace(island.body.bits(), island.island);
        }
        if (options_.boxes) draw_boxes();
        // One walk for both would draw joints between shapes.
        if (options_.shapes || options_.centers)
            for (const physics::BodyId id : pen_.world().bodies()) draw_body(id);
        if (options_.joints) draw_joints();
        if (options_.contacts) draw_contacts();
    }

  private:
    void draw_boxes() const {
        for (const physics::DebugBox& box : pen_.world().debug_boxes()) {
            const Vec2 low = DebugPen::to_picture(box.lower_m);
            const Vec2 high = DebugPen::to_picture(box.upper_m);
            if (!view_.shows(0.5f * (low + high), 0.5f * engine::length(high - low))) continue;
            pen_.renderer().outline_rectangle({low.x, low.y, high.x - low.x, high.y - low.y}, pen_.pixels(1),
                                              kBox);
        }
    }

    [[nodiscard]] Color color_of(const physics::Body& body) const {
        if (body.type() == BodyType::Static) return kStatic;
        Color color = body.type() == BodyType::Kinematic ? kKinematic : kDynamic;
        const auto island = islands_.find(body.id().bits());
        if (island != islands_.end()) color = color_of_island(island->second);
        return body.is_awake() ? color : shaded(color, kSleepShade);
    }

    void draw_body(physics::BodyId id) const {
        const auto found = pen_.world().body(id);
        if (!found) return;
        const physics::Body& body = *found;
        engine::Renderer& renderer = pen_.renderer();
        const physics::Transform xf = pen_.place(body);
        const Vec2 origin = DebugPen::to_picture(xf.p);
        if (!renderer.push_transform()) return;  // the game has used up the stack
        renderer.translate(origin);
        renderer.rotate(xf.q.angle_rad());
        float reach = 0;
        if (options_.shapes) {
            for (const physics::ShapeId shape_id : body.shapes()) {
                const auto shape = pen_.world().shape(shape_id);
                if (!shape) continue;
                reach = std::max(reach, reach_of(shape->outline()));
                if (!view_.shows(origin, reach_of(shape->outline()))) continue;
                const Color color = shape->is_sensor() ? kSensor : color_of(body);
                draw_outline(pen_, shape->outline(), color, shape->is_sensor());
            }
        }
        if (body.type() == BodyType::Dynamic && view_.shows(origin, 0)) draw_axes(body, reach);
        static_cast<void>(renderer.pop_transform());
    }

    /// The centre of mass, and the direction in which the body's x axis points.
    void draw_axes(const physics::Body& body, float reach_m) const {
        const physics::Vec2 center = body.mass_data().center_m;
        const Vec2 c{center.x, center.y};
        const float most = reach_m > 0 ? 0.5f * reach_m : pen_.pixels(9);  // small bodies have small marks
        const auto arm = [&](float length_px) { return std::min(pen_.pixels(length_px), most); };
        if (options_.shapes) pen_.line(c, c + Vec2{arm(9), 0}, 1, color_of(body));
        if (!options_.centers) return;
        pen_.line(c - Vec2{arm(5), 0}, c + Vec2{arm(5), 0}, 1.5f, kCenter);
        pen_.line(c - Vec2{0, arm(5)}, c + Vec2{0, arm(5)}, 1.5f, kCenter);
    }

    void draw_joints() const {
        std::set<std::uint64_t> drawn;  // each is in the lists of two bodies
        for (const physics::BodyId id : pen_.world().bodies()) {
            for (const physics::JointId joint_id : pen_.world().body(id)->joints()) {
                if (!drawn.insert(joint_id.bits()).second) continue;
                if (const auto joint = pen_.world().joint(joint_id)) draw_joint_marks(pen_, *joint);
            }
        }
    }

    /// How long an impulse is drawn: it grows with its logarithm, so that a tower's foot fits on the screen
    /// beside its top.
    [[nodiscard]] float length_of(float impulse_ns) const {
        constexpr float kReference_ns = 0.02f;  // a tenth of what 1 kg at rest gives in a step
        constexpr float kLongest_px = 140;
        const float length_px = 9 * std::log2(1 + std::fabs(impulse_ns) / kReference_ns);
        return std::copysign(pen_.pixels(std::min(length_px, kLongest_px)), impulse_ns);
    }

    void draw_contacts() const {
        for (const physics::DebugContact& contact : pen_.world().debug_contacts()) {
            const Vec2 normal{contact.normal.x, contact.normal.y};
            const Vec2 tangent{contact.normal.y, -contact.normal.x};
            Vec2 middle{};
            for (int i = 0; i < contact.count; ++i) {
                const physics::DebugContactPoint& point = contact.points[i];
                const Vec2 p = pen_.at(contact.body_b, point.point_m);
                middle = middle + (1.0f / static_cast<float>(contact.count)) * p;
                if (!view_.shows(p, pen_.pixels(150))) continue;
                const Color color = point.separation_m <= 0 || point.impulse_ns > 0 ? kNormal : kGap;
                pen_.line(p, p + (pen_.pixels(5) + length_of(point.impulse_ns)) * normal, 2, color);
                pen_.dot(p, 3, color);
            }
            if (contact.count > 0 && contact.friction_impulse_ns != 0)
                pen_.line(middle, middle + length_of(contact.friction_impulse_ns) * tangent, 2, kFriction);
        }
    }

    DebugPen pen_;
    const DebugDrawOptions& options_;
    View view_;
    std::unordered_map<std::uint64_t, int> islands_;  // only looked up, by handle bits
};

}  // namespace

void draw_debug(engine::Renderer& renderer, const physics::World& world, const DebugDrawOptions& options) {
    WorldPainter(renderer, world, options).draw();
}

}  // namespace cairn::scripting
