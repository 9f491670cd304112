// Loads handed down from body to body. Glossary, along and across gravity, relative to a body's centre of
// mass: F load (own weight and what stands on it), M its moment sum(x F), x_j places of the n supporting
// points, x_m their mean. Places are arms as the solver has them, scaled by k = sqrt(1/I) of their body.
//     lambda_j = F/n + (x_j - x_m)(M/F - x_m) F / sum (x - x_m)^2
// is the distribution of least squares that carries F and M; where a share would pull, the two outermost
// points take all. Bodies are visited when all that stands on them has been (Kahn 1962): no sorting, and what
// leans in a ring stays at 0.
#include "world/statics.h"

#include <algorithm>

namespace cairn::physics {
namespace {

// Contacts steeper than this do not bear, in this estimate: cosine between normal and gravity, 8 degrees. On
// steeper ones friction and wedging decide, of which it knows nothing; with 60 degrees heaps were seen to
// tremble.
constexpr float kBearing = 0.99f;

// Supports this near each other, squared and scaled as arms are, act as one.
constexpr float kNarrow = 1e-8f;

void share_by_lever(std::span<const float> x, float load, float center, std::span<float> shares) {
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    std::fill(shares.begin(), shares.end(), 0.0f);
    const float width = *high - *low;
    const float t = width > 0 ? std::clamp((center - *low) / width, 0.0f, 1.0f) : 0.0f;
    shares[low - x.begin()] += (1 - t) * load;
    shares[high - x.begin()] += t * load;
}

void share(std::span<const float> x, float load, float center, std::span<float> shares) {
    const auto n = static_cast<float>(x.size());
    float mean = 0;
    for (const float at : x) mean += at / n;
    float spread = 0;
    for (const float at : x) spread += (at - mean) * (at - mean);
    bool pulls = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
        shares[i] = load / n;
        if (spread > kNarrow) shares[i] += (x[i] - mean) * (center - mean) * load / spread;
        pulls |= shares[i] < 0;
    }
    if (pulls) share_by_lever(x, load, center, shares);
}

// The estimate of one step, from contacts in lanes and in plain form alike.
class Estimate {
  public:
    Estimate(const Motions& motions, StaticsScratch& scratch, Vec2 up)
        : motions_(motions), scratch_(scratch), up_(up) {
        const auto rows = static_cast<std::size_t>(motions.size());
        scratch_.supports.clear();
        scratch_.first.assign(rows, kNone);
        scratch_.above.assign(rows, 0);
        scratch_.load.assign(rows, 0);
        scratch_.moment.assign(rows, 0);
        scratch_.ready.clear();
    }

