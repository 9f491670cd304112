// Loads handed down from body to body. Glossary, along and across gravity, relative to a body's centre of
// mass: F load (own weight and what stands on it), M its moment sum(x F), x_j places of the n supporting
// points, x_m their mean. Places are arms as the solver has them, scaled by k = sqrt(1/I) of their body.
//     lambda_j = F/n + (x_j - x_m)(M/F - x_m) F / sum (x - x_m)^2
// is the distribution of least squares that carries F and M; where a share would pull, the two outermost
// points take all. Bodies are visited when all that stands on them has been (Kahn 1962): no sorting, and what
// leans in a ring stays at 0. What a block of contacts says of supports is found on all threads; the visits
// follow one another.
#include "world/statics.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "base/prefetch.h"

namespace cairn::physics {
namespace {

// Supports this near each other, squared and scaled as arms are, act as one.
constexpr float kNarrow = 1e-8f;

// m/s, at which one point comes down or lifts off faster than the other. Up to this what stands on both
// counts as standing, and from twice as much as rocking.
constexpr float kRockingSpeed_m_s = 0.02f;

// What a thread takes at once.
constexpr int kBlocksPerChunk = 32;

template <std::size_t kPoints>
void share_by_lever(std::span<const float, kPoints> x, float load, float center,
                    std::span<float, kPoints> shares) {
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    std::fill(shares.begin(), shares.end(), 0.0f);
    const float width = *high - *low;
    const float t = width > 0 ? std::clamp((center - *low) / width, 0.0f, 1.0f) : 0.0f;
    shares[low - x.begin()] += (1 - t) * load;
    shares[high - x.begin()] += t * load;
}

template <std::size_t kPoints>
void share(std::span<const float, kPoints> x, float load, float moment, std::span<float, kPoints> shares) {
    const float part = 1 / static_cast<float>(x.size());
    float mean = 0;
    for (const float at : x) mean += at;
    mean *= part;
    float spread = 0;
    for (const float at : x) spread += (at - mean) * (at - mean);
    const float slope = spread > kNarrow ? (moment - mean * load) / spread : 0;
    bool pulls = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
        shares[i] = load * part + (x[i] - mean) * slope;
        pulls |= shares[i] < 0;
    }
    if (pulls) share_by_lever(x, load, moment / load, shares);
}

// Nearly all bodies stand on one or two contacts, for which loops that know their length take half the time.
void share_among(const float* x, float load, float moment, float* shares, std::size_t points) {
    const auto among = [&]<std::size_t kPoints>() {
        share(std::span<const float, kPoints>(x, points), load, moment,
              std::span<float, kPoints>(shares, points));
    };
    switch (points) {
        case 1:
            return among.template operator()<1>();
        case 2:
            return among.template operator()<2>();
        case 3:
            return among.template operator()<3>();
        case 4:
            return among.template operator()<4>();
        default:
            return among.template operator()<std::dynamic_extent>();
    }
}

// The estimate of one step, from contacts in lanes and in plain form alike. Supports are numbered as the
// lanes of the pool of blocks, of which those without contacts are left out, then those of contacts in plain
// form. A body has them in the order of the blocks' colours, which snapshots keep.
class Estimate {
  public:
    Estimate(Stores& stores, StepScratch& scratch, Vec2 up)
        : lanes_(stores.contacts.lanes),
          stores_(stores),
          step_(scratch),
          motions_(scratch.motions),
          scratch_(*scratch.statics),
          up_(up),
          first_plain_(static_cast<std::size_t>(lanes_.pool_size())) {}

    void find_supports(TaskPool& tasks) {
        const std::span<const int> blocks = lanes_.blocks_in_memory();
        const std::size_t plain_blocks = (step_.scalar_contacts.size() + kLanes - 1) / kLanes;
        const std::size_t room = lanes_.pool_room() + plain_blocks;
        reserve_amply(scratch_.supports, room);
        reserve_amply(scratch_.next, kLanes * room);
        scratch_.supports.resize(first_plain_ + plain_blocks);
        scratch_.next.resize(kLanes * scratch_.supports.size());
        tasks.parallel_for(static_cast<int>(blocks.size()), kBlocksPerChunk, [&](const Chunk& chunk) {
            for (int i = chunk.begin; i < chunk.end; ++i) {
                const std::size_t ahead = static_cast<std::size_t>(i) + kBlocksAhead;
                if (ahead < blocks.size()) prefetch(&lanes_.block(blocks[ahead]), sizeof(ContactBlock));
                const BlockKind kind = kind_of(lanes_.link(blocks[i]).bucket);
                physics::find_supports(lanes_.block(blocks[i]), kind, up_, scratch_.supports[blocks[i]]);
            }
        });
        for (std::size_t i = 0; i < kLanes * plain_blocks; ++i) {
            SupportLanes& to = scratch_.supports[first_plain_ + i / kLanes];
            to.upper[i % kLanes] = kWorldRow;
            for (Lanes<float>& impulse : to.impulse) impulse[i % kLanes] = 0;
            if (i < step_.scalar_contacts.size())
                find_support(step_.contacts[step_.scalar_contacts[i]], to, static_cast<int>(i % kLanes));
        }
    }

