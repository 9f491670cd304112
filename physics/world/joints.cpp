// Joints: creation, change and removal.
#include "world/joints.h"

#include <tuple>

#include "world/contacts.h"
#include "world/joint_frames.h"
#include "world/joint_lists.h"
#include "world/joint_rules.h"
#include "world/pin_loads.h"
#include "world/sleep.h"
#include "world/stiff_springs.h"
#include "world/unheld.h"

namespace cairn::physics {
namespace {

void destroy_contacts_between(WorldState& world, int body_a, int body_b) {
    Stores& stores = world.stores;
    for_each_edge(stores.contacts.slots, stores.bodies.slots[body_a].first_contact,
                  [&](int contact, int side) {
                      const ContactRecord& c = stores.contacts.slots[contact];
                      if ((side == 0 ? c.body_b : c.body_a) == body_b)
                          destroy_contact(stores, world.events, contact);
                  });
    forget_unheld(stores);
}

// Asks for the pairs of a body's shapes again: those that the joint kept apart may meet now.
void look_for_pairs(Stores& stores, int body) {
    for (int shape = stores.bodies.slots[body].first_shape; shape != kNone;
         shape = stores.shapes[shape].next_of_body) {
        stores.broad.touch(shape);
    }
}

bool collides_connected(const JointDef& def) {
    return std::visit(
        [](const auto& d) {
            if constexpr (requires { d.collide_connected; }) {
                return d.collide_connected;
            } else {
                return false;
            }
        },
        def);
}

void settle_pulley(const Stores& stores, JointRecord& record) {
    auto* pulley = std::get_if<PulleyJointDef>(&record.def);
    if (!pulley || pulley->length_m > 0) return;
    pulley->length_m = length(anchor_a(stores.bodies, record) - pulley->wheel_a_m) +
                       pulley->ratio * length(anchor_b(stores.bodies, record) - pulley->wheel_b_m);
}

void settle_gear(Stores& stores, JointRecord& record) {
    const auto* gear = std::get_if<GearJointDef>(&record.def);
    if (!gear) return;
    const auto coordinate = [&](JointId id) {
        const int joint = stores.joints.slots.find(id);
        unseat_joint(stores, joint);
        return gear_coordinate(stores.bodies, stores.joints.slots[joint]);
    };
    record.geared_sum =
        coordinate(gear->joint_1) + static_cast<double>(gear->ratio) * coordinate(gear->joint_2);
}

// Nearer than this, anchors have no line (resolve/joints/distance.cpp).
constexpr float kCoincident_m = 1e-6f;

void settle_line(const BodyStore& bodies, JointRecord& record) {
    if (kind_of(record) != JointKind::Distance) return;
    const Vec2 way = anchor_b(bodies, record) - anchor_a(bodies, record);
    const Vec2 line = length(way) > kCoincident_m ? normalized(way) : Vec2{0, 1};
    record.line_a = rotate(inverse(bodies.places[record.body_a].rotation), line);
    record.line_b = rotate(inverse(bodies.places[record.body_b].rotation), line);
}

// Whether a spring is another one than it was, and not only damped, long or strong in another way.
bool is_set_anew(const JointDef& before, const JointDef& now) {
    const auto* old_rod = std::get_if<DistanceJointDef>(&before);
    const auto* rod = std::get_if<DistanceJointDef>(&now);
    if (!old_rod || !rod) return false;
    const auto setting = [](const DistanceJointDef& def) {
        return std::tuple(def.enable_spring, def.frequency_hz, def.local_anchor_a_m.x, def.local_anchor_a_m.y,
                          def.local_anchor_b_m.x, def.local_anchor_b_m.y);
    };
    return setting(*old_rod) != setting(*rod);
}

void activate_if_awake(Stores& stores, int joint) {
    if (acts(stores.bodies, stores.joints.slots[joint])) list_joint(stores, joint);
}

// The angle to frames that were put elsewhere: of all those whole turns apart, the nearest to what it was.
void turn_frames(const BodyStore& bodies, JointRecord& record, const JointFrames& before) {
    const JointFrames now = frames_of(record.def);
    if (now.angle_a_rad == before.angle_a_rad && now.angle_b_rad == before.angle_b_rad) return;
    record.angle_rad = joint_angle(bodies, record);
}

}  // namespace

int create_joint(WorldState& world, JointDef def) {
    Stores& stores = world.stores;
    JointRecord record;
    const JointBodies bodies = bodies_of(def, stores);
    record.body_a = bodies.a;
    record.body_b = bodies.b;
    record.collide_connected = collides_connected(def);
    record.user_data = std::visit([](const auto& d) { return d.user_data; }, def);
    record.def = std::move(def);
    record.angle_rad = joint_angle(stores.bodies, record);
    settle_line(stores.bodies, record);
    settle_pulley(stores, record);
    settle_gear(stores, record);
    const int joint = stores.joints.slots.insert(record);
    link_edge(stores.joints.slots, stores.bodies.slots[record.body_a].first_joint, joint, 0);
    link_edge(stores.joints.slots, stores.bodies.slots[record.body_b].first_joint, joint, 1);
    wake_joint_bodies(stores, joint);
    activate_if_awake(stores, joint);
    if (!record.collide_connected) destroy_contacts_between(world, record.body_a, record.body_b);
    return joint;
}

void redefine_joint(WorldState& world, int joint, JointDef def) {
    Stores& stores = world.stores;
    unseat_joint(stores, joint);
    forget_loads_around(stores, joint);
    JointRecord& record = stores.joints.slots[joint];
    const bool collided = record.collide_connected;
    record.collide_connected = collides_connected(def);
    record.user_data = std::visit([](const auto& d) { return d.user_data; }, def);
    const JointFrames before = frames_of(record.def);
    const bool sprung = acts_of(record.def).spring_hz > 0;
    const bool is_other_spring = is_set_anew(record.def, def);
    record.def = std::move(def);
    if (is_other_spring) settle_line(stores.bodies, record);
    // A spring that is switched on starts as a new one.
    if (!sprung && acts_of(record.def).spring_hz > 0) {
        record.stepped = false;
        record.softened_hz = 0;
    }
    turn_frames(stores.bodies, record, before);
    settle_pulley(stores, record);
    settle_gear(stores, record);
    wake_joint_bodies(stores, joint);
    if (collided && !record.collide_connected) destroy_contacts_between(world, record.body_a, record.body_b);
    if (!collided && record.collide_connected) look_for_pairs(stores, record.body_a);
}

void rehang_joint(Stores& stores, int joint, int side, int body) {
    auto& joints = stores.joints.slots;
    unlist_joint(stores, joint);
    forget_loads_around(stores, joint);
    JointRecord& record = joints[joint];
    int& end = side == 0 ? record.body_a : record.body_b;
    unlink_edge(joints, stores.bodies.slots[end].first_joint, joint, side);
    end = body;
    link_edge(joints, stores.bodies.slots[end].first_joint, joint, side);
    const BodyId id = stores.bodies.slots.id(body);
    std::visit(
        [&](auto& def) {
            if constexpr (requires { def.body_a; }) (side == 0 ? def.body_a : def.body_b) = id;
        },
        record.def);
    activate_if_awake(stores, joint);
}

void destroy_joint(Stores& stores, int joint) {
    wake_joint_bodies(stores, joint);
    for (int gear = find_gear_on(stores, joint); gear != kNone; gear = find_gear_on(stores, joint)) {
        destroy_joint(stores, gear);
    }
    const JointRecord& record = stores.joints.slots[joint];
    if (!record.collide_connected) look_for_pairs(stores, record.body_a);
    forget_loads_around(stores, joint);
    unlist_joint(stores, joint);
    unlink_edge(stores.joints.slots, stores.bodies.slots[record.body_a].first_joint, joint, 0);
    unlink_edge(stores.joints.slots, stores.bodies.slots[record.body_b].first_joint, joint, 1);
    stores.joints.slots.erase(joint);
}

void wake_joint_bodies(Stores& stores, int joint) {
    wake_body(stores, stores.joints.slots[joint].body_a);
    wake_body(stores, stores.joints.slots[joint].body_b);
}

bool takes_part(const JointRecord& joint) {
    return kind_of(joint) != JointKind::Filter;
}

bool acts(const BodyStore& bodies, const JointRecord& joint) {
    if (!takes_part(joint)) return false;
    const bool a_awake = bodies.is_awake(joint.body_a);
    const bool b_awake = bodies.is_awake(joint.body_b);
    const bool a_moves = bodies.slots[joint.body_a].type == BodyType::Dynamic;
    const bool b_moves = bodies.slots[joint.body_b].type == BodyType::Dynamic;
    if (!a_moves && !b_moves) return a_awake || b_awake;
    return (a_moves && a_awake) || (b_moves && b_awake);
}

}  // namespace cairn::physics
