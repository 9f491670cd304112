// One mark for each kind of joint. What is held rigid is drawn as lines, what is sprung as a zigzag, what is
// limited with bars at the limits.
#include <array>
#include <variant>

#include "debug/debug_pen.h"

namespace cairn::scripting {
namespace {

using engine::Color;
using engine::Vec2;

constexpr Color kRigid{0.35f, 0.85f, 0.85f, 1};
constexpr Color kSpring{0.75f, 0.90f, 0.40f, 1};
constexpr Color kLimit{0.98f, 0.55f, 0.80f, 1};
constexpr Color kQuiet{0.70f, 0.75f, 0.80f, 0.8f};
constexpr float kLine_px = 1.5f;

Vec2 unit(Vec2 v) {
    const float n = engine::length(v);
    return n > 0 ? (1 / n) * v : Vec2{1, 0};
}
Vec2 quarter_turn(Vec2 v) {
    return {-v.y, v.x};
}
Vec2 direction(float angle_rad) {
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

void zigzag(const DebugPen& pen, Vec2 a, Vec2 b) {
    constexpr int kTeeth = 8;
    const Vec2 side = 0.1f * std::min(engine::length(b - a), pen.pixels(40)) * quarter_turn(unit(b - a));
    std::array<Vec2, 2 * kTeeth + 2> points;
    points.front() = a;
    points.back() = b;
    for (int i = 1; i <= 2 * kTeeth; ++i) {
        const float part = 0.1f + 0.8f * (static_cast<float>(i) - 0.5f) / (2 * kTeeth);
        points[static_cast<std::size_t>(i)] = a + part * (b - a) + (i % 2 == 0 ? -1.0f : 1.0f) * side;
    }
    pen.path(points, kLine_px, kSpring);
}

/// What all kinds are drawn from.
struct Places {
    Vec2 anchor_a;
    Vec2 anchor_b;
    Vec2 center_a;
    Vec2 center_b;
    float angle_a_rad;  ///< of body a
    float joint_angle_rad;
    float translation_m;
};

class Marks {
  public:
    /// Marks shrink where bodies are small on the screen, so that a wall of welds is not one spot.
    Marks(const DebugPen& pen, const Places& places) : pen_(pen), at_(places) {
        constexpr float kRoom_px = 40;
        const float apart = engine::length(places.center_b - places.center_a);
        size_ = std::clamp(apart / pen.pixels(kRoom_px), 0.25f, 1.0f);
    }

    void operator()(const physics::DistanceJointDef& def) const {
        arms(false);
        const Vec2 along = unit(at_.anchor_b - at_.anchor_a);
        if (def.enable_spring) {
            if (def.frequency_hz > 0) {
                zigzag(pen_, at_.anchor_a, at_.anchor_b);
            } else {
                pen_.line(at_.anchor_a, at_.anchor_b, 1, kQuiet);
            }
            if (def.min_length_m > 0) bar(at_.anchor_a + def.min_length_m * along, along, kLimit);
            if (def.max_length_m < physics::kUnlimited)
                bar(at_.anchor_a + def.max_length_m * along, along, kLimit);
        } else {
            pen_.line(at_.anchor_a, at_.anchor_b, 2, kRigid);
        }
        ends();
    }
    void operator()(const physics::RevoluteJointDef& def) const {
        arms(true);
        const float zero = at_.angle_a_rad + def.local_angle_a_rad;
        if (def.enable_limit) {
            constexpr float kTurn = 2 * physics::kPi;
            const float upper = std::min(def.upper_rad, def.lower_rad + kTurn);
            pen_.arc(at_.anchor_a, 15 * size_, zero + def.lower_rad, zero + upper, 2, kLimit);
            for (const float end : {def.lower_rad, upper})
                pen_.line(at_.anchor_a, at_.anchor_a + pen_.pixels(15 * size_) * direction(zero + end), 1,
                          kLimit);
        }
        pen_.line(at_.anchor_a,
                  at_.anchor_a + pen_.pixels(13 * size_) * direction(zero + at_.joint_angle_rad), 2,
                  def.enable_spring ? kSpring : kRigid);
        pen_.ring(at_.anchor_a, 5 * size_, 2, kRigid);
        if (def.enable_motor) pen_.dot(at_.anchor_a, 3 * size_, kRigid);
        ends();
    }
    void operator()(const physics::PrismaticJointDef& def) const {
        arms(true);
        slide(def.local_angle_a_rad, def.enable_limit, def.lower_m, def.upper_m, def.enable_spring);
        square(at_.anchor_b);
    }
    void operator()(const physics::WeldJointDef& def) const {
        arms(true);
        const bool is_sprung = def.linear_frequency_hz > 0 || def.angular_frequency_hz > 0;
        diamond(at_.anchor_b, is_sprung ? kSpring : kRigid);
        ends();
    }
    void operator()(const physics::WheelJointDef& def) const {
        arms(false);
        slide(def.local_angle_a_rad, def.enable_limit, def.lower_m, def.upper_m, def.enable_spring);
        pen_.ring(at_.anchor_b, 6 * size_, 2, kRigid);
        if (def.enable_motor) pen_.dot(at_.anchor_b, 3 * size_, kRigid);
    }
    void operator()(const physics::MotorJointDef&) const {
        pen_.dashes(at_.anchor_a, at_.anchor_b, kLine_px, kSpring);
        diamond(at_.anchor_b, kSpring);
        ends();
    }
    void operator()(const physics::MouseJointDef&) const {
        zigzag(pen_, at_.anchor_b, at_.anchor_a);
        const float arm = pen_.pixels(7);
        pen_.line(at_.anchor_a - Vec2{arm, 0}, at_.anchor_a + Vec2{arm, 0}, kLine_px, kSpring);
        pen_.line(at_.anchor_a - Vec2{0, arm}, at_.anchor_a + Vec2{0, arm}, kLine_px, kSpring);
        pen_.dot(at_.anchor_b, 3 * size_, kSpring);
    }
    void operator()(const physics::GearJointDef&) const {
        pen_.dashes(at_.center_a, at_.center_b, kLine_px, kRigid);
        pen_.ring(at_.center_a, 7 * size_, kLine_px, kRigid);
        pen_.ring(at_.center_b, 7 * size_, kLine_px, kRigid);
    }
    void operator()(const physics::PulleyJointDef& def) const {
        const Vec2 wheel_a = DebugPen::to_picture(def.wheel_a_m);
        const Vec2 wheel_b = DebugPen::to_picture(def.wheel_b_m);
        pen_.line(at_.anchor_a, wheel_a, 2, kRigid);
        pen_.line(at_.anchor_b, wheel_b, 2, kRigid);
        pen_.line(wheel_a, wheel_b, 1, kQuiet);
        pen_.ring(wheel_a, 6 * size_, 2, kRigid);
        pen_.ring(wheel_b, 6 * size_, 2, kRigid);
        ends();
    }
    void operator()(const physics::FrictionJointDef&) const {
        const float arm = pen_.pixels(5 * size_);
        pen_.line(at_.anchor_b - Vec2{arm, arm}, at_.anchor_b + Vec2{arm, arm}, 2, kQuiet);
        pen_.line(at_.anchor_b - Vec2{arm, -arm}, at_.anchor_b + Vec2{arm, -arm}, 2, kQuiet);
    }
    void operator()(const physics::FilterJointDef&) const {
        pen_.dashes(at_.center_a, at_.center_b, 1, kQuiet);
    }

  private:
    /// From the bodies to their anchors. The far end of an error of the joint is seen between the anchors.
    void arms(bool shows_error) const {
        pen_.line(at_.center_a, at_.anchor_a, 1, kQuiet);
        pen_.line(at_.center_b, at_.anchor_b, 1, kQuiet);
        if (shows_error) pen_.line(at_.anchor_a, at_.anchor_b, 1, kLimit);
    }
    void ends() const {
        pen_.dot(at_.anchor_a, 2.5f * size_, kRigid);
        pen_.dot(at_.anchor_b, 2.5f * size_, kRigid);
    }
    /// Across a line that leads along `along`.
    void bar(Vec2 p, Vec2 along, Color color) const {
        const Vec2 side = pen_.pixels(6 * size_) * quarter_turn(unit(along));
        pen_.line(p - side, p + side, 2, color);
    }
    void diamond(Vec2 p, Color color) const {
        const float r = pen_.pixels(6 * size_);
        const std::array corners{p + Vec2{r, 0}, p + Vec2{0, r}, p - Vec2{r, 0}, p - Vec2{0, r}};
        pen_.renderer().fill_convex_polygon(corners, color);
    }
    void square(Vec2 p) const {
        const float r = pen_.pixels(4 * size_);
        pen_.renderer().fill_rectangle({p.x - r, p.y - r, 2 * r, 2 * r}, kRigid);
    }
    /// An axis on body a, with the range of what slides along it.
    void slide(float local_angle_rad, bool has_limits, float lower_m, float upper_m, bool has_spring) const {
        const Vec2 axis = direction(at_.angle_a_rad + local_angle_rad);
        const float reach = pen_.pixels(30 * size_);
        const float low = has_limits ? lower_m : std::min(at_.translation_m, 0.0f) - reach;
        const float high = has_limits ? upper_m : std::max(at_.translation_m, 0.0f) + reach;
        pen_.line(at_.anchor_a + low * axis, at_.anchor_a + high * axis, kLine_px, kRigid);
        if (has_limits) {
            bar(at_.anchor_a + low * axis, axis, kLimit);
            bar(at_.anchor_a + high * axis, axis, kLimit);
        }
        if (has_spring) zigzag(pen_, at_.anchor_a, at_.anchor_b);
        pen_.dot(at_.anchor_a, 2.5f * size_, kRigid);
    }

    const DebugPen& pen_;
    const Places& at_;
    float size_ = 1;
};

}  // namespace

void draw_joint_marks(const DebugPen& pen, const physics::Joint& joint) {
    const auto a = pen.world().body(joint.body_a());
    const auto b = pen.world().body(joint.body_b());
    if (!a || !b) return;
    const Places places{.anchor_a = pen.at(a->id(), joint.anchor_a()),
                        .anchor_b = pen.at(b->id(), joint.anchor_b()),
                        .center_a = pen.at(a->id(), a->world_center()),
                        .center_b = pen.at(b->id(), b->world_center()),
                        .angle_a_rad = pen.place(*a).q.angle_rad(),
                        .joint_angle_rad = joint.joint_angle(),
                        .translation_m = joint.translation()};
    std::visit(Marks(pen, places), joint.definition());
}

}  // namespace cairn::scripting
