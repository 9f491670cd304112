// Where revolute and wheel joints live while they act: in SIMD lanes, eight to a block. A joint keeps its
// lane from step to step. Plain pins, which are many, stand apart from those with drives, which take three
// times the memory, and wheels from both. Invariant: of all pools together, within a colour no body that can
// be moved stands in two lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/prefetch.h"
#include "resolve/joints/joint_constraint.h"
#include "resolve/joints/joint_pool.h"
#include "resolve/joints/torn_joints.h"

namespace cairn::physics {

/// What a joint in a lane is to the kernels.
enum class JointLaneKind : std::uint8_t { Pin, Drive, Wheel };

/// The lane of a joint: the number of its block times kLanes, plus the place in it.
struct JointSeat {
    int lane = kNone;  // kNone: it has none
    std::int16_t bucket = 0;
    JointLaneKind kind = JointLaneKind::Pin;  // which pool
};

/// What a joint remembers from step to step, and what it did in the last one.
struct JointMemory {
    JointImpulses impulse{};
    double angle_rad = 0;
    Vec2 reaction_force;
    float reaction_torque = 0;
};

/// What acts on a joint besides what is held, in the units of a substep. Of a pin it acts on the angle, which
/// counts without those of the frames; of a wheel, spring and limits act along the axis and the motor on the
/// spin.
struct DriveLane {
    Softness softness;
    float spring_frequency_rad_s = 0;
    float square = 0;   // (w h)^2
    float damping = 0;  // 2 z w h
    ExactSpring spring{0, 0, 0, true};
    float spring_target = 0;
    float motor_speed = 0;
    float motor_limit = 0;
    float lower = -kNoLimit;
    float upper = kNoLimit;
};

class JointLanes {
  public:
    JointSeat add_pin(int bucket, const AnchorLane& lane);
    JointSeat add_drive(int bucket, const AnchorLane& lane, const DriveLane& drive);
    /// The axis, of length 1, is in the frame of body a.
    JointSeat add_wheel(int bucket, const AnchorLane& lane, Vec2 local_axis, const DriveLane& drive);
    /// Calls drive_of(joint), a DriveLane, for each joint that is not a plain pin.
    template <class DriveOf>
    void set_drives(const DriveOf& drive_of);
    /// The result is the joint that took the freed lane, or kNone.
    int remove(const JointSeat& seat);
    /// The joint of the seat goes to another bucket, and the seat with it. The result is as of `remove`.
    int move(JointSeat& seat, int to_bucket);

    /// Impulses and reaction. The angle is without those of the frames.
    [[nodiscard]] JointMemory memory(const JointSeat& seat) const;
    void set_impulses(const JointSeat& seat, const JointImpulses& impulse);

    /// As of the last `arrange`: blocks in use.
    [[nodiscard]] std::size_t block_count() const {
        return pins_.blocks().size() + drives_.blocks().size() + wheels_.blocks().size();
    }
    void make_room(LaneOrder& order) const {
        order.make_room(std::max({pins_.size(), drives_.size(), wheels_.size()}));
    }
    /// As JointPool::sort, of all pools.
    template <class Tell>
    void sort(std::span<const Place> places, LaneOrder& order, const Tell& tell) {
        for_pools(*this, [&](auto& pool) { pool.sort(places, order, tell); });
    }

    [[nodiscard]] bool empty() const {
        return pins_.blocks().empty() && drives_.blocks().empty() && wheels_.blocks().empty();
    }
    /// Calls visit(anchors, rows, kind) for each block, and asks for the rows ahead.
    template <class Visit>
    void for_each_block(Visit&& visit) const;
    /// Calls visit(bucket, anchors, lane) for each joint.
    template <class Visit>
    void for_each_joint(Visit&& visit) const;
    /// Calls visit(joint) for each joint that can break.
    template <class Visit>
    void for_each_breakable(Visit&& visit) const;

    /// What a plain pin would bear if everything stood still, N; 0: unknown.
    [[nodiscard]] Vec2 load(const JointSeat& seat) const;
    void set_load(const JointSeat& seat, Vec2 force_n);
    [[nodiscard]] const PinBlock& pin_block(int block) const { return pins_.block(block); }

    /// Of the substeps for which the drives were made, s.
    float h_s = 0;
    /// For which they were made, Hz: stiffer springs are softened to it.
    float most_swept_hz = 0;

    // The stages of a step, in their order.

