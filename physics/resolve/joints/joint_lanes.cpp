// Upkeep of lanes of joints, and the order of the passes.
#include "resolve/joints/joint_lanes.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

#include "base/colored_runs.h"

namespace cairn::physics {
namespace {

// What a thread takes at once: enough to be worth a microsecond.
constexpr int kBlocksPerChunk = 24;

// Blocks are rows of eight numbers of four bytes each, and nothing else.
constexpr std::size_t kRowBytes = sizeof(Lanes<float>);
static_assert(sizeof(PinBlock) % kRowBytes == 0 && sizeof(DriveBlock) % kRowBytes == 0);

template <class Block>
void copy_lane(Block& to, std::size_t to_lane, const Block& from, std::size_t from_lane) {
    auto* target = reinterpret_cast<std::byte*>(&to) + to_lane * sizeof(float);
    const auto* source = reinterpret_cast<const std::byte*>(&from) + from_lane * sizeof(float);
    for (std::size_t row = 0; row < sizeof(Block); row += kRowBytes) {
        std::memcpy(target + row, source + row, sizeof(float));
    }
}

// An unused lane is of the world's row, and all its numbers are 0.
template <class Block>
void clear_lane(Block& block, std::size_t lane) {
    const Block nothing{};
    copy_lane(block, lane, nothing, 0);
}

void write_anchor(AnchorBlock& to, std::size_t lane, const AnchorLane& from) {
    to.joint[lane] = from.joint;
    to.body_a[lane] = from.body_a;
    to.body_b[lane] = from.body_b;
    to.local_ax[lane] = from.local_a.x;
    to.local_ay[lane] = from.local_a.y;
    to.local_bx[lane] = from.local_b.x;
    to.local_by[lane] = from.local_b.y;
    to.cosine[lane] = from.turn.c;
    to.sine[lane] = from.turn.s;
    to.turns[lane] = from.turns;
    to.breakable =
        static_cast<std::uint8_t>((to.breakable & ~(1 << lane)) | (from.breakable ? 1 : 0) << lane);
}

AnchorLane read_anchor(const AnchorBlock& from, std::size_t lane) {
    return {from.joint[lane],
            from.body_a[lane],
            from.body_b[lane],
            {from.local_ax[lane], from.local_ay[lane]},
            {from.local_bx[lane], from.local_by[lane]},
            {from.cosine[lane], from.sine[lane]},
            from.turns[lane],
            (from.breakable >> lane & 1) != 0};
}

std::size_t block_of(int lane) {
    return static_cast<std::size_t>(lane / kLanes);
}
std::size_t place_in(int lane) {
    return static_cast<std::size_t>(lane % kLanes);
}

const PinBlock& pin_of(const DriveBlock& block) {
    return block.pin;
}
const PinBlock& pin_of(const PinBlock& block) {
    return block;
}

}  // namespace

template <class Block>
int JointPool<Block>::add(int bucket, const AnchorLane& lane) {
    if (bucket >= bucket_end())
        chains_.resize(static_cast<std::size_t>((joint_domain(bucket) + 1) * kJointBucketsOfDomain));
    int block = chains_[static_cast<std::size_t>(bucket)].last;
    if (block == kNone || links_[static_cast<std::size_t>(block)].used == kLanes) block = open_block(bucket);
    const auto i = static_cast<std::size_t>(block);
    const int at = links_[i].used++;
    write_anchor(anchors_[i], static_cast<std::size_t>(at), lane);
    return block * kLanes + at;
}

template <class Block>
int JointPool<Block>::remove(int bucket, int lane) {
    Chain& chain = chains_[static_cast<std::size_t>(bucket)];
    const auto last_block = static_cast<std::size_t>(chain.last);
    const int last = --links_[last_block].used;
    const auto last_at = static_cast<std::size_t>(last);
    const AnchorLane moved = read_anchor(anchors_[last_block], last_at);
    copy_lane(blocks_[block_of(lane)], place_in(lane), blocks_[last_block], last_at);
    write_anchor(anchors_[block_of(lane)], place_in(lane), moved);
    clear_lane(blocks_[last_block], last_at);
    write_anchor(anchors_[last_block], last_at, AnchorLane{});
    const bool is_last = chain.last * kLanes + last == lane;
    if (last == 0) {
        free_.push_back(chain.last);
        chain.last = links_[last_block].previous;
        (chain.last == kNone ? chain.first : links_[static_cast<std::size_t>(chain.last)].next) = kNone;
        is_arranged_ = false;
    }
    return is_last ? kNone : moved.joint;
}

template <class Block>
typename JointPool<Block>::Moved JointPool<Block>::move(int bucket, int lane, int to_bucket) {
    const int to = add(to_bucket, read_anchor(anchors_[block_of(lane)], place_in(lane)));
    copy_lane(blocks_[block_of(to)], place_in(to), blocks_[block_of(lane)], place_in(lane));
    return {to, remove(bucket, lane)};
}

template <class Block>
int JointPool<Block>::open_block(int bucket) {
    int block = static_cast<int>(blocks_.size());
    if (free_.empty()) {
        blocks_.emplace_back();
        anchors_.emplace_back();
        links_.emplace_back();
        free_.reserve(blocks_.capacity());
        order_.reserve(blocks_.capacity());
        for (std::size_t lane = 0; lane < kLanes; ++lane) write_anchor(anchors_.back(), lane, AnchorLane{});
    } else {
        block = free_.back();
        free_.pop_back();
    }
    Chain& chain = chains_[static_cast<std::size_t>(bucket)];
    links_[static_cast<std::size_t>(block)] = {0, chain.last, kNone};
    (chain.last == kNone ? chain.first : links_[static_cast<std::size_t>(chain.last)].next) = block;
    chain.last = block;
    is_arranged_ = false;
    return block;
}

// False where they are in order already.
template <class Block>
bool JointPool<Block>::find_order(int bucket, std::span<const Place> places, LaneOrder& order) const {
    const auto row = [&](int body) { return places[static_cast<std::size_t>(body)].row; };
    order.clear();
    for (int block = chains_[static_cast<std::size_t>(bucket)].first; block != kNone;) {
        const auto i = static_cast<std::size_t>(block);
        order.add_block(block);
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(links_[i].used); ++lane) {
            const int row_b = row(anchors_[i].body_b[lane]);
            const bool anchored = joint_block_kind(bucket) == JointBlockKind::Anchored;
            order.add_lane(row_b + (anchored ? row_b : row(anchors_[i].body_a[lane])));
        }
        block = links_[i].next;
    }
    return order.sort();
}

