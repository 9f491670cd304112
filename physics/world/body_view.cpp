// The public Body view.
#include <cairn/physics/body.h>

#include "world/bodies.h"
#include "world/sleep.h"
#include "world/validation.h"

namespace cairn::physics {
namespace {

struct Row {
    BodyRecord& record;
    BodyRows& rows;
    Place& place;
    int row;
    int body;
};

int settled_slot(WorldState& world, BodyId id) {
    const int body = world.stores.bodies.slots.find(id);
    CAIRN_ASSERT(body != kNone, "a Body view was used after its body was destroyed");
    settle_mass(world.stores, body);
    return body;
}

Row row_of(WorldState& world, BodyId id) {
    const int body = settled_slot(world, id);
    BodyRecord& record = world.stores.bodies.slots[body];
    return {record, world.stores.bodies.rows(record.set), world.stores.bodies.places[body], record.row, body};
}

// The row of a body about to move by outside cause: awake, with its rest time restarted.
Row woken_row_of(WorldState& world, BodyId id) {
    wake_body(world.stores, row_of(world, id).body);
    return row_of(world, id);
}

// What hangs on a kinematic body by joints slept while that stood still. What touches it wakes in the step.
void wake_carried(WorldState& world, const Row& at) {
    if (at.record.type != BodyType::Kinematic) return;
    if (at.rows.velocity[at.row] != Vec2{} || at.rows.spin[at.row] != 0) wake_jointed(world.stores, at.body);
}

bool is_dynamic(const Row& at) {
    return at.record.type == BodyType::Dynamic;
}

void add_impulse(const Row& at, Vec2 impulse, Vec2 arm) {
    at.rows.velocity[at.row] += without_locked(at.record.inverse_mass * impulse, locked_axes(at.record));
    at.rows.spin[at.row] += at.record.inverse_inertia * cross(arm, impulse);
}

}  // namespace

BodyType Body::type() const {
    return row_of(*world_, id_).record.type;
}

Position Body::position() const {
    const int body = settled_slot(*world_, id_);
    return world_->stores.bodies.origin(body);
}

Transform Body::transform() const {
    return world_->stores.bodies.transform(settled_slot(*world_, id_));
}

Transform Body::interpolated_transform(float alpha) const {
    const Row at = row_of(*world_, id_);
    const Rotation before = at.rows.rotation_before[at.row];
    const Rotation after = at.place.rotation;
    const float turned = (inverse(before) * after).angle_rad();
    const Rotation q = Rotation::from_angle(static_cast<double>(alpha * turned)) * before;
    const Position center = at.place.center + (alpha - 1) * at.rows.moved[at.row];
    return {center + -rotate(q, at.record.mass.center_m), q};
}

Position Body::world_center() const {
    const Row at = row_of(*world_, id_);
    return at.place.center;
}

Result<void> Body::set_transform(Position position_m, double angle_rad) {
    if (auto fault = check::first_of(
            {check::placed("body.position_m", position_m), check::finite("body.angle_rad", angle_rad)})) {
        return *fault;
    }
    teleport(world_->stores, row_of(*world_, id_).body, position_m, angle_rad);
    return {};
}

Vec2 Body::linear_velocity() const {
    const Row at = row_of(*world_, id_);
    return at.rows.velocity[at.row];
}

float Body::angular_velocity() const {
    const Row at = row_of(*world_, id_);
    return at.rows.spin[at.row];
}

Vec2 Body::velocity_at(Position point_m) const {
    const Row at = row_of(*world_, id_);
    return at.rows.velocity[at.row] + cross(at.rows.spin[at.row], point_m - at.place.center);
}

Result<void> Body::set_linear_velocity(Vec2 velocity_m_s) {
    if (auto fault = check::finite("body.linear_velocity_m_s", velocity_m_s)) return *fault;
    if (type() == BodyType::Static) return {};
    const Row at = woken_row_of(*world_, id_);
    at.rows.velocity[at.row] = without_locked(velocity_m_s, locked_axes(at.record));
    wake_carried(*world_, at);
    return {};
}

Result<void> Body::set_angular_velocity(float velocity_rad_s) {
    const auto value = static_cast<double>(velocity_rad_s);
    if (auto fault = check::finite("body.angular_velocity_rad_s", value)) return *fault;
    if (type() == BodyType::Static) return {};
    const Row at = woken_row_of(*world_, id_);
    at.rows.spin[at.row] = turning_is_locked(at.record) ? 0 : velocity_rad_s;
    wake_carried(*world_, at);
    return {};
}

Result<void> Body::apply_force(Vec2 force_n, Position point_m) {
    if (auto fault =
            check::first_of({check::finite("force_n", force_n), check::finite("point_m", point_m)})) {
        return *fault;
    }
    if (!is_dynamic(row_of(*world_, id_))) return {};
    const Row at = woken_row_of(*world_, id_);
    at.rows.force[at.row] += force_n;
    at.rows.torque[at.row] += cross(point_m - at.place.center, force_n);
    return {};
}

Result<void> Body::apply_force_to_center(Vec2 force_n) {
    return apply_force(force_n, world_center());
}

Result<void> Body::apply_torque(float torque_nm) {
    if (auto fault = check::finite("torque_nm", static_cast<double>(torque_nm))) return *fault;
    if (!is_dynamic(row_of(*world_, id_))) return {};
    const Row at = woken_row_of(*world_, id_);
    at.rows.torque[at.row] += torque_nm;
    return {};
}

Result<void> Body::apply_impulse(Vec2 impulse_ns, Position point_m) {
    if (auto fault =
            check::first_of({check::finite("impulse_ns", impulse_ns), check::finite("point_m", point_m)})) {
        return *fault;
    }
    if (!is_dynamic(row_of(*world_, id_))) return {};
    const Row at = woken_row_of(*world_, id_);
    add_impulse(at, impulse_ns, point_m - at.place.center);
    return {};
}

Result<void> Body::apply_impulse_to_center(Vec2 impulse_ns) {
    return apply_impulse(impulse_ns, world_center());
}

Result<void> Body::apply_angular_impulse(float impulse_nms) {
    if (auto fault = check::finite("impulse_nms", static_cast<double>(impulse_nms))) return *fault;
    if (!is_dynamic(row_of(*world_, id_))) return {};
    const Row at = woken_row_of(*world_, id_);
    at.rows.spin[at.row] += at.record.inverse_inertia * impulse_nms;
    return {};
}

MassData Body::mass_data() const {
    return row_of(*world_, id_).record.mass;
}
float Body::linear_damping() const {
    return row_of(*world_, id_).record.linear_damping_1_s;
}
float Body::angular_damping() const {
    return row_of(*world_, id_).record.angular_damping_1_s;
}
float Body::gravity_scale() const {
    return row_of(*world_, id_).record.gravity_scale;
}

Result<void> Body::set_linear_damping(float damping_1_s) {
    if (auto fault = check::not_negative("body.linear_damping_1_s", static_cast<double>(damping_1_s)))
        return *fault;
    row_of(*world_, id_).record.linear_damping_1_s = damping_1_s;
    return {};
}

Result<void> Body::set_angular_damping(float damping_1_s) {
    if (auto fault = check::not_negative("body.angular_damping_1_s", static_cast<double>(damping_1_s))) {
        return *fault;
    }
    row_of(*world_, id_).record.angular_damping_1_s = damping_1_s;
    return {};
}

Result<void> Body::set_gravity_scale(float scale) {
    if (auto fault = check::finite("body.gravity_scale", static_cast<double>(scale))) return *fault;
    row_of(*world_, id_).record.gravity_scale = scale;
    wake_body(world_->stores, row_of(*world_, id_).body);
    return {};
}

AxisLocks Body::locks() const {
    return row_of(*world_, id_).record.locks;
}

void Body::set_locks(AxisLocks locks) {
    const Row at = row_of(*world_, id_);
    if (at.record.locks != locks) physics::set_locks(world_->stores, at.body, locks);
}

bool Body::is_awake() const {
    return row_of(*world_, id_).record.set == RowSet::Awake;
}

void Body::set_awake(bool awake) {
    const int body = row_of(*world_, id_).body;
    if (awake) {
        wake_body(world_->stores, body);
    } else {
        put_island_to_sleep(world_->stores, world_->scratch, body);
    }
}

bool Body::allows_sleep() const {
    return row_of(*world_, id_).record.allow_sleep;
}

void Body::set_allow_sleep(bool allow) {
    const Row at = row_of(*world_, id_);
    at.record.allow_sleep = allow;
    if (!allow) wake_body(world_->stores, at.body);
}

float Body::sleep_speed() const {
    return row_of(*world_, id_).record.sleep_speed_m_s;
}

Result<void> Body::set_sleep_speed(float speed_m_s) {
    if (auto fault = check::not_negative("body.sleep_speed_m_s", static_cast<double>(speed_m_s)))
        return *fault;
    row_of(*world_, id_).record.sleep_speed_m_s = speed_m_s;
    return {};
}

std::vector<ShapeId> Body::shapes() const {
    const Stores& stores = world_->stores;
    std::vector<ShapeId> result;
    const BodyRecord& record = row_of(*world_, id_).record;
    for (const int first : {record.first_shape, record.first_sensor}) {
        for (int s = first; s != kNone; s = stores.shapes[s].next_of_body) {
            result.push_back(stores.shapes.id(s));
        }
    }
    return result;
}

std::vector<JointId> Body::joints() const {
    const Stores& stores = world_->stores;
    std::vector<JointId> result;
    for_each_edge(stores.joints.slots, row_of(*world_, id_).record.first_joint,
                  [&](int joint, int) { result.push_back(stores.joints.slots.id(joint)); });
    return result;
}

std::uint64_t Body::user_data() const {
    return row_of(*world_, id_).record.user_data;
}
void Body::set_user_data(std::uint64_t data) {
    row_of(*world_, id_).record.user_data = data;
}

}  // namespace cairn::physics
