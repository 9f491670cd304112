// What becomes of joints in lanes when they come and go, and the order of the passes.
#include "resolve/joints/joint_lanes.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace cairn::physics {
namespace {

std::size_t place_in(int lane) {
    return static_cast<std::size_t>(lane % kLanes);
}

float& at(JointImpulses& impulses, int direction, Role role) {
    return impulses[static_cast<std::size_t>(impulse_index(direction, role))];
}
float at(const JointImpulses& impulses, int direction, Role role) {
    return impulses[static_cast<std::size_t>(impulse_index(direction, role))];
}

// What a lane has of impulses, and, once there was a step, of reactions.
void recall(const PinBlock& pin, std::size_t lane, float dt_s, JointMemory& memory) {
    at(memory.impulse, 0, Role::HoldOrSpring) = pin.impulse_x[lane];
    at(memory.impulse, 1, Role::HoldOrSpring) = pin.impulse_y[lane];
    if (dt_s > 0) memory.reaction_force = (1 / dt_s) * Vec2{pin.total_x[lane], pin.total_y[lane]};
}
void recall(const DriveBlock& drive, std::size_t lane, float dt_s, JointMemory& memory) {
    recall(drive.pin, lane, dt_s, memory);
    at(memory.impulse, 2, Role::HoldOrSpring) = drive.spring_impulse[lane];
    at(memory.impulse, 2, Role::Motor) = drive.motor_impulse[lane];
    at(memory.impulse, 2, Role::Lower) = drive.lower_impulse[lane];
    at(memory.impulse, 2, Role::Upper) = drive.upper_impulse[lane];
    if (dt_s > 0) memory.reaction_torque = drive.total_angular[lane] / dt_s;
}
void recall(const WheelBlock& wheel, std::size_t lane, float dt_s, JointMemory& memory) {
    at(memory.impulse, 0, Role::HoldOrSpring) = wheel.impulse[lane];
    at(memory.impulse, 1, Role::HoldOrSpring) = wheel.spring_impulse[lane];
    at(memory.impulse, 1, Role::Lower) = wheel.lower_impulse[lane];
    at(memory.impulse, 1, Role::Upper) = wheel.upper_impulse[lane];
    at(memory.impulse, 2, Role::Motor) = wheel.motor_impulse[lane];
    memory.angle_rad += static_cast<double>(wheel.turned[lane]);
    if (!(dt_s > 0)) return;
    memory.reaction_force = (1 / dt_s) * Vec2{wheel.total_x[lane], wheel.total_y[lane]};
    memory.reaction_torque = wheel.total_angular[lane] / dt_s;
}

// What is switched off starts from nothing when it is switched on again.
void set(PinBlock& pin, std::size_t lane, const JointImpulses& impulses) {
    pin.impulse_x[lane] = at(impulses, 0, Role::HoldOrSpring);
    pin.impulse_y[lane] = at(impulses, 1, Role::HoldOrSpring);
}
void set(DriveBlock& drive, std::size_t lane, const JointImpulses& impulses) {
    set(drive.pin, lane, impulses);
    if (drive.frequency[lane] > 0) drive.spring_impulse[lane] = at(impulses, 2, Role::HoldOrSpring);
    if (drive.motor_limit[lane] > 0) drive.motor_impulse[lane] = at(impulses, 2, Role::Motor);
    if (drive.own_lower[lane] > -kNoLimit) drive.lower_impulse[lane] = at(impulses, 2, Role::Lower);
    if (drive.own_upper[lane] < kNoLimit) drive.upper_impulse[lane] = at(impulses, 2, Role::Upper);
}
void set(WheelBlock& wheel, std::size_t lane, const JointImpulses& impulses) {
    wheel.impulse[lane] = at(impulses, 0, Role::HoldOrSpring);
    if (wheel.frequency[lane] > 0) wheel.spring_impulse[lane] = at(impulses, 1, Role::HoldOrSpring);
    if (wheel.motor_limit[lane] > 0) wheel.motor_impulse[lane] = at(impulses, 2, Role::Motor);
    if (wheel.lower[lane] > -kNoLimit) wheel.lower_impulse[lane] = at(impulses, 1, Role::Lower);
    if (wheel.upper[lane] < kNoLimit) wheel.upper_impulse[lane] = at(impulses, 1, Role::Upper);
}

// What springs, motor and limits are, but where they draw to and end.
template <class Block>
void set_laws(Block& block, std::size_t lane, const DriveLane& drive) {
    block.bias_rate[lane] = drive.softness.bias_rate;
    block.mass_scale[lane] = drive.softness.mass_scale;
    block.impulse_scale[lane] = drive.softness.impulse_scale;
    block.own_d1[lane] = block.spring_d1[lane] = drive.spring.d1;
    block.own_d0[lane] = block.spring_d0[lane] = drive.spring.d0;
    block.spring_stiffness[lane] = drive.spring.stiffness_per_s;
    block.square[lane] = drive.square;
    block.damping[lane] = drive.damping;
    block.frequency[lane] = drive.spring_frequency_rad_s;
    block.motor_speed[lane] = drive.motor_speed;
    block.motor_limit[lane] = drive.motor_limit;
}

// What the spring of a lane feels of bodies a and b: their parts of J 1/M J^T.
std::array<double, 2> responses(const DriveBlock& block, std::size_t lane, const Motions& motions) {
    const auto of = [&](std::int32_t body) {
        const auto row = static_cast<std::size_t>(body);
        const auto k = static_cast<double>(motions.pose[row].k);
        return motions.velocity[row].inverse_mass > 0 ? k * k : 0.0;
    };
    return {of(block.pin.a[lane]), of(block.pin.b[lane])};
}
std::array<double, 2> responses(const WheelBlock& block, std::size_t lane, const Motions& motions) {
    const auto of = [&](std::int32_t body, float lever) {
        const auto mass = static_cast<double>(motions.velocity[static_cast<std::size_t>(body)].inverse_mass);
        const auto arm = static_cast<double>(lever);
        return mass > 0 ? mass + arm * arm : 0.0;
    };
    return {of(block.a[lane], block.lever_au[lane]), of(block.b[lane], block.lever_bu[lane])};
}

template <class Block>
void add_spring_load(const Block& block, std::size_t lane, const Motions& motions,
                     std::vector<SpringLoad>& loads) {
    const auto w = static_cast<double>(block.frequency[lane]);
    if (w == 0) return;
    const JointRows& rows = rows_of(block);
    const std::array<double, 2> of_bodies = responses(block, lane, motions);
    const double sum = of_bodies[0] + of_bodies[1];
    // What cannot be moved may stand in several lanes of a colour.
    for (const auto& [row, of_body] :
         {std::pair{rows.a[lane], of_bodies[0]}, std::pair{rows.b[lane], of_bodies[1]}}) {
        if (!(of_body > 0)) continue;
        SpringLoad& load = loads[static_cast<std::size_t>(row)];
        load.together_1_s2 += w * w * of_body / sum;
        ++load.springs;
    }
}

// The result is whether the spring is crowded.
template <class Block>
bool settle_spring(Block& block, std::size_t lane, const std::vector<SpringLoad>& loads, double h_s) {
    block.crowded[lane] = 0;
    const auto w = static_cast<double>(block.frequency[lane]);
    if (w == 0) return false;
    const JointRows& rows = rows_of(block);
    const SpringLoad& of_a = loads[static_cast<std::size_t>(rows.a[lane])];
    const SpringLoad& of_b = loads[static_cast<std::size_t>(rows.b[lane])];
    const double sum = of_a.together_1_s2 + of_b.together_1_s2;
    const auto square = static_cast<double>(block.square[lane]);
    ExactSpring spring{block.own_d1[lane], block.own_d0[lane], 0, true};
    spring = calmed(spring, square, std::max(sum / (w * w), 1.0));
    const bool is_crowded = is_crowd(of_a, h_s) || is_crowd(of_b, h_s);
    if (is_crowded) {
        spring = crowded(spring, square, static_cast<double>(block.damping[lane]));
        block.crowded[lane] = 1;
    }
    block.spring_d1[lane] = spring.d1;
    block.spring_d0[lane] = spring.d0;
    return is_crowded;
}

// Whether what springs do together is another in the next step, though none changes: the levers of a wheel's
// axis turn with its bodies.
bool varies(const DriveBlock&, std::size_t, const std::vector<SpringLoad>&) {
    return false;
}
bool varies(const WheelBlock& block, std::size_t lane, const std::vector<SpringLoad>& loads) {
    const auto springs_at = [&](std::int32_t row) { return loads[static_cast<std::size_t>(row)].springs; };
    return block.frequency[lane] > 0 && (springs_at(block.a[lane]) > 1 || springs_at(block.b[lane]) > 1);
}

// Hides a torn joint from the passes; the result is whether it is one.
bool hide_tear(PinBlock& block, std::size_t lane, TornJoint& torn) {
    const Vec2 error{block.error_x[lane], block.error_y[lane]};
    if (!(length_squared(error) > kTorn_m * kTorn_m)) return false;
    torn.apart = error;
    block.error_x[lane] = block.error_y[lane] = 0;
    return true;
}
// What a reaches to comes nearer by as much.
bool hide_tear(WheelBlock& block, std::size_t lane, TornJoint& torn) {
    const float error = block.error[lane];
    if (!(std::fabs(error) > kTorn_m)) return false;
    torn.axis = {-block.axis_y[lane], block.axis_x[lane]};
    torn.apart = error * torn.axis;
    block.error[lane] = 0;
    block.lever_au[lane] += block.k_a[lane] * error;
    return true;
}

}  // namespace

