// Upkeep of lanes, and the order of the passes.
#include "resolve/contact_lanes.h"

#include <algorithm>

#include "resolve/contact_kernels.h"

namespace cairn::physics {
namespace {

void copy_pair(PairBlock& to, int to_lane, const PairBlock& from, int from_lane) {
    const auto copy = [&](auto& t, const auto& f) { t[to_lane] = f[from_lane]; };
    copy(to.contact, from.contact);
    copy(to.body_a, from.body_a);
    copy(to.body_b, from.body_b);
    copy(to.shape_a, from.shape_a);
    copy(to.shape_b, from.shape_b);
    copy(to.boxes.half_ax, from.boxes.half_ax);
    copy(to.boxes.half_ay, from.boxes.half_ay);
    copy(to.boxes.half_bx, from.boxes.half_bx);
    copy(to.boxes.half_by, from.boxes.half_by);
    copy(to.boxes.offset_ax, from.boxes.offset_ax);
    copy(to.boxes.offset_ay, from.boxes.offset_ay);
    copy(to.boxes.offset_bx, from.boxes.offset_bx);
    copy(to.boxes.offset_by, from.boxes.offset_by);
    for (int i = 0; i < 2; ++i) copy(to.features[i], from.features[i]);
    const auto copy_bit = [&](std::uint8_t& t, std::uint8_t f) {
        const int bit = f >> from_lane & 1;
        t = static_cast<std::uint8_t>((t & ~(1 << to_lane)) | bit << to_lane);
    };
    copy_bit(to.reports, from.reports);
    copy_bit(to.remembers, from.remembers);
}

void write_pair(PairBlock& to, int lane, const PairLane& from) {
    to.contact[lane] = from.contact;
    to.body_a[lane] = from.body_a;
    to.body_b[lane] = from.body_b;
    to.shape_a[lane] = from.shape_a;
    to.shape_b[lane] = from.shape_b;
    to.boxes.half_ax[lane] = from.half_a.x;
    to.boxes.half_ay[lane] = from.half_a.y;
    to.boxes.half_bx[lane] = from.half_b.x;
    to.boxes.half_by[lane] = from.half_b.y;
    to.boxes.offset_ax[lane] = from.offset_a.x;
    to.boxes.offset_ay[lane] = from.offset_a.y;
    to.boxes.offset_bx[lane] = from.offset_b.x;
    to.boxes.offset_by[lane] = from.offset_b.y;
    for (auto& features : to.features) features[lane] = kNoFeature;
    const auto put_bit = [lane](std::uint8_t& bits, bool on) {
        bits = static_cast<std::uint8_t>((bits & ~(1 << lane)) | (on ? 1 : 0) << lane);
    };
    put_bit(to.reports, from.reports);
    put_bit(to.remembers, from.remembers);
}

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
}

// Room that a bucket begins with, so that contacts that come and go in a settled scene allocate nothing.
constexpr std::size_t kFirstBlocks = 16;

}  // namespace

int ContactLanes::add(int bucket, const PairLane& pair) {
    LaneBucket& in = buckets_[bucket];
    const int lane = in.lanes++;
    const int block = lane / kLanes;
    if (block == static_cast<int>(in.pairs.size())) {
        if (in.pairs.capacity() == 0) {
            in.pairs.reserve(kFirstBlocks);
            in.blocks.reserve(is_colored(bucket) ? kFirstBlocks : 0);
        }
        in.pairs.emplace_back();
        for (int i = 0; i < kLanes; ++i) write_pair(in.pairs.back(), i, PairLane{});
        if (is_colored(bucket)) {
            in.blocks.emplace_back();
            for (int i = 0; i < kLanes; ++i) clear_lane(in.blocks.back(), i);
        }
    }
    write_pair(in.pairs[block], lane % kLanes, pair);
    end_ = std::max(end_, bucket + 1);
    return lane;
}

int ContactLanes::remove(int bucket, int lane) {
    LaneBucket& in = buckets_[bucket];
    const int last = --in.lanes;
    PairBlock& to = in.pairs[lane / kLanes];
    PairBlock& from = in.pairs[last / kLanes];
    copy_pair(to, lane % kLanes, from, last % kLanes);
    if (is_colored(bucket)) {
        copy_lane(in.blocks[lane / kLanes], lane % kLanes, in.blocks[last / kLanes], last % kLanes);
        clear_lane(in.blocks[last / kLanes], last % kLanes);
    }
    write_pair(from, last % kLanes, PairLane{});
    return last == lane ? kNone : to.contact[lane % kLanes];
}

ContactMemory ContactLanes::memory(int bucket, int lane) const {
    const PairBlock& pairs = buckets_[bucket].pairs[lane / kLanes];
    const ContactBlock& block = buckets_[bucket].blocks[lane / kLanes];
    ContactMemory memory;
    for (int i = 0; i < 2; ++i) {
        memory.features[i] = pairs.features[i][lane % kLanes];
        memory.impulse[i] = block.points[i].impulse[lane % kLanes];
    }
    memory.friction_impulse = block.friction_impulse[lane % kLanes];
    return memory;
}

void ContactLanes::set_memory(int bucket, int lane, const ContactMemory& memory) {
    PairBlock& pairs = buckets_[bucket].pairs[lane / kLanes];
    ContactBlock& block = buckets_[bucket].blocks[lane / kLanes];
    for (int i = 0; i < 2; ++i) {
        pairs.features[i][lane % kLanes] = memory.features[i];
        block.points[i].impulse[lane % kLanes] = memory.impulse[i];
    }
    block.friction_impulse[lane % kLanes] = memory.friction_impulse;
}

void ContactLanes::set_friction(int bucket, int lane, float friction) {
    buckets_[bucket].blocks[lane / kLanes].friction[lane % kLanes] = friction;
}

void ContactLanes::blank(int bucket, int lane) {
    ContactBlock& block = buckets_[bucket].blocks[lane / kLanes];
    const float friction = block.friction[lane % kLanes];
    clear_lane(block, lane % kLanes);
    block.friction[lane % kLanes] = friction;
}

void ContactLanes::warm_start(Motions& motions, float step_ratio, float friction_ratio) {
    for (int i = kFirstColored; i < end_; ++i) {
        LaneBucket& in = buckets_[i];
        warm_start_blocks({in.blocks.data(), static_cast<std::size_t>(in.block_count())}, kind_of(i),
                          motions.velocity.data(), step_ratio, friction_ratio);
    }
}

void ContactLanes::solve(Motions& motions, const ContactRules& rules, float h_s, Pass pass) {
    for (int i = kFirstColored; i < end_; ++i) {
        LaneBucket& in = buckets_[i];
        if (in.lanes == 0) continue;
        const BlockKind kind = kind_of(i);
        const ContactPassTime time{
            kind == BlockKind::TwoBodies ? rules.dynamic_softness : rules.static_softness, 1 / h_s,
            rules.max_push_out_speed_m_s};
        const std::span blocks(in.blocks.data(), static_cast<std::size_t>(in.block_count()));
        if (pass == Pass::Biased) {
            solve_blocks(blocks, kind, motions.velocity.data(), time);
        } else {
            relax_blocks(blocks, kind, motions.velocity.data(), motions.pose.data(), time);
        }
    }
}

}  // namespace cairn::physics