    /// `weight` is that of a unit of mass over a substep, N s/kg.
    void share_loads(float weight) {
        assign_amply(scratch_.stands, static_cast<std::size_t>(motions_.size()), {});
        scratch_.ready.clear();
        scratch_.slopes.clear();
        link();
        for (int row = 1; row < motions_.size(); ++row) {
            const StaticsScratch::Stand& stand = scratch_.stands[row];
            if (stand.above == 0 && stand.first != kNone) push_amply(scratch_.ready, row);
        }
        // The last one first: what stands together is visited together.
        while (!scratch_.ready.empty()) {
            const int row = scratch_.ready.back();
            scratch_.ready.pop_back();
            if (scratch_.stands[row].first == kNone) continue;
            bear(row, step_.drives[row].gravity_scale * weight / motions_.velocity[row].inverse_mass);
        }
    }

    /// Gives the contacts what was found.
    void tell(TaskPool& tasks) {
        const std::span<const int> blocks = lanes_.blocks_in_memory();
        tasks.parallel_for(static_cast<int>(blocks.size()), kBlocksPerChunk, [&](const Chunk& chunk) {
            for (int i = chunk.begin; i < chunk.end; ++i) {
                SupportLanes& from = scratch_.supports[blocks[i]];
                ContactBlock& to = lanes_.block(blocks[i]);
                for (int lane = 0; lane < kLanes; ++lane) {
                    if (from.upper[lane] == kWorldRow || from.points[lane] < 2) continue;
                    const float trust = trust_in(to, lane);
                    for (Lanes<float>& impulse : from.impulse) impulse[lane] *= trust;
                }
                for (std::size_t k = 0; k < 2; ++k) to.points[k].static_impulse = from.impulse[k];
            }
        });
        for (std::size_t i = 0; i < step_.scalar_contacts.size(); ++i) {
            const SupportLanes& from = scratch_.supports[first_plain_ + i / kLanes];
            ContactConstraint& to = step_.contacts[step_.scalar_contacts[i]];
            for (std::size_t k = 0; k < 2; ++k) to.points[k].static_impulse = from.impulse[k][i % kLanes];
        }
        for (const int support : scratch_.slopes) hold_by_friction(support);
    }

  private:
    [[nodiscard]] bool has_weight(int row) const { return motions_.velocity[row].inverse_mass > 0; }

    // What stands on two points may rock from one to the other, and the more it does the less the estimate
    // says of either: one that yielded as it came down would be put up to the estimate again, and so the body
    // lifted with each turn. From 1 for what stands down to 0.
    [[nodiscard]] float trust_in(const ContactBlock& block, int lane) const {
        const auto& [p, q] = block.points;
        const float speed_m_s = (q.arm_b[lane] - p.arm_b[lane]) * motions_.velocity[block.b[lane]].w -
                                (q.arm_a[lane] - p.arm_a[lane]) * motions_.velocity[block.a[lane]].w;
        return std::clamp(2 - std::fabs(speed_m_s) / kRockingSpeed_m_s, 0.0f, 1.0f);
    }

    // Fast bodies have contacts with what they may meet within the step, however far off: it bears nothing
    // yet.
    [[nodiscard]] static bool is_only_ahead(const ContactConstraint& c) {
        float nearest = c.points[0].separation;
        if (c.count == 2) nearest = std::min(nearest, c.points[1].separation);
        return nearest > c.unit * tuning::kSpeculativeDistance_m;
    }

    // As find_supports has it.
    [[nodiscard]] bool is_slope(const ContactConstraint& c, float along) const {
        const float across = std::fabs(dot(c.normal, right_perp(up_)));
        return along > kSlope && (c.count == 1 || c.friction * along >= across);
    }

