// Colouring, packing and the order of the passes.
#include "resolve/contact_blocks.h"

#include <bit>

namespace cairn::physics {
namespace {

constexpr int kScalar = -1;

// rad. The blocks take separations as linear in the angle, which is wrong by half its square times the arm.
constexpr float kMaxTurn_rad = 0.25f;

BlockKind kind_of(int bucket) {
    return bucket % 2 == 0 ? BlockKind::TwoBodies : BlockKind::OneBody;
}

// Lanes that are not used: a gap that never closes, between the world and itself.
void clear_lanes(ContactBlock& block) {
    block = ContactBlock{};
    for (ContactBlockPoint& point : block.points) {
        point.start_separation.fill(1);
        point.separation.fill(1);
    }
}

void write_lane(ContactBlock& block, int lane, const ContactInput& c, const Motions& motions) {
    // The body that cannot move becomes a, and the normal points away from it.
    const bool swap = c.b == kWorldRow;
    const int a = swap ? c.b : c.a;
    const int b = swap ? c.a : c.b;
    const Vec2 normal = swap ? -c.normal : c.normal;
    const float k_a = a == kWorldRow ? 0 : motions.pose[a].k;
    const float k_b = motions.pose[b].k;
    const float inverse_mass = motions.velocity[a].inverse_mass + motions.velocity[b].inverse_mass;
    block.contact[lane] = c.contact;
    block.a[lane] = a;
    block.b[lane] = b;
    block.normal_x[lane] = normal.x;
    block.normal_y[lane] = normal.y;
    Vec2 middle_a{};
    Vec2 middle_b{};
    for (int i = 0; i < c.count; ++i) {
        ContactBlockPoint& to = block.points[i];
        const Vec2 r_a = swap ? c.points[i].r_b : c.points[i].r_a;
        const Vec2 r_b = swap ? c.points[i].r_a : c.points[i].r_b;
        const float arm_a = k_a * cross(r_a, normal);
        const float arm_b = k_b * cross(r_b, normal);
        to.arm_a[lane] = arm_a;
        to.arm_b[lane] = arm_b;
        to.mass[lane] = 1 / (inverse_mass + arm_a * arm_a + arm_b * arm_b);
        to.start_separation[lane] = to.separation[lane] = c.points[i].separation;
        to.impulse[lane] = c.points[i].impulse;
        to.static_impulse[lane] = c.points[i].static_impulse;
        block.total_impulse[i][lane] = 0;
        middle_a += r_a;
        middle_b += r_b;
    }
    if (c.count == 2) {
        middle_a *= 0.5f;
        middle_b *= 0.5f;
    } else {
        ContactBlockPoint& unused = block.points[1];
        unused.arm_a[lane] = unused.arm_b[lane] = unused.mass[lane] = unused.impulse[lane] =
            unused.static_impulse[lane] = 0;
        unused.start_separation[lane] = unused.separation[lane] = 1;
        block.total_impulse[1][lane] = 0;
    }
    const Vec2 tangent = right_perp(normal);
    const float arm_a = k_a * cross(middle_a, tangent);
    const float arm_b = k_b * cross(middle_b, tangent);
    block.tangent_arm_a[lane] = arm_a;
    block.tangent_arm_b[lane] = arm_b;
    block.tangent_mass[lane] = 1 / (inverse_mass + arm_a * arm_a + arm_b * arm_b);
    block.friction[lane] = c.friction;
    block.friction_impulse[lane] = c.friction_impulse;
    block.reports |= c.reports;
}

}  // namespace

void ContactBlocks::start(int rows) {
    colors_of_row_.assign(rows, 0);
    used_ = 0;
    first_.fill(kNoBlock);
    last_.fill(kNoBlock);
}

int ContactBlocks::choose_bucket(const ContactInput& c, const Motions& motions, float dt_s) {
    if (c.rolling_m != 0 || c.surface_speed_m_s != 0) return kScalar;
    std::uint32_t used = 0;
    for (const int row : {c.a, c.b}) {
        if (row == kWorldRow) continue;
        if (motions.velocity[row].inverse_mass == 0 || motions.inverse_inertia[row] == 0) return kScalar;
        if (motions.locked_axes(row) != 0) return kScalar;
        if (std::fabs(motions.spin(row)) * dt_s > kMaxTurn_rad) return kScalar;
        used |= colors_of_row_[row];
    }
    const int color = std::countr_one(used);
    if (color >= kColors) return kScalar;
    for (const int row : {c.a, c.b}) {
        if (row != kWorldRow) colors_of_row_[row] |= 1u << color;
    }
    return 2 * color + (c.a == kWorldRow || c.b == kWorldRow ? 1 : 0);
}

int ContactBlocks::open_block(int bucket) {
    const int last = last_[bucket];
    if (last != kNoBlock && blocks_[last].used < kBlockLanes) return last;
    const int block = used_++;
    if (block == static_cast<int>(blocks_.size())) blocks_.emplace_back();
    clear_lanes(blocks_[block]);
    (last == kNoBlock ? first_[bucket] : blocks_[last].next) = block;
    last_[bucket] = block;
    return block;
}

ContactLane ContactBlocks::add(const ContactInput& contact, const Motions& motions, float dt_s) {
    const int bucket = choose_bucket(contact, motions, dt_s);
    if (bucket == kScalar) return {};
    const int block = open_block(bucket);
    const int lane = blocks_[block].used++;
    write_lane(blocks_[block], lane, contact, motions);
    return {block, lane, bucket};
}

void ContactBlocks::warm_start(Motions& motions) const {
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
        warm_start_blocks(blocks_.data(), first_[bucket], kind_of(bucket), motions.velocity.data());
    }
}

void ContactBlocks::solve(Motions& motions, const ContactRules& rules, float h_s, Pass pass) {
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
        if (first_[bucket] == kNoBlock) continue;
        const BlockKind kind = kind_of(bucket);
        const ContactPassTime time{
            kind == BlockKind::OneBody ? rules.static_softness : rules.dynamic_softness, 1 / h_s,
            rules.max_push_out_speed_m_s};
        if (pass == Pass::Biased) {
            solve_blocks(blocks_.data(), first_[bucket], kind, motions.velocity.data(), time);
        } else {
            relax_blocks(blocks_.data(), first_[bucket], kind, motions.velocity.data(), motions.pose.data(),
                         time);
        }
    }
}

ContactOutcome ContactBlocks::outcome(const ContactLane& at) const {
    const ContactBlock& block = blocks_[at.block];
    ContactOutcome outcome;
    for (int i = 0; i < 2; ++i) {
        outcome.impulse[i] = block.points[i].impulse[at.lane];
        outcome.separation[i] = block.points[i].separation[at.lane];
        outcome.total_impulse[i] = block.reports ? block.total_impulse[i][at.lane] : outcome.impulse[i];
    }
    outcome.friction_impulse = block.friction_impulse[at.lane];
    return outcome;
}

}  // namespace cairn::physics