template <class Block>
void JointPool<Block>::take_order(LaneOrder& order) {
    Block kept{};
    AnchorLane kept_anchor;
    const auto copy = [&](LaneAt to, const Block& from, int lane, const AnchorLane& anchor) {
        const auto block = static_cast<std::size_t>(to.block);
        copy_lane(blocks_[block], static_cast<std::size_t>(to.lane), from, static_cast<std::size_t>(lane));
        write_anchor(anchors_[block], static_cast<std::size_t>(to.lane), anchor);
    };
    const auto anchor_at = [&](LaneAt at) {
        return read_anchor(anchors_[static_cast<std::size_t>(at.block)], static_cast<std::size_t>(at.lane));
    };
    order.apply(
        [&](LaneAt from) {
            copy_lane(kept, 0, block(from.block), static_cast<std::size_t>(from.lane));
            kept_anchor = anchor_at(from);
        },
        [&](LaneAt to, LaneAt from) { copy(to, block(from.block), from.lane, anchor_at(from)); },
        [&](LaneAt to) { copy(to, kept, 0, kept_anchor); });
}

template <class Block>
void JointPool<Block>::arrange() {
    if (is_arranged_) return;
    is_arranged_ = true;
    order_.clear();
    used_.clear();
    used_.reserve(chains_.size());
    ranges_.assign(chains_.size(), {});
    const int domains = bucket_end() / kJointBucketsOfDomain;
    for (int domain = 1; domain < domains; ++domain) arrange_domain(domain);
    if (domains > 0) arrange_domain(kInterface);
}

template <class Block>
void JointPool<Block>::arrange_domain(int domain) {
    const int first = joint_bucket(0, JointBlockKind{}, domain);
    for (int bucket = first; bucket < first + kJointBucketsOfDomain; ++bucket) {
        const auto i = static_cast<std::size_t>(bucket);
        if (chains_[i].first == kNone) continue;
        used_.push_back(bucket);
        ranges_[i].first = static_cast<std::uint32_t>(order_.size());
        for (int block = chains_[i].first; block != kNone;
             block = links_[static_cast<std::size_t>(block)].next)
            order_.push_back(block);
        ranges_[i].count = static_cast<std::uint32_t>(order_.size()) - ranges_[i].first;
    }
}

