// What each kind of joint holds, limits and stretches, straight from its definition. Glossary: d offset from
// anchor a to anchor b, u axis of a slider, K inverse effective mass along a direction J: K = J 1/M J^T.
// A spring of f Hz has the stiffness (2 pi f)^2 / K, with what its two bodies weigh along its direction.
#include "world/joint_measures.h"

#include <algorithm>
#include <cmath>

#include "world/joint_frames.h"
#include "world/joint_lists.h"

namespace cairn::physics {
namespace {

Motion motion_of(const BodyStore& bodies, int body) {
    const BodyRecord& record = bodies.slots[body];
    const BodyRows& rows = bodies.rows(record.set);
    Motion motion;
    motion.v = rows.velocity[record.row];
    motion.w = rows.spin[record.row];
    motion.inverse_mass = record.inverse_mass;
    motion.inverse_inertia = record.inverse_inertia;
    motion.locked = locked_axes(record);
    return motion;
}

Vec2 velocity_at(const Motion& body, Vec2 arm) {
    return body.v + cross(body.w, arm);
}

/// How frame b stands to frame a.
struct Stance {
    Motion a;
    Motion b;
    Vec2 r_a;  // from the centres to the anchors
    Vec2 r_b;
    Vec2 d;
    Vec2 velocity;     // of anchor b, as body a sees it
    Vec2 axis;         // x axis of frame a
    double angle = 0;  // with whole turns
    float spin = 0;

    [[nodiscard]] float along(Vec2 u) const { return dot(d, u); }
    [[nodiscard]] float speed_along(Vec2 u) const { return dot(velocity, u); }
};

Stance stance_of(const Stores& stores, int joint) {
    const BodyStore& bodies = stores.bodies;
    const JointRecord& record = stores.joints.slots[joint];
    const Position from = anchor_a(bodies, record);
    const Position to = anchor_b(bodies, record);
    Stance s;
    s.a = motion_of(bodies, record.body_a);
    s.b = motion_of(bodies, record.body_b);
    s.r_a = from - bodies.places[record.body_a].center;
    s.r_b = to - bodies.places[record.body_b].center;
    s.d = to - from;
    s.velocity = velocity_at(s.b, s.r_b) - velocity_at(s.a, s.r_a + s.d);
    const Rotation frame_a = Rotation::from_angle(static_cast<double>(frames_of(record.def).angle_a_rad));
    s.axis = rotate(bodies.places[record.body_a].rotation * frame_a, {1, 0});
    s.angle = joint_angle(bodies, record, memory_of(stores.joints, joint).angle_rad);
    s.spin = s.b.w - s.a.w;
    return s;
}

/// K between two directions of the offset.
double coupling(const Stance& s, Vec2 u, Vec2 w) {
    const float linear = dot(u, velocity_change(s.a, w)) + dot(u, velocity_change(s.b, w));
    const float angular = s.a.inverse_inertia * cross(s.r_a, u) * cross(s.r_a, w) +
                          s.b.inverse_inertia * cross(s.r_b, u) * cross(s.r_b, w);
    return static_cast<double>(linear + angular);
}

double squared(double x) {
    return x * x;
}

double half_stiffness(float frequency_hz) {
    return 0.5 * squared(2 * static_cast<double>(kPi) * static_cast<double>(frequency_hz));
}

/// Adds up what the joints are asked about, one after another.
class Meter {
  public:
    explicit Meter(const Stores& stores) : stores_(stores) {}

    void measure(int joint) {
        joint_ = joint;
        s_ = stance_of(stores_, joint);
        std::visit(*this, stores_.joints.slots[joint].def);
    }

    [[nodiscard]] const JointErrors& found() const { return found_; }

    // The kinds, for std::visit.