JointSeat JointLanes::add_pin(int bucket, const AnchorLane& lane) {
    return {pins_.add(bucket, lane), static_cast<std::int16_t>(bucket), JointLaneKind::Pin};
}

JointSeat JointLanes::add_drive(int bucket, const AnchorLane& lane, const DriveLane& drive) {
    const int seat = drives_.add(bucket, lane);
    set_drive(drives_.block(seat / kLanes), place_in(seat), drive);
    return {seat, static_cast<std::int16_t>(bucket), JointLaneKind::Drive};
}

JointSeat JointLanes::add_wheel(int bucket, const AnchorLane& lane, Vec2 local_axis, const DriveLane& drive) {
    const int seat = wheels_.add(bucket, lane);
    WheelBlock& block = wheels_.block(seat / kLanes);
    block.local_axis_x[place_in(seat)] = local_axis.x;
    block.local_axis_y[place_in(seat)] = local_axis.y;
    set_drive(block, place_in(seat), drive);
    return {seat, static_cast<std::int16_t>(bucket), JointLaneKind::Wheel};
}

void JointLanes::set_drive(DriveBlock& block, std::size_t lane, const DriveLane& drive) {
    set_laws(block, lane, drive);
    block.own_target[lane] = drive.spring_target;
    block.own_lower[lane] = drive.lower;
    block.own_upper[lane] = drive.upper;
    springs_changed_ = true;
}