template <class Block>
template <class BlockPass>
void JointPool<Block>::for_each_bucket(TaskPool& tasks, const BlockPass& pass) const {
    if (used_.empty()) return;
    const auto run_at = [&](int i) {
        const int bucket = used_[static_cast<std::size_t>(i)];
        return ColoredRun{joint_color(bucket), static_cast<int>(blocks(bucket).size()), joint_domain(bucket)};
    };
    for_colored_runs<kJointBucketsOfDomain>(
        static_cast<int>(used_.size()), run_at, kBlocksPerChunk, tasks, [&](int i, int first, int count) {
            const int bucket = used_[static_cast<std::size_t>(i)];
            pass(blocks(bucket).subspan(first, count), joint_block_kind(bucket));
        });
}

template class JointPool<PinBlock>;
template class JointPool<DriveBlock>;

JointSeat JointLanes::add_pin(int bucket, const AnchorLane& lane) {
    return {pins_.add(bucket, lane), static_cast<std::int16_t>(bucket), false};
}

JointSeat JointLanes::add_drive(int bucket, const AnchorLane& lane, const DriveLane& drive) {
    const JointSeat seat{drives_.add(bucket, lane), static_cast<std::int16_t>(bucket), true};
    set_drive(seat.lane, drive);
    return seat;
}

void JointLanes::set_drive(int lane, const DriveLane& drive) {
    DriveBlock& block = drives_.block(lane / kLanes);
    const std::size_t at = place_in(lane);
    block.bias_rate[at] = drive.softness.bias_rate;
    block.mass_scale[at] = drive.softness.mass_scale;
    block.impulse_scale[at] = drive.softness.impulse_scale;
    block.own_d1[at] = block.spring_d1[at] = drive.spring.d1;
    block.own_d0[at] = block.spring_d0[at] = drive.spring.d0;
    block.spring_stiffness[at] = drive.spring.stiffness_per_s;
    block.square[at] = drive.square;
    block.damping[at] = drive.damping;
    block.frequency[at] = drive.spring_frequency_rad_s;
    block.own_target[at] = drive.spring_target;
    block.motor_speed[at] = drive.motor_speed;
    block.motor_limit[at] = drive.motor_limit;
    block.own_lower[at] = drive.lower;
    block.own_upper[at] = drive.upper;
    springs_changed_ = true;
}

int JointLanes::remove(const JointSeat& seat) {
    if (!seat.drives) return pins_.remove(seat.bucket, seat.lane);
    springs_changed_ = true;
    return drives_.remove(seat.bucket, seat.lane);
}

int JointLanes::move(JointSeat& seat, int to_bucket) {
    const auto move_in = [&](auto& pool) {
        const auto [lane, filler] = pool.move(seat.bucket, seat.lane, to_bucket);
        seat.lane = lane;
        return filler;
    };
    const int filler = seat.drives ? move_in(drives_) : move_in(pins_);
    seat.bucket = static_cast<std::int16_t>(to_bucket);
    return filler;
}

JointMemory JointLanes::memory(const JointSeat& seat) const {
    JointMemory memory;
    const int block = seat.lane / kLanes;
    const std::size_t at = place_in(seat.lane);
    const PinBlock& pin = seat.drives ? pin_of(drives_.block(block)) : pin_of(pins_.block(block));
    const AnchorBlock& anchors = seat.drives ? drives_.anchors(block) : pins_.anchors(block);
    const auto impulse = [&](int direction, Role role) -> float& {
        return memory.impulse[static_cast<std::size_t>(impulse_index(direction, role))];
    };
    impulse(0, Role::HoldOrSpring) = pin.impulse_x[at];
    impulse(1, Role::HoldOrSpring) = pin.impulse_y[at];
    if (dt_s_ > 0) memory.reaction_force = (1 / dt_s_) * Vec2{pin.total_x[at], pin.total_y[at]};
    memory.angle_rad =
        deterministic::atan2(static_cast<double>(anchors.sine[at]), static_cast<double>(anchors.cosine[at])) +
        2 * static_cast<double>(kPi) * static_cast<double>(anchors.turns[at]);
    if (!seat.drives) return memory;
    const DriveBlock& drive = drives_.block(block);
    impulse(2, Role::HoldOrSpring) = drive.spring_impulse[at];
    impulse(2, Role::Motor) = drive.motor_impulse[at];
    impulse(2, Role::Lower) = drive.lower_impulse[at];
    impulse(2, Role::Upper) = drive.upper_impulse[at];
    if (dt_s_ > 0) memory.reaction_torque = drive.total_angular[at] / dt_s_;
    return memory;
}