    void find_support(const ContactConstraint& c, SupportLanes& to, int lane) const {
        const float along = dot(c.normal, up_);
        const bool b_stands = along > 0;
        const int upper = b_stands ? c.b : c.a;
        const int lower = b_stands ? c.a : c.b;
        if (c.count == 0 || !has_weight(upper) || is_only_ahead(c)) return;
        if (std::fabs(along) <= kBearing && (has_weight(lower) || !is_slope(c, std::fabs(along)))) return;
        to.upper[lane] = upper;
        to.lower[lane] = has_weight(lower) ? lower : kWorldRow;
        to.points[lane] = c.count;
        to.steepness[lane] = std::fabs(along);
        const float k_upper = motions_.pose[upper].k;
        const float k_lower = lower == kWorldRow ? 0 : motions_.pose[lower].k;
        for (int i = 0; i < 2; ++i) {
            const ContactPointConstraint& p = c.points[i];
            to.x[i][lane] = k_upper * dot(b_stands ? p.r_b : p.r_a, right_perp(up_));
            to.x_below[i][lane] = k_lower * dot(b_stands ? p.r_a : p.r_b, right_perp(up_));
        }
    }

    // Each body to its supports.
    void link() {
        const std::span<const int> blocks = lanes_.blocks();
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            const std::size_t ahead = i + kBlocksAhead;
            if (ahead < blocks.size()) prefetch(&scratch_.supports[blocks[ahead]], 2 * kCacheLine_B);
            link(static_cast<std::size_t>(blocks[i]));
        }
        for (std::size_t i = first_plain_; i < scratch_.supports.size(); ++i) link(i);
    }

    void link(std::size_t block) {
        const SupportLanes& lanes = scratch_.supports[block];
        for (int lane = 0; lane < kLanes; ++lane) {
            const int upper = lanes.upper[lane];
            if (upper == kWorldRow) continue;
            const int support = static_cast<int>(block) * kLanes + lane;
            if (lanes.steepness[lane] <= kBearing) {
                if (!touches_only_one(upper)) continue;
                push_amply(scratch_.slopes, support);
            }
            StaticsScratch::Stand& stand = scratch_.stands[upper];
            scratch_.next[support] = stand.first;
            stand.first = support;
            ++scratch_.stands[lanes.lower[lane]].above;
        }
    }

    // What lies on two points of a slope and is new there: its friction is guessed as its weight is, or it
    // would turn while it is found. What has one point may roll.
    void hold_by_friction(int support) {
        const auto block = static_cast<std::size_t>(support / kLanes);
        const int lane = support % kLanes;
        const SupportLanes& s = scratch_.supports[block];
        if (s.points[lane] != 2) return;
        const auto hold = [&](Vec2 normal, float remembered, float& friction_impulse) {
            if (remembered >= 0) return;
            const float slope = dot(up_, right_perp(normal)) / dot(up_, normal);
            friction_impulse = slope * (s.impulse[0][lane] + s.impulse[1][lane]);
        };
        if (block < first_plain_) {
            ContactBlock& to = lanes_.block(static_cast<int>(block));
            hold({to.normal_x[lane], to.normal_y[lane]}, to.points[0].impulse[lane],
                 to.friction_impulse[lane]);
        } else {
            const std::size_t place = (block - first_plain_) * kLanes + static_cast<std::size_t>(lane);
            ContactConstraint& to = step_.contacts[step_.scalar_contacts[place]];
            hold(to.normal, to.points[0].normal_impulse, to.friction_impulse);
        }
    }

    [[nodiscard]] bool touches_only_one(int row) const {
        const int body = stores_.bodies.rows(RowSet::Awake).body[static_cast<std::size_t>(row - 1)];
        // Each contact in a lane has points, and a colour of its own.
        const auto at = static_cast<std::size_t>(body);
        const std::vector<std::uint32_t>& colors = stores_.contacts.colors;
        if (at < colors.size() && is_in_several(colors[at])) return false;
        int touching = 0;
        for_each_edge(
            stores_.contacts.slots, stores_.bodies.slots[body].first_contact,
            [&](int contact, int) { touching += stores_.contacts.slots[contact].has_points ? 1 : 0; });
        return touching == 1;
    }