    void operator()(const DistanceJointDef& def) {
        const float distance = length(s_.d);
        const Vec2 u = normalized(s_.d);
        if (!def.enable_spring) {
            hold(distance - def.length_m, s_.speed_along(u));
            return;
        }
        stretch(def.frequency_hz, distance - def.length_m, coupling(s_, u, u));
        limit(def.min_length_m > 0 ? def.min_length_m : -kUnlimited, def.max_length_m, distance,
              s_.speed_along(u));
    }
    void operator()(const RevoluteJointDef& def) {
        hold_point();
        if (def.enable_limit) limit_angle(def.lower_rad, def.upper_rad);
        if (def.enable_spring) twist(def.frequency_hz, def.target_rad);
    }
    void operator()(const PrismaticJointDef& def) {
        hold_angle();
        slide(def);
    }
    void operator()(const WheelJointDef& def) { slide(def); }
    void operator()(const WeldJointDef& def) {
        if (def.linear_frequency_hz > 0) {
            stretch_point(def.linear_frequency_hz);
        } else {
            hold_point();
        }
        if (def.angular_frequency_hz > 0) {
            twist(def.angular_frequency_hz, 0);
        } else {
            hold_angle();
        }
    }
    void operator()(const MotorJointDef& def) {
        stretch_point(def.linear_frequency_hz);
        twist(def.angular_frequency_hz, def.target_angle_rad);
    }
    void operator()(const MouseJointDef& def) { stretch_point(def.frequency_hz); }
    void operator()(const GearJointDef& def) {
        const JointRecord& gear = stores_.joints.slots[joint_];
        double sum = -gear.geared_sum;
        float rate = 0;
        for (const auto& [id, ratio] : {std::pair(def.joint_1, 1.0f), std::pair(def.joint_2, def.ratio)}) {
            const int joint = stores_.joints.slots.find(id);
            const Stance geared = stance_of(stores_, joint);
            const bool turns = kind_of(stores_.joints.slots[joint]) == JointKind::Revolute;
            const double at = turns ? geared.angle : static_cast<double>(geared.along(geared.axis));
            sum += static_cast<double>(ratio) * at;
            rate += ratio * (turns ? geared.spin : geared.speed_along(geared.axis));
        }
        const int first = stores_.joints.slots.find(def.joint_1);
        if (kind_of(stores_.joints.slots[first]) == JointKind::Revolute) {
            hold_angle(static_cast<float>(sum), rate);
        } else {
            hold(static_cast<float>(sum), rate);
        }
    }
    void operator()(const PulleyJointDef& def) {
        const JointRecord& record = stores_.joints.slots[joint_];
        const Vec2 e_a = anchor_a(stores_.bodies, record) - def.wheel_a_m;
        const Vec2 e_b = anchor_b(stores_.bodies, record) - def.wheel_b_m;
        const float speed_a = dot(normalized(e_a), velocity_at(s_.a, s_.r_a));
        const float speed_b = dot(normalized(e_b), velocity_at(s_.b, s_.r_b));
        limit(-kUnlimited, def.length_m, length(e_a) + def.ratio * length(e_b),
              speed_a + def.ratio * speed_b);
    }
    void operator()(const FrictionJointDef&) {}
    void operator()(const FilterJointDef&) {}

  private:
    static void raise(float& most, float value) { most = std::max(most, std::fabs(value)); }

    void hold(float error_m, float speed_m_s) {
        raise(found_.error_m, error_m);
        raise(found_.residual_m_s, speed_m_s);
    }
    void hold_angle(float error_rad, float speed_rad_s) {
        raise(found_.error_rad, error_rad);
        raise(found_.residual_rad_s, speed_rad_s);
    }
    void hold_point() { hold(length(s_.d), length(s_.velocity)); }
    void hold_angle() { hold_angle(static_cast<float>(s_.angle), s_.spin); }

    void limit(float lower, float upper, float at, float speed) {
        if (at <= lower) hold(lower - at, std::min(speed, 0.0f));
        if (at >= upper) hold(at - upper, std::max(speed, 0.0f));
    }
    void limit_angle(float lower, float upper) {
        const double below = static_cast<double>(lower) - s_.angle;
        const double above = s_.angle - static_cast<double>(upper);
        if (below >= 0) hold_angle(static_cast<float>(below), std::min(s_.spin, 0.0f));
        if (above >= 0) hold_angle(static_cast<float>(above), std::max(s_.spin, 0.0f));
    }

    template <class Def>
    void slide(const Def& def) {
        const Vec2 n = left_perp(s_.axis);
        hold(s_.along(n), s_.speed_along(n));
        if (def.enable_limit) limit(def.lower_m, def.upper_m, s_.along(s_.axis), s_.speed_along(s_.axis));
        if (def.enable_spring)
            stretch(def.frequency_hz, s_.along(s_.axis) - def.target_m, coupling(s_, s_.axis, s_.axis));
    }

    void stretch(float frequency_hz, float by_m, double k) {
        if (k > 0) found_.elastic_energy_j += half_stiffness(frequency_hz) * squared(by_m) / k;
    }
    void twist(float frequency_hz, float target_rad) {
        const double k = static_cast<double>(s_.a.inverse_inertia + s_.b.inverse_inertia);
        if (k > 0)
            found_.elastic_energy_j +=
                half_stiffness(frequency_hz) * squared(s_.angle - static_cast<double>(target_rad)) / k;
    }
    /// d . K^-1 d, of both directions together.
    void stretch_point(float frequency_hz) {
        const double xx = coupling(s_, {1, 0}, {1, 0});
        const double xy = coupling(s_, {1, 0}, {0, 1});
        const double yy = coupling(s_, {0, 1}, {0, 1});
        const double determinant = xx * yy - xy * xy;
        if (!(determinant > 0)) return;
        const auto x = static_cast<double>(s_.d.x);
        const auto y = static_cast<double>(s_.d.y);
        found_.elastic_energy_j +=
            half_stiffness(frequency_hz) * (yy * x * x - 2 * xy * x * y + xx * y * y) / determinant;
    }

    const Stores& stores_;
    int joint_ = kNone;
    Stance s_;
    JointErrors found_;
};

}  // namespace

JointErrors measure_joints(const Stores& stores) {
    Meter meter(stores);
    for (int joint = 0; joint < stores.joints.slots.end_index(); ++joint) {
        if (stores.joints.slots.alive(joint)) meter.measure(joint);
    }
    return meter.found();
}

}  // namespace cairn::physics