    void arrange();
    /// Where all anchors are. Marks who carries joints without being moved by them. The result is whether
    /// some joint may be torn.
    bool place(const std::vector<Place>& places, Motions& motions, float impulse_ratio, float dt_s,
               TaskPool& tasks);
    /// Makes pins that have loads soft about them. Costs nothing before the first load is set.
    void take_off_loads(const Motions& motions, const PinLoads& loads, TaskPool& tasks);
    /// Hides torn joints from the passes, and appends how they were. Those that are not `is_rigid(joint)` are
    /// let alone; all plain pins are rigid.
    void hide_tears(const std::function<bool(int)>& is_rigid, std::vector<TornJoint>& torn);
    /// Whether springs came, went or changed since `settle_springs` was last told of none that are swept, or
    /// act together otherwise than they did then.
    [[nodiscard]] bool springs_changed() const { return springs_changed_; }
    /// As prepare_springs, in two halves: what each row has of springs, and what comes of it.
    void add_spring_loads(const Motions& motions, std::vector<SpringLoad>& loads, TaskPool& tasks) const;
    void settle_springs(const std::vector<SpringLoad>& loads, bool others, TaskPool& tasks);
    void note_spring_speeds(const Motions& motions, TaskPool& tasks);
    void warm_start(Motions& motions, TaskPool& tasks);
    [[nodiscard]] bool has_crowded_springs() const { return has_crowded_springs_; }
    /// As the function of the same name in joint_solver.h.
    void sweep_crowded_springs(Motions& motions, bool back);
    void solve(Motions& motions, const JointPassTime& time, TaskPool& tasks);
    void relax(Motions& motions, const JointPassTime& time, TaskPool& tasks);

  private:
    friend struct StateAccess;

    // Calls use(pool) for all pools. What comes last is satisfied best, and wheels give on their springs:
    // they are the first.
    template <class Self, class Use>
    static void for_pools(Self& self, const Use& use) {
        use(self.wheels_);
        use(self.pins_);
        use(self.drives_);
    }
    // Those that may have springs.
    template <class Self, class Use>
    static void for_spring_pools(Self& self, const Use& use) {
        use(self.wheels_);
        use(self.drives_);
    }
    template <class Self, class Use>
    static auto with_pool(Self& self, JointLaneKind kind, const Use& use) {
        if (kind == JointLaneKind::Pin) return use(self.pins_);
        return kind == JointLaneKind::Drive ? use(self.drives_) : use(self.wheels_);
    }
    void set_drive(DriveBlock& block, std::size_t lane, const DriveLane& drive);
    void set_drive(WheelBlock& block, std::size_t lane, const DriveLane& drive);

    JointPool<PinBlock> pins_;
    JointPool<DriveBlock> drives_;
    JointPool<WheelBlock> wheels_;
    bool springs_changed_ = false;
    bool has_crowded_springs_ = false;
    bool has_loads_ = false;  // some pin may have one
    float dt_s_ = 0;
};

template <class DriveOf>
void JointLanes::set_drives(const DriveOf& drive_of) {
    for_spring_pools(*this, [&](auto& pool) {
        pool.for_each_lane(pool.blocks(), [&](int block, const AnchorBlock& anchors, std::size_t lane) {
            set_drive(pool.block(block), lane, drive_of(anchors.joint[lane]));
        });
    });
}

template <class Visit>
void JointLanes::for_each_joint(Visit&& visit) const {
    for_pools(*this, [&](const auto& pool) {
        for (const int bucket : pool.buckets()) {
            pool.for_each_lane(pool.blocks(bucket), [&](int, const AnchorBlock& anchors, std::size_t lane) {
                visit(bucket, anchors, lane);
            });
        }
    });
}

template <class Visit>
void JointLanes::for_each_breakable(Visit&& visit) const {
    for_pools(*this, [&](const auto& pool) {
        for (const int block : pool.blocks()) {
            const AnchorBlock& anchors = pool.anchors(block);
            for (unsigned bits = anchors.breakable, lane = 0; bits != 0; bits >>= 1, ++lane) {
                if (bits & 1) visit(anchors.joint[lane]);
            }
        }
    });
}

template <class Visit>
void JointLanes::for_each_block(Visit&& visit) const {
    for_pools(*this, [&](const auto& pool) {
        for (const int bucket : pool.buckets()) {
            visit_asking_ahead(
                pool.blocks(bucket), kBlocksAhead,
                [&](int block) { prefetch(&rows_of(pool.block(block)), sizeof(JointRows)); },
                [&](int block) {
                    visit(pool.anchors(block), rows_of(pool.block(block)), joint_block_kind(bucket));
                });
        }
    });
}

}  // namespace cairn::physics