void JointLanes::set_drive(WheelBlock& block, std::size_t lane, const DriveLane& drive) {
    set_laws(block, lane, drive);
    block.spring_target[lane] = drive.spring_target;
    block.lower[lane] = drive.lower;
    block.upper[lane] = drive.upper;
    springs_changed_ = true;
}

int JointLanes::remove(const JointSeat& seat) {
    if (seat.kind != JointLaneKind::Pin) springs_changed_ = true;
    return with_pool(*this, seat.kind, [&](auto& pool) { return pool.remove(seat.bucket, seat.lane); });
}

int JointLanes::move(JointSeat& seat, int to_bucket) {
    return with_pool(*this, seat.kind, [&](auto& pool) {
        const auto [lane, filler] = pool.move(seat.bucket, seat.lane, to_bucket);
        seat.lane = lane;
        seat.bucket = static_cast<std::int16_t>(to_bucket);
        return filler;
    });
}

JointMemory JointLanes::memory(const JointSeat& seat) const {
    return with_pool(*this, seat.kind, [&](const auto& pool) {
        const int block = seat.lane / kLanes;
        const std::size_t lane = place_in(seat.lane);
        const AnchorBlock& anchors = pool.anchors(block);
        JointMemory memory;
        memory.angle_rad = deterministic::atan2(static_cast<double>(anchors.sine[lane]),
                                                static_cast<double>(anchors.cosine[lane])) +
                           2 * static_cast<double>(kPi) * static_cast<double>(anchors.turns[lane]);
        recall(pool.block(block), lane, dt_s_, memory);
        return memory;
    });
}

