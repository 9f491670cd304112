// Lanes of blocks, one by one.
#include "resolve/contact_block.h"

#include "base/motion.h"

namespace cairn::physics {

void copy_lane(ContactBlock& to, int to_lane, const ContactBlock& from, int from_lane) {
    const auto copy = [&](auto& t, const auto& f) { t[to_lane] = f[from_lane]; };
    copy(to.a, from.a);
    copy(to.b, from.b);
    copy(to.normal_x, from.normal_x);
    copy(to.normal_y, from.normal_y);
    for (int i = 0; i < 2; ++i) {
        ContactBlockPoint& t = to.points[i];
        const ContactBlockPoint& f = from.points[i];
        copy(t.arm_a, f.arm_a);
        copy(t.arm_b, f.arm_b);
        copy(t.mass, f.mass);
        copy(t.start_separation, f.start_separation);
        copy(t.separation, f.separation);
        copy(t.static_impulse, f.static_impulse);
        copy(t.impulse, f.impulse);
        copy(to.total_impulse[i], from.total_impulse[i]);
    }
    copy(to.tangent_arm_a, from.tangent_arm_a);
    copy(to.tangent_arm_b, from.tangent_arm_b);
    copy(to.tangent_mass, from.tangent_mass);
    copy(to.friction, from.friction);
    copy(to.friction_impulse, from.friction_impulse);
    to.reports = to.reports || from.reports;
    copy_lane_bit(to.bounces, to_lane, from.bounces, from_lane);
}

void copy_lane(TurnLanes& to, int to_lane, const TurnLanes& from, int from_lane) {
    to.bow_a[to_lane] = from.bow_a[from_lane];
    to.bow_b[to_lane] = from.bow_b[from_lane];
    for (int i = 0; i < 2; ++i) to.bend[i][to_lane] = from.bend[i][from_lane];
    copy_lane_bit(to.used, to_lane, from.used, from_lane);
}

void clear_lane(ContactBlock& block, int lane) {
    block.a[lane] = block.b[lane] = kWorldRow;
    block.normal_x[lane] = block.normal_y[lane] = 0;
    for (int i = 0; i < 2; ++i) {
        ContactBlockPoint& point = block.points[i];
        point.arm_a[lane] = point.arm_b[lane] = point.mass[lane] = 0;
        point.start_separation[lane] = point.separation[lane] = 1;
        point.static_impulse[lane] = point.impulse[lane] = 0;
        block.total_impulse[i][lane] = 0;
    }
    block.tangent_arm_a[lane] = block.tangent_arm_b[lane] = block.tangent_mass[lane] = 0;
    block.friction[lane] = block.friction_impulse[lane] = 0;
    set_lane_bit(block.bounces, lane, false);
}

void copy_outcome(ContactBlock& to, int to_lane, const ContactBlock& from, int from_lane) {
    for (int i = 0; i < 2; ++i) {
        to.points[i].separation[to_lane] = from.points[i].separation[from_lane];
        to.points[i].impulse[to_lane] = from.points[i].impulse[from_lane];
        if (to.reports) to.total_impulse[i][to_lane] = from.total_impulse[i][from_lane];
    }
    to.friction_impulse[to_lane] = from.friction_impulse[from_lane];
}

}  // namespace cairn::physics
