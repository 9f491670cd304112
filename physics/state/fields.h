// The members of the records that a snapshot holds, each list once for writing, reading and measuring. Those
// of contacts, whose flags are packed, stand in state/contact_state.cpp.
//
// A list names all members of its record in a structured binding, and the compiler refuses a binding with a
// name too few: a new member cannot be forgotten. It then says which of them go into the snapshot; a comment
// says from what the others follow. Containers are bound in the same way in state/access.h.
#pragma once

#include <concepts>
#include <type_traits>

#include "world/world_state.h"

namespace cairn::physics {

/// T or const T: the same list writes and reads.
template <class R, class T>
concept Is = std::same_as<std::remove_const_t<R>, T>;

template <Is<AxisLocks> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [x, y, rotation] = r;
    visit(x, y, rotation);
}

template <Is<MassData> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [mass_kg, inertia_kg_m2, center_m] = r;
    visit(mass_kg, inertia_kg_m2, center_m);
}

/// The set and the row follow from the rows; lists from the links; the place among the breakable bodies from
/// those.
template <Is<BodyRecord> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [type, set, allow_sleep, locks, row, inverse_mass, inverse_inertia, extent_m, turn_arm_m,
           center_arm_m, inner_radius_m, linear_damping, angular_damping, gravity_scale, sleep_speed,
           first_shape, first_contact, first_joint, mass, last_shape, first_sensor, breakable, joint_inertia,
           next_sleeper, user_data] = r;
    visit(type, allow_sleep, locks, inverse_mass, inverse_inertia, extent_m, turn_arm_m, center_arm_m,
          inner_radius_m, linear_damping, angular_damping, gravity_scale, sleep_speed, mass);
}

/// The row follows from the rows.
template <Is<Place> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [center, rotation, row, flags] = r;
    visit(center, rotation, flags);
}

template <Is<MassSum> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [mass, moment_x, moment_y, inertia] = r;
    visit(mass, moment_x, moment_y, inertia);
}

/// That it is listed follows from the list.
template <Is<MassLedger::Entry> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [sum, is_listed, is_outdated, lacks_shapes] = r;
    visit(sum, is_outdated, lacks_shapes);
}

template <Is<Outline> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [kind, count, radius_m, points_m] = r;
    visit(kind, count, radius_m, points_m);
}

template <Is<Convex> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [owns_end, is_box, centroid, half_size, outline, normals] = r;
    // Names are bound by place: what is moved in the struct would be written elsewhere.
    static_assert(std::is_same_v<std::remove_const_t<decltype(is_box)>, bool> &&
                  std::is_same_v<std::remove_const_t<decltype(half_size)>, Vec2>);
    visit(outline, normals, centroid, owns_end, is_box, half_size);
}

template <Is<Material> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [friction, restitution, rolling_resistance, surface_speed, kind] = r;
    visit(friction, restitution, rolling_resistance, surface_speed, kind);
}

template <Is<Filter> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [categories, mask, group] = r;
    visit(categories, mask, group);
}

template <Is<ShapeDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [density, material, filter, contact_events, hit_events, sensor, seen_by_sensors, one_way_normal,
           user_data] = r;
    visit(density, material, filter, contact_events, hit_events, sensor, seen_by_sensors, one_way_normal,
          user_data);
}

/// What a shape is made of, which many shapes have alike.
struct ShapeMake {
    Convex convex;
    ShapeDef def;
    float margin_m = 0;
};

/// Of a shape: its neighbours on the body follow from the links, its chain and its place among the sensors
/// from those.
inline ShapeMake make_of(const ShapeRecord& record) {
    const auto& [body, previous_of_body, next_of_body, chain, sensor, margin_m, prototype, user_data, group] =
        record;
    return {record.convex(), record.def(), margin_m};
}

template <Is<ShapeMake> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [convex, def, margin_m] = r;
    visit(convex, def, margin_m);
}

template <Is<FractureDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [pattern, pieces, seed, min_width_m, radius_m, grain, release] = r;
    visit(pattern, pieces, seed, min_width_m, radius_m, grain, release);
}

template <Is<BreakableDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [strength_ns, fracture, generations, automatic, gives_back] = r;
    visit(strength_ns, fracture, generations, automatic, gives_back);
}

template <Is<Breakable> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body, def] = r;
    visit(body, def);
}

template <Is<MixRule> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [mixing, fixed] = r;
    visit(mixing, fixed);
}

template <Is<MaterialRule> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [friction, restitution] = r;
    visit(friction, restitution);
}

template <Is<ContactMemory> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [features, impulse, friction_impulse] = r;
    visit(features, impulse, friction_impulse);
}

// Joints.

template <Is<JointStiffness> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [frequency_hz, damping_ratio] = r;
    visit(frequency_hz, damping_ratio);
}

template <Is<JointStrength> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [break_force_n, break_torque_nm] = r;
    visit(break_force_n, break_torque_nm);
}

template <Is<DistanceJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, anchor_a, anchor_b, length, spring, frequency, damping, min_force, max_force,
           min_length, max_length, stiffness, strength, collide, user_data] = r;
    visit(body_a, body_b, anchor_a, anchor_b, length, spring, frequency, damping, min_force, max_force,
          min_length, max_length, stiffness, strength, collide, user_data);
}

template <Is<RevoluteJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, anchor_a, anchor_b, angle_a, angle_b, limit, lower, upper, motor, motor_speed,
           max_torque, spring, frequency, damping, target, stiffness, strength, collide, user_data] = r;
    visit(body_a, body_b, anchor_a, anchor_b, angle_a, angle_b, limit, lower, upper, motor, motor_speed,
          max_torque, spring, frequency, damping, target, stiffness, strength, collide, user_data);
}