void JointLanes::set_impulses(const JointSeat& seat, const JointImpulses& impulses) {
    with_pool(*this, seat.kind,
              [&](auto& pool) { set(pool.block(seat.lane / kLanes), place_in(seat.lane), impulses); });
}

Vec2 JointLanes::load(const JointSeat& seat) const {
    if (seat.kind != JointLaneKind::Pin) return {};
    const PinBlock& block = pins_.block(seat.lane / kLanes);
    return {block.load_x[place_in(seat.lane)], block.load_y[place_in(seat.lane)]};
}

void JointLanes::set_load(const JointSeat& seat, Vec2 force_n) {
    if (seat.kind != JointLaneKind::Pin) return;
    PinBlock& block = pins_.block(seat.lane / kLanes);
    block.load_x[place_in(seat.lane)] = force_n.x;
    block.load_y[place_in(seat.lane)] = force_n.y;
    has_loads_ = has_loads_ || force_n != Vec2{};
}

void JointLanes::arrange() {
    for_pools(*this, [](auto& pool) { pool.arrange(); });
}

bool JointLanes::place(const std::vector<Place>& places, Motions& motions, float impulse_ratio, float dt_s,
                       TaskPool& tasks) {
    dt_s_ = dt_s;
    std::atomic<bool> torn = false;
    for_pools(*this, [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
            if (place_joints(pool.anchor_data(), pool.data(), blocks, kind, places.data(), motions,
                             impulse_ratio)) {
                torn.store(true, std::memory_order_relaxed);
            }
        });
        for (const int bucket : pool.buckets()) {
            if (joint_block_kind(bucket) != JointBlockKind::Anchored) continue;
            for (const int block : pool.blocks(bucket)) {
                for (const int row : rows_of(pool.block(block)).a) {
                    MovedBy& mover = motions.mover[static_cast<std::size_t>(row)];
                    mover = std::max(mover, MovedBy::Jointed);
                }
            }
        }
    });
    return torn.load(std::memory_order_relaxed);
}

void JointLanes::take_off_loads(const Motions& motions, const PinLoads& loads, TaskPool& tasks) {
    if (!has_loads_) return;
    pins_.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
        physics::take_off_loads(pins_.data(), blocks, kind, motions.velocity.data(), loads);
    });
}

void JointLanes::hide_tears(const std::function<bool(int)>& is_rigid, std::vector<TornJoint>& torn) {
    const auto hide = [&](auto& block, std::size_t lane) {
        TornJoint tear{block.a[lane],
                       block.b[lane],
                       {block.arm_ax[lane], block.arm_ay[lane]},
                       {block.arm_bx[lane], block.arm_by[lane]},
                       {},
                       {}};
        if (!hide_tear(block, lane, tear)) return;
        block.offset_x[lane] -= tear.apart.x;
        block.offset_y[lane] -= tear.apart.y;
        torn.push_back(tear);
    };
    const auto for_each = [](auto& pool, const auto& visit) {
        pool.for_each_lane(pool.blocks(), [&](int block, const AnchorBlock& anchors, std::size_t lane) {
            visit(pool.block(block), lane, anchors.joint[lane]);
        });
    };
    for_each(wheels_, [&](WheelBlock& block, std::size_t lane, int joint) {
        if (is_rigid(joint)) hide(block, lane);
    });
    for_each(pins_, [&](PinBlock& block, std::size_t lane, int) { hide(block, lane); });
    for_each(drives_, [&](DriveBlock& block, std::size_t lane, int joint) {
        if (is_rigid(joint)) hide(block.pin, lane);
    });
}