    void add(ContactBlock& block) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const Vec2 normal{block.normal_x[lane], block.normal_y[lane]};
            const float along = dot(normal, up_);
            if (std::fabs(along) <= kBearing) continue;
            add(block, lane, along, dot(normal, right_perp(up_)));
        }
    }

    void add(ContactConstraint& c) {
        const float along = dot(c.normal, up_);
        if (std::fabs(along) <= kBearing) return;
        const auto places = [&](int row, bool b) {
            const float k = row == kWorldRow ? 0 : motions_.pose[row].k;
            std::array<float, 2> x{};
            for (int i = 0; i < c.count; ++i) {
                x[i] = k * dot(b ? c.points[i].r_b : c.points[i].r_a, right_perp(up_));
            }
            return x;
        };
        add_support(along, c.a, c.b, places(c.a, false), places(c.b, true), c.count,
                    {&c.points[0].static_impulse, &c.points[1].static_impulse});
    }

    /// `weight` is that of a unit of mass over a substep, N s/kg.
    void run(std::span<const Drive> drives, float weight) {
        for (int row = 1; row < motions_.size(); ++row) {
            if (scratch_.above[row] == 0) scratch_.ready.push_back(row);
        }
        // The last one first: what stands together is visited together.
        while (!scratch_.ready.empty()) {
            const int row = scratch_.ready.back();
            scratch_.ready.pop_back();
            if (scratch_.first[row] == kNone) continue;
            bear(row, drives[row].gravity_scale * weight / motions_.velocity[row].inverse_mass);
        }
    }

  private:
    // A vertical load acts about a point at its horizontal distance x, which follows from its arms about the
    // normal and the tangent of the contact:  x = (n . up) (r x n) - (n . right) (r x t)
    void add(ContactBlock& block, int lane, float along, float across) {
        const auto places = [&](float arm0, float arm1, float tangent_arm) {
            return std::array<float, 2>{along * arm0 - across * tangent_arm,
                                        along * arm1 - across * tangent_arm};
        };
        const std::array<float, 2> x_a =
            places(block.points[0].arm_a[lane], block.points[1].arm_a[lane], block.tangent_arm_a[lane]);
        const std::array<float, 2> x_b =
            places(block.points[0].arm_b[lane], block.points[1].arm_b[lane], block.tangent_arm_b[lane]);
        const int count = block.points[1].mass[lane] > 0 ? 2 : block.points[0].mass[lane] > 0 ? 1 : 0;
        add_support(along, block.a[lane], block.b[lane], x_a, x_b, count,
                    {&block.points[0].static_impulse[lane], &block.points[1].static_impulse[lane]});
    }

    [[nodiscard]] bool has_weight(int row) const { return motions_.velocity[row].inverse_mass > 0; }

    // `along`: of the normal, which points from a to b, with the upward direction.
    void add_support(float along, int a, int b, std::array<float, 2> x_a, std::array<float, 2> x_b, int count,
                     std::array<float*, 2> impulse) {
        const int upper = along > 0 ? b : a;
        const int lower = along > 0 ? a : b;
        if (count == 0 || !has_weight(upper)) return;
        scratch_.supports.push_back({scratch_.first[upper], lower, std::fabs(along), count,
                                     along > 0 ? x_b : x_a, along > 0 ? x_a : x_b, impulse});
        scratch_.first[upper] = static_cast<int>(scratch_.supports.size()) - 1;
        if (has_weight(lower)) ++scratch_.above[lower];
    }

    // Shares what stands on a body, and its own weight, among its supports.
    void bear(int row, float weight) {
        const float load = scratch_.load[row] + weight;
        scratch_.x.clear();
        for (int i = scratch_.first[row]; i != kNone; i = scratch_.supports[i].next) {
            const Support& s = scratch_.supports[i];
            for (int k = 0; k < s.count; ++k) scratch_.x.push_back(s.x[k]);
        }
        scratch_.shares.assign(scratch_.x.size(), 0);
        if (load > 0) share(scratch_.x, load, scratch_.moment[row] / load, scratch_.shares);
        std::size_t point = 0;
        for (int i = scratch_.first[row]; i != kNone; i = scratch_.supports[i].next) {
            const Support& s = scratch_.supports[i];
            for (int k = 0; k < s.count; ++k, ++point) {
                const float part = scratch_.shares[point];
                *s.impulse[k] = s.steepness * part;
                scratch_.load[s.lower] += part;
                scratch_.moment[s.lower] += s.x_below[k] * part;
            }
            if (has_weight(s.lower) && --scratch_.above[s.lower] == 0) scratch_.ready.push_back(s.lower);
        }
    }

    const Motions& motions_;
    StaticsScratch& scratch_;
    Vec2 up_;
};

}  // namespace

void estimate_statics(ContactLanes& lanes, Vec2 gravity_m_s2, const StepTime& time, StepScratch& scratch) {
    const float gravity = length(gravity_m_s2);
    if (gravity == 0) return;
    Estimate estimate(scratch.motions, scratch.statics, (-1 / gravity) * gravity_m_s2);
    for (const int block : lanes.blocks()) estimate.add(lanes.block(block));
    for (const int i : scratch.scalar_contacts) estimate.add(scratch.contacts[i]);
    estimate.run(scratch.drives, gravity * time.h_s);
}

}  // namespace cairn::physics