template <Is<PrismaticJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, anchor_a, anchor_b, angle_a, angle_b, limit, lower, upper, motor, motor_speed,
           max_force, spring, frequency, damping, target, stiffness, strength, collide, user_data] = r;
    visit(body_a, body_b, anchor_a, anchor_b, angle_a, angle_b, limit, lower, upper, motor, motor_speed,
          max_force, spring, frequency, damping, target, stiffness, strength, collide, user_data);
}

template <Is<WeldJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, anchor_a, anchor_b, angle_a, angle_b, linear_frequency, linear_damping,
           angular_frequency, angular_damping, stiffness, strength, collide, user_data] = r;
    visit(body_a, body_b, anchor_a, anchor_b, angle_a, angle_b, linear_frequency, linear_damping,
          angular_frequency, angular_damping, stiffness, strength, collide, user_data);
}

template <Is<WheelJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, anchor_a, anchor_b, angle_a, spring, frequency, damping, target, limit, lower,
           upper, motor, motor_speed, max_torque, stiffness, strength, collide, user_data] = r;
    visit(body_a, body_b, anchor_a, anchor_b, angle_a, spring, frequency, damping, target, limit, lower,
          upper, motor, motor_speed, max_torque, stiffness, strength, collide, user_data);
}

template <Is<MotorJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, anchor_a, anchor_b, angle_a, angle_b, offset, angle, linear_velocity,
           angular_velocity, linear_frequency, linear_damping, angular_frequency, angular_damping, max_force,
           max_torque, strength, collide, user_data] = r;
    visit(body_a, body_b, anchor_a, anchor_b, angle_a, angle_b, offset, angle, linear_velocity,
          angular_velocity, linear_frequency, linear_damping, angular_frequency, angular_damping, max_force,
          max_torque, strength, collide, user_data);
}

template <Is<MouseJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, target, anchor_b, frequency, damping, max_force, strength, collide, user_data] = r;
    visit(body_a, body_b, target, anchor_b, frequency, damping, max_force, strength, collide, user_data);
}

template <Is<GearJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [joint_1, joint_2, ratio, stiffness, strength, collide, user_data] = r;
    visit(joint_1, joint_2, ratio, stiffness, strength, collide, user_data);
}

template <Is<PulleyJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, anchor_a, anchor_b, wheel_a, wheel_b, ratio, length, stiffness, strength, collide,
           user_data] = r;
    visit(body_a, body_b, anchor_a, anchor_b, wheel_a, wheel_b, ratio, length, stiffness, strength, collide,
          user_data);
}

template <Is<FrictionJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, anchor_a, anchor_b, max_force, max_torque, collide, user_data] = r;
    visit(body_a, body_b, anchor_a, anchor_b, max_force, max_torque, collide, user_data);
}

template <Is<FilterJointDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body_a, body_b, user_data] = r;
    visit(body_a, body_b, user_data);
}

template <Is<LastSteps> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [h_s, longest_h_s, since_s] = r;
    visit(h_s, longest_h_s, since_s);
}

/// Bodies follow from the links, the rest from the lists and lanes.
template <Is<JointRecord> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [def, body_a, body_b, edges, active_index, swept_index, seat, direct, collide_connected, stepped,
           softened_hz, line_a, line_b, user_data, angle_rad, geared_sum, impulse, load_n, load_known,
           reaction_force, reaction_torque] = r;
    visit(def, direct, collide_connected, stepped, softened_hz, line_a, line_b, user_data, angle_rad,
          geared_sum, impulse, load_n, load_known, reaction_force, reaction_torque);
}

template <Is<AnchorBlock> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [joint, body_a, body_b, local_ax, local_ay, local_bx, local_by, cosine, sine, turns, breakable] = r;
    visit(joint, body_a, body_b, local_ax, local_ay, local_bx, local_by, cosine, sine, turns, breakable);
}

// Events.

template <Is<ContactBegin> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [shape_a, shape_b, body_a, body_b, point, normal] = r;
    visit(shape_a, shape_b, body_a, body_b, point, normal);
}

template <Is<ContactEnd> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [shape_a, shape_b, body_a, body_b] = r;
    visit(shape_a, shape_b, body_a, body_b);
}

template <Is<ContactHit> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [shape_a, shape_b, body_a, body_b, point, normal, approach_speed, impulse] = r;
    visit(shape_a, shape_b, body_a, body_b, point, normal, approach_speed, impulse);
}

template <Is<JointBreak> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [joint, kind, body_a, body_b, point, force, torque, user_data] = r;
    visit(joint, kind, body_a, body_b, point, force, torque, user_data);
}

/// The pieces are part of a list of all, and written as a range of that.
template <Is<BodyBreak> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [body, other, point, normal, approach_speed, impulse, pieces] = r;
    visit(body, other, point, normal, approach_speed, impulse);
}

template <Is<Overload> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [event, excess_ns] = r;
    visit(event, excess_ns);
}

template <Is<SensorBegin> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [sensor, visitor, sensor_body, visitor_body] = r;
    visit(sensor, visitor, sensor_body, visitor_body);
}

template <Is<SensorEnd> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [sensor, visitor, sensor_body, visitor_body] = r;
    visit(sensor, visitor, sensor_body, visitor_body);
}

/// How the world simulates; on which threads is no part of it.
template <Is<WorldDef> R, class Visit>
[[gnu::always_inline]] constexpr void fields(R& r, Visit&& visit) {
    auto& [gravity, substeps, joint_solver, enable_sleep, hit_speed, restitution_speed, max_push_out_speed,
           threads, tasks] = r;
    visit(gravity, substeps, joint_solver, enable_sleep, hit_speed, restitution_speed, max_push_out_speed);
}

}  // namespace cairn::physics