void JointLanes::add_spring_loads(const Motions& motions, std::vector<SpringLoad>& loads,
                                  TaskPool& tasks) const {
    for_spring_pools(*this, [&](const auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind) {
            pool.for_each_lane(blocks, [&](int block, const AnchorBlock&, std::size_t lane) {
                add_spring_load(pool.block(block), lane, motions, loads);
            });
        });
    });
}

void JointLanes::settle_springs(const std::vector<SpringLoad>& loads, bool others, TaskPool& tasks) {
    std::atomic<bool> some_crowded = false;
    std::atomic<bool> some_vary = false;
    for_spring_pools(*this, [&](auto& pool) {
        const std::span<const int> blocks = pool.blocks();
        const auto settle = [&](int block, const AnchorBlock&, std::size_t lane) {
            if (settle_spring(pool.block(block), lane, loads, static_cast<double>(h_s)))
                some_crowded.store(true, std::memory_order_relaxed);
            if (varies(pool.block(block), lane, loads)) some_vary.store(true, std::memory_order_relaxed);
        };
        tasks.parallel_for(static_cast<int>(blocks.size()), kJointBlocksPerChunk, [&](const Chunk& chunk) {
            const auto first = static_cast<std::size_t>(chunk.begin);
            const auto count = static_cast<std::size_t>(chunk.end - chunk.begin);
            pool.for_each_lane(blocks.subspan(first, count), settle);
        });
    });
    has_crowded_springs_ = some_crowded.load(std::memory_order_relaxed);
    // Those of others may be gone in the next step.
    springs_changed_ = others || some_vary.load(std::memory_order_relaxed);
}

void JointLanes::note_spring_speeds(const Motions& motions, TaskPool& tasks) {
    for_spring_pools(*this, [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind) {
            note_joint_speeds(pool.data(), blocks, motions.velocity.data());
        });
    });
}

void JointLanes::warm_start(Motions& motions, TaskPool& tasks) {
    for_pools(*this, [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
            warm_start_joints(pool.data(), blocks, kind, motions.velocity.data());
        });
    });
}

// On one thread: crowds are few.
void JointLanes::sweep_crowded_springs(Motions& motions, bool back) {
    const auto sweep = [&](auto& pool) {
        const auto sweep_bucket = [&](int bucket) {
            physics::sweep_crowded_springs(pool.data(), pool.blocks(bucket), joint_block_kind(bucket),
                                           motions.velocity.data());
        };
        const std::span<const int> buckets = pool.buckets();
        if (back) {
            std::for_each(buckets.rbegin(), buckets.rend(), sweep_bucket);
        } else {
            std::for_each(buckets.begin(), buckets.end(), sweep_bucket);
        }
    };
    if (back) {
        sweep(drives_);
        sweep(wheels_);
    } else {
        sweep(wheels_);
        sweep(drives_);
    }
}

void JointLanes::solve(Motions& motions, const JointPassTime& time, TaskPool& tasks) {
    for_pools(*this, [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
            solve_joints(pool.data(), blocks, kind, motions.velocity.data(), time);
        });
    });
}

void JointLanes::relax(Motions& motions, const JointPassTime& time, TaskPool& tasks) {
    for_pools(*this, [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
            relax_joints(pool.data(), blocks, kind, motions.velocity.data(), motions.pose.data(), time);
        });
    });
}

}  // namespace cairn::physics