void JointLanes::set_impulses(const JointSeat& seat, const JointImpulses& impulses) {
    const int block = seat.lane / kLanes;
    const std::size_t at = place_in(seat.lane);
    PinBlock& pin = seat.drives ? drives_.block(block).pin : pins_.block(block);
    const auto impulse = [&](int direction, Role role) {
        return impulses[static_cast<std::size_t>(impulse_index(direction, role))];
    };
    pin.impulse_x[at] = impulse(0, Role::HoldOrSpring);
    pin.impulse_y[at] = impulse(1, Role::HoldOrSpring);
    if (!seat.drives) return;
    // What is switched off starts from nothing when it is switched on again.
    DriveBlock& drive = drives_.block(block);
    if (drive.frequency[at] > 0) drive.spring_impulse[at] = impulse(2, Role::HoldOrSpring);
    if (drive.motor_limit[at] > 0) drive.motor_impulse[at] = impulse(2, Role::Motor);
    if (drive.own_lower[at] > -kNoLimit_rad) drive.lower_impulse[at] = impulse(2, Role::Lower);
    if (drive.own_upper[at] < kNoLimit_rad) drive.upper_impulse[at] = impulse(2, Role::Upper);
}

Vec2 JointLanes::load(const JointSeat& seat) const {
    if (seat.drives) return {};
    const PinBlock& block = pins_.block(seat.lane / kLanes);
    return {block.load_x[place_in(seat.lane)], block.load_y[place_in(seat.lane)]};
}

void JointLanes::set_load(const JointSeat& seat, Vec2 force_n) {
    if (seat.drives) return;
    PinBlock& block = pins_.block(seat.lane / kLanes);
    block.load_x[place_in(seat.lane)] = force_n.x;
    block.load_y[place_in(seat.lane)] = force_n.y;
    has_loads_ = has_loads_ || force_n != Vec2{};
}

void JointLanes::arrange() {
    pins_.arrange();
    drives_.arrange();
}

bool JointLanes::place(const std::vector<Place>& places, Motions& motions, float impulse_ratio, float dt_s,
                       TaskPool& tasks) {
    dt_s_ = dt_s;
    std::atomic<bool> torn = false;
    const auto place_all = [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
            if (place_joints(pool.anchor_data(), pool.data(), blocks, kind, places.data(), motions,
                             impulse_ratio)) {
                torn.store(true, std::memory_order_relaxed);
            }
        });
        for (const int bucket : pool.buckets()) {
            if (joint_block_kind(bucket) != JointBlockKind::Anchored) continue;
            for (const int block : pool.blocks(bucket)) {
                for (const int row : pin_of(pool.block(block)).a) {
                    MovedBy& mover = motions.mover[static_cast<std::size_t>(row)];
                    mover = std::max(mover, MovedBy::Jointed);
                }
            }
        }
    };
    place_all(pins_);
    place_all(drives_);
    return torn.load(std::memory_order_relaxed);
}

void JointLanes::take_off_loads(const Motions& motions, const PinLoads& loads, TaskPool& tasks) {
    if (!has_loads_) return;
    pins_.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
        physics::take_off_loads(pins_.data(), blocks, kind, motions.velocity.data(), loads);
    });
}

void JointLanes::hide_tears(float rigid_rate, std::vector<TornJoint>& torn) {
    const auto hide = [&](PinBlock& block, std::size_t lane) {
        const Vec2 error{block.error_x[lane], block.error_y[lane]};
        if (!(length_squared(error) > kTorn_m * kTorn_m)) return;
        torn.push_back({block.a[lane],
                        block.b[lane],
                        {block.arm_ax[lane], block.arm_ay[lane]},
                        {block.arm_bx[lane], block.arm_by[lane]},
                        error,
                        {}});
        block.offset_x[lane] -= error.x;
        block.offset_y[lane] -= error.y;
        block.error_x[lane] = block.error_y[lane] = 0;
    };
    const auto for_each = [&](auto& pool, const auto& visit) {
        for (const int i : pool.blocks()) {
            const AnchorBlock& anchors = pool.anchors(i);
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                if (anchors.joint[lane] != kNone) visit(pool.block(i), lane);
            }
        }
    };
    for_each(pins_, hide);
    for_each(drives_, [&](DriveBlock& block, std::size_t lane) {
        if (block.bias_rate[lane] >= rigid_rate) hide(block.pin, lane);
    });
}

