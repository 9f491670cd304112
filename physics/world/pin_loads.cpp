#include "world/pin_loads.h"

#include "resolve/joints/pin_statics.h"
#include "world/joint_frames.h"
#include "world/joints.h"
#include "world/prepare.h"

namespace cairn::physics {
namespace {

// Wherever the pin is.
Vec2 load_of(const JointStore& joints, const JointRecord& pin) {
    return pin.seat.lane == kNone ? pin.load_n : joints.lanes.load(pin.seat);
}

void set_load(JointStore& joints, JointRecord& pin, Vec2 load_n) {
    pin.load_n = load_n;
    pin.load_known = true;
    if (pin.seat.lane != kNone) joints.lanes.set_load(pin.seat, load_n);
}

// Of pins that bear nothing yet.
void set_first_impulse(JointStore& joints, JointRecord& pin, Vec2 impulse) {
    JointImpulses impulses = pin.seat.lane == kNone ? pin.impulse : joints.lanes.memory(pin.seat).impulse;
    if (impulses != JointImpulses{}) return;
    impulses[impulse_index(0, Role::HoldOrSpring)] = impulse.x;
    impulses[impulse_index(1, Role::HoldOrSpring)] = impulse.y;
    pin.impulse = impulses;
    if (pin.seat.lane != kNone) joints.lanes.set_impulses(pin.seat, impulses);
}

// `local` gets the number in `statics`, by body.
void estimate(Stores& stores, Vec2 gravity_m_s2, const StepTime& time, const DirectStructure& structure,
              PinStatics& statics, std::vector<int>& local) {
    JointStore& joints = stores.joints;
    statics.clear();
    local.assign(static_cast<std::size_t>(stores.bodies.slots.end_index()), PinStatics::kFixed);
    for (const int body : structure.bodies) {
        const BodyRecord& record = stores.bodies.slots[body];
        local[static_cast<std::size_t>(body)] = statics.add_body(record.inverse_mass, record.inverse_inertia,
                                                                 record.gravity_scale * gravity_m_s2);
    }
    for (const int joint : structure.joints) {
        const JointRecord& record = joints.slots[joint];
        const JointFrames frames = frames_of(record.def);
        const auto arm = [&](int body, Vec2 anchor) {
            return rotate(stores.bodies.places[body].rotation,
                          anchor - stores.bodies.slots[body].mass.center_m);
        };
        statics.add_pin(local[static_cast<std::size_t>(record.body_a)],
                        local[static_cast<std::size_t>(record.body_b)], arm(record.body_a, frames.anchor_a_m),
                        arm(record.body_b, frames.anchor_b_m), load_of(joints, record));
    }
    statics.solve();
    for (std::size_t i = 0; i < structure.joints.size(); ++i) {
        JointRecord& pin = joints.slots[structure.joints[i]];
        const Vec2 load_n = statics.force(static_cast<int>(i));
        set_load(joints, pin, load_n);
        set_first_impulse(joints, pin, time.h_s / time.impulse_ratio * load_n);
    }
}

}  // namespace

void estimate_pin_loads(Stores& stores, Vec2 gravity_m_s2, const StepTime& time, DirectGroups& groups) {
    if (groups.without_loads.empty()) return;
    for (const DirectStructure& structure : groups.without_loads)
        estimate(stores, gravity_m_s2, time, structure, groups.statics, groups.number_of);
    groups.search.recycle(groups.without_loads);
}

void forget_loads_around(Stores& stores, int joint) {
    const JointRecord& record = stores.joints.slots[joint];
    for (const int body : {record.body_a, record.body_b}) {
        for_each_edge(stores.joints.slots, stores.bodies.slots[body].first_joint,
                      [&](int other, int) { stores.joints.slots[other].load_known = false; });
    }
}

}  // namespace cairn::physics
