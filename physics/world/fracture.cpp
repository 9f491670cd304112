// Pieces move as the material moved: v_i = v + w x (c_i - c). With the sum of the masses that of the body,
// and the middle of them all where its centre was, the momentum is m v to rounding. Angular momentum is I w:
// what little the inertia of all pieces differs from that of the body (arcs became chords, slivers went) the
// angular velocity takes up.
#include "world/fracture.h"

#include "collide/distance.h"
#include "world/bodies.h"
#include "world/breakables.h"
#include "world/joint_frames.h"
#include "world/joint_rules.h"
#include "world/joints.h"
#include "world/sleep.h"

namespace cairn::physics {
namespace {

struct Point {
    double x = 0;
    double y = 0;
};

Point center_of(const MassSum& sum) {
    return {sum.moment_x / sum.mass, sum.moment_y / sum.mass};
}

double central_inertia(const MassSum& sum) {
    const Point c = center_of(sum);
    return sum.inertia - sum.mass * (c.x * c.x + c.y * c.y);
}

// What the pieces take over from the body: all of it is copied, as the body will go.
struct Heritage {
    BodyRecord record;
    Transform xf;
    Position center;
    Vec2 center_before;  // the way back to where the centre was before the last step
    Rotation rotation_before;
    Vec2 velocity;
    float spin = 0;
    Vec2 acceleration;  // by the forces for the next step
    float angular_acceleration = 0;
};

Heritage heritage_of(const Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    const BodyRows& rows = stores.bodies.rows_of(body);
    const int row = record.row;
    Heritage h;
    h.record = record;
    h.xf = stores.bodies.transform(body);
    h.center = stores.bodies.places[body].center;
    h.center_before = -rows.moved[row];
    h.rotation_before = rows.rotation_before[row];
    h.velocity = rows.velocity[row];
    h.spin = rows.spin[row];
    const float mass = record.mass.mass_kg;
    const float inertia = record.mass.inertia_kg_m2;
    if (mass > 0) h.acceleration = (1 / mass) * rows.force[row];
    if (inertia > 0) h.angular_acceleration = rows.torque[row] / inertia;
    return h;
}

// How the frame of the pieces differs from that of the body, and their common turning.
struct Correction {
    Vec2 shift;        // in the body's frame, m
    float spin_ratio;  // angular velocity after to before
};

Correction conserving(const Stores& stores, int body, const FracturePlan& plan) {
    MassSum before;
    for_each_solid_shape(stores, body, [&](int s) {
        const ShapeRecord& shape = stores.shapes[s];
        before += mass_of(shape.convex(), static_cast<double>(shape.def().density_kg_m2));
    });
    MassSum after;
    for (const Piece& piece : plan) after += piece.mass;
    if (stores.bodies.slots[body].type != BodyType::Dynamic || !(before.mass > 0)) return {{}, 1};
    const Point old_center = center_of(before);
    const Point new_center = center_of(after);
    return {
        {static_cast<float>(old_center.x - new_center.x), static_cast<float>(old_center.y - new_center.y)},
        static_cast<float>(central_inertia(before) / central_inertia(after))};
}

BodyDef def_of(const Heritage& h, const Piece& piece) {
    BodyDef def;
    def.type = piece.is_released ? BodyType::Dynamic : h.record.type;
    def.linear_damping_1_s = h.record.linear_damping_1_s;
    def.angular_damping_1_s = h.record.angular_damping_1_s;
    def.gravity_scale = h.record.gravity_scale;
    def.locks = h.record.locks;
    def.allow_sleep = h.record.allow_sleep;
    def.sleep_speed_m_s = h.record.sleep_speed_m_s;
    def.user_data = h.record.user_data;
    return def;
}

void set_motion(Stores& stores, int body, const Heritage& h, float spin_ratio) {
    const BodyRecord& record = stores.bodies.slots[body];
    if (record.type == BodyType::Static) return;
    BodyRows& rows = stores.bodies.rows_of(body);
    const int row = record.row;
    const std::uint8_t locked = locked_axes(record);
    const Vec2 arm = stores.bodies.places[body].center - h.center;
    const float spin = turning_is_locked(record) ? 0 : spin_ratio * h.spin;
    rows.velocity[row] = without_locked(h.velocity + cross(spin, arm), locked);
    rows.spin[row] = spin;
    rows.force[row] = record.mass.mass_kg * (h.acceleration + cross(h.angular_acceleration, arm));
    rows.torque[row] = record.mass.inertia_kg_m2 * h.angular_acceleration;
    // For drawing between steps: where this part of the body was before the last one.
    const Vec2 arm_before = rotate(h.rotation_before, inverse_rotate(h.xf.q, arm));
    rows.moved[row] = arm - (h.center_before + arm_before);
    rows.rotation_before[row] = h.rotation_before;
}

int make_piece(Stores& stores, const Heritage& h, const Piece& piece, const Correction& correction) {
    const int body = create_body(stores, def_of(h, piece));
    Place& place = stores.bodies.places[body];
    place.center = h.xf.p + rotate(h.xf.q, correction.shift);
    place.rotation = h.xf.q;
    for (const PieceShape& shape : piece.shapes) {
        ShapeDef def = stores.shapes[shape.source].def();
        def.density_kg_m2 = shape.density_kg_m2;
        create_shape(stores, body, shape.convex, def);
    }
    set_motion(stores, body, h, correction.spin_ratio);
    return body;
}

// The piece that holds the point, in the frame of the body, or comes nearest to it.
std::size_t piece_at(const FracturePlan& plan, Vec2 point) {
    Convex speck;
    speck.outline.count = 1;
    std::size_t nearest = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < plan.size(); ++i) {
        for (const PieceShape& shape : plan[i].shapes) {
            const float distance = distance_between(shape.convex, speck, {point, {}}).distance;
            if (distance >= least) continue;
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

void hand_over_sensors(Stores& stores, int body, const FracturePlan& plan, const std::vector<int>& pieces) {
    for (int s = stores.bodies.slots[body].first_sensor; s != kNone; s = stores.shapes[s].next_of_body) {
        const Convex convex = stores.shapes[s].convex();
        const ShapeDef def = stores.shapes[s].def();
        create_shape(stores, pieces[piece_at(plan, convex.centroid)], convex, def);
    }
}

// Gears come last: they go where their joints went.
void hand_over_joints(Stores& stores, int body, const FracturePlan& plan, const std::vector<int>& pieces) {
    const auto& joints = stores.joints.slots;
    for_each_edge(joints, stores.bodies.slots[body].first_joint, [&](int joint, int side) {
        if (kind_of(joints[joint]) == JointKind::Gear) return;
        const JointFrames frames = frames_of(joints[joint].def);
        const Vec2 anchor = side == 0 ? frames.anchor_a_m : frames.anchor_b_m;
        rehang_joint(stores, joint, side, pieces[piece_at(plan, anchor)]);
    });
    for_each_edge(joints, stores.bodies.slots[body].first_joint, [&](int gear, int side) {
        const JointBodies bodies = bodies_of(joints[gear].def, stores);
        rehang_joint(stores, gear, side, side == 0 ? bodies.a : bodies.b);
    });
}

}  // namespace

std::vector<int> divide_body(WorldState& world, int body, const FracturePlan& plan) {
    Stores& stores = world.stores;
    wake_body(stores, body);
    wake_neighbours(stores, body);
    settle_mass(stores, body);
    const Heritage heritage = heritage_of(stores, body);
    const Correction correction = conserving(stores, body, plan);
    std::vector<int> pieces;
    for (const Piece& piece : plan) pieces.push_back(make_piece(stores, heritage, piece, correction));
    hand_over_sensors(stores, body, plan, pieces);
    hand_over_joints(stores, body, plan, pieces);
    inherit_breakable(stores, body, plan, pieces);
    destroy_body(world, body);
    return pieces;
}

check::Fault validate_divisible(const Stores& stores, int body) {
    bool has_lines = false;
    for_each_solid_shape(stores, body,
                         [&](int s) { has_lines = has_lines || stores.shapes[s].convex().is_line(); });
    if (has_lines)
        return Error{"the body has a segment or a chain, but only shapes with an area can be divided"};
    if (stores.bodies.slots[body].first_shape == kNone) {
        return Error{"the body has no shape but sensors, but must have one that can be divided"};
    }
    return {};
}

check::Fault validate_room(const Stores& stores, const FracturePlan& plan) {
    std::size_t shapes = 0;
    for (const Piece& piece : plan) shapes += piece.shapes.size();
    if (plan.size() <= stores.bodies.slots.room() && shapes <= stores.shapes.room()) return {};
    return Error{"the world has no room for " + std::to_string(plan.size()) + " pieces of " +
                 std::to_string(shapes) + " shapes"};
}

}  // namespace cairn::physics