    // Shares what stands on a body, and its own weight, among its supports.
    void bear(int row, float weight) {
        const StaticsScratch::Stand& stand = scratch_.stands[row];
        const float load = stand.load + weight;
        std::size_t points = 0;
        for (int i = stand.first; i != kNone; i = scratch_.next[i]) {
            const SupportLanes& s = scratch_.supports[i / kLanes];
            if (points + 2 > scratch_.x.size()) resize_amply(scratch_.x, points + 2);
            scratch_.x[points++] = s.x[0][i % kLanes];
            if (s.points[i % kLanes] == 2) scratch_.x[points++] = s.x[1][i % kLanes];
        }
        if (scratch_.shares.size() < points) resize_amply(scratch_.shares, points);
        float* const shares = scratch_.shares.data();
        if (load > 0) {
            share_among(scratch_.x.data(), load, stand.moment, shares, points);
        } else {
            std::fill_n(shares, points, 0.0f);
        }
        std::size_t point = 0;
        for (int i = stand.first; i != kNone; i = scratch_.next[i]) {
            SupportLanes& s = scratch_.supports[i / kLanes];
            const int lane = i % kLanes;
            const int lower = s.lower[lane];
            StaticsScratch::Stand& below = scratch_.stands[lower];
            for (int k = 0; k < s.points[lane]; ++k, ++point) {
                s.impulse[k][lane] = s.steepness[lane] * shares[point];
                below.load += shares[point];
                below.moment += s.x_below[k][lane] * shares[point];
            }
            if (lower != kWorldRow && --below.above == 0) push_amply(scratch_.ready, lower);
        }
    }

    ContactLanes& lanes_;
    const Stores& stores_;
    StepScratch& step_;
    const Motions& motions_;
    StaticsScratch& scratch_;
    Vec2 up_;
    std::size_t first_plain_;  // of the supports' blocks
};

// Contacts that are in no lane.
bool has_others(const Stores& stores, const StepScratch& scratch) {
    return !scratch.scalar_contacts.empty() || !stores.contacts.loose.empty();
}

// Whether the last estimate stands: the contacts are the same, and all that they bear weighs the same.
bool is_known(const Stores& stores, Vec2 weight_ns_kg, const StepScratch& scratch) {
    const StandingScratch& standing = *scratch.standing;
    const auto same = [](const Drive& drive, float scale) { return drive.gravity_scale == scale; };
    return standing.all_blocks_known && !has_others(stores, scratch) &&
           standing.weight_ns_kg == weight_ns_kg &&
           std::ranges::equal(scratch.drives, standing.gravity_scales, same);
}

Vec2 up(Vec2 gravity_m_s2) {
    return (-1 / length(gravity_m_s2)) * gravity_m_s2;
}

void note_weights(const Stores& stores, Vec2 weight_ns_kg, StepScratch& scratch) {
    StandingScratch& standing = *scratch.standing;
    standing.weight_ns_kg = weight_ns_kg;
    standing.gravity_scales.clear();
    reserve_amply(standing.gravity_scales, scratch.drives.size());
    if (!standing.unmoved.some() || has_others(stores, scratch)) return;
    resize_amply(standing.gravity_scales, scratch.drives.size());
    std::ranges::transform(scratch.drives, standing.gravity_scales.begin(), &Drive::gravity_scale);
}

}  // namespace

StaticsEstimate::StaticsEstimate(Stores& stores, Vec2 gravity_m_s2, const StepTime& time,
                                 StepScratch& scratch, TaskPool& tasks)
    : stores_(stores), scratch_(scratch), gravity_m_s2_(gravity_m_s2), h_s_(time.h_s) {
    if (length(gravity_m_s2) == 0 || is_known(stores, h_s_ * gravity_m_s2, scratch)) return;
    note_weights(stores, h_s_ * gravity_m_s2, scratch);
    if (!scratch.statics) scratch.statics = std::make_unique<StaticsScratch>();
    Estimate(stores, scratch, up(gravity_m_s2)).find_supports(tasks);
    next_ = Next::ShareLoads;
}

void StaticsEstimate::share_loads() {
    if (next_ != Next::ShareLoads) return;
    Estimate(stores_, scratch_, up(gravity_m_s2_)).share_loads(h_s_ * length(gravity_m_s2_));
    next_ = Next::Tell;
}

void StaticsEstimate::finish(TaskPool& tasks) {
    share_loads();
    if (next_ == Next::Tell) Estimate(stores_, scratch_, up(gravity_m_s2_)).tell(tasks);
    next_ = Next::Nothing;
}

}  // namespace cairn::physics