void JointLanes::add_spring_loads(const Motions& motions, std::vector<SpringLoad>& loads,
                                  TaskPool& tasks) const {
    const auto response = [&](std::size_t row) {
        const auto k = static_cast<double>(motions.pose[row].k);
        return motions.velocity[row].inverse_mass > 0 ? k * k : 0.0;
    };
    const auto add = [&](const DriveBlock& block, std::size_t lane) {
        const auto w = static_cast<double>(block.frequency[lane]);
        if (w == 0) return;
        const auto a = static_cast<std::size_t>(block.pin.a[lane]);
        const auto b = static_cast<std::size_t>(block.pin.b[lane]);
        const double of_a = response(a);
        const double of_b = response(b);
        const double sum = of_a + of_b;
        // What cannot be moved may stand in several lanes of a colour.
        for (const auto& [row, of_body] : {std::pair{a, of_a}, std::pair{b, of_b}}) {
            if (!(of_body > 0)) continue;
            loads[row].together_1_s2 += w * w * of_body / sum;
            ++loads[row].springs;
        }
    };
    drives_.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind) {
        for (const int block : blocks) {
            const AnchorBlock& anchors = drives_.anchors(block);
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                if (anchors.joint[lane] != kNone) add(drives_.block(block), lane);
            }
        }
    });
}

void JointLanes::settle_springs(const std::vector<SpringLoad>& loads, bool others, TaskPool& tasks) {
    springs_changed_ = others;  // theirs may be gone in the next step
    const std::span<const int> blocks = drives_.blocks();
    std::atomic<bool> some_crowded = false;
    const auto settle = [&](DriveBlock& block, std::size_t lane) {
        block.crowded[lane] = 0;
        const auto w = static_cast<double>(block.frequency[lane]);
        if (w == 0) return;
        const SpringLoad& of_a = loads[static_cast<std::size_t>(block.pin.a[lane])];
        const SpringLoad& of_b = loads[static_cast<std::size_t>(block.pin.b[lane])];
        const double sum = of_a.together_1_s2 + of_b.together_1_s2;
        const auto square = static_cast<double>(block.square[lane]);
        ExactSpring spring{block.own_d1[lane], block.own_d0[lane], 0, true};
        spring = calmed(spring, square, std::max(sum / (w * w), 1.0));
        if (is_crowd(of_a, static_cast<double>(h_s)) || is_crowd(of_b, static_cast<double>(h_s))) {
            spring = crowded(spring, square, static_cast<double>(block.damping[lane]));
            block.crowded[lane] = 1;
            some_crowded.store(true, std::memory_order_relaxed);
        }
        block.spring_d1[lane] = spring.d1;
        block.spring_d0[lane] = spring.d0;
    };
    tasks.parallel_for(static_cast<int>(blocks.size()), kBlocksPerChunk, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) {
            const int block = blocks[static_cast<std::size_t>(i)];
            const AnchorBlock& anchors = drives_.anchors(block);
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                if (anchors.joint[lane] != kNone) settle(drives_.block(block), lane);
            }
        }
    });
    has_crowded_springs_ = some_crowded.load(std::memory_order_relaxed);
}

void JointLanes::note_spring_speeds(const Motions& motions, TaskPool& tasks) {
    drives_.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind) {
        note_joint_speeds(drives_.data(), blocks, motions.velocity.data());
    });
}

void JointLanes::warm_start(Motions& motions, TaskPool& tasks) {
    const auto warm_start_all = [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
            warm_start_joints(pool.data(), blocks, kind, motions.velocity.data());
        });
    };
    warm_start_all(pins_);
    warm_start_all(drives_);
}

// On one thread: crowds are few.
void JointLanes::sweep_crowded_springs(Motions& motions, bool back) {
    const auto sweep = [&](int bucket) {
        physics::sweep_crowded_springs(drives_.data(), drives_.blocks(bucket), joint_block_kind(bucket),
                                       motions.velocity.data());
    };
    const std::span<const int> buckets = drives_.buckets();
    if (back) {
        std::for_each(buckets.rbegin(), buckets.rend(), sweep);
    } else {
        std::for_each(buckets.begin(), buckets.end(), sweep);
    }
}

void JointLanes::solve(Motions& motions, const JointPassTime& time, TaskPool& tasks) {
    const auto solve_all = [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
            solve_joints(pool.data(), blocks, kind, motions.velocity.data(), time);
        });
    };
    solve_all(pins_);
    solve_all(drives_);
}

void JointLanes::relax(Motions& motions, const JointPassTime& time, TaskPool& tasks) {
    const auto relax_all = [&](auto& pool) {
        pool.for_each_bucket(tasks, [&](std::span<const int> blocks, JointBlockKind kind) {
            relax_joints(pool.data(), blocks, kind, motions.velocity.data(), motions.pose.data(), time);
        });
    };
    relax_all(pins_);
    relax_all(drives_);
}

}  // namespace cairn::physics
