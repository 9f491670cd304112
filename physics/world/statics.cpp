// Loads handed down from body to body. Glossary, along and across gravity, relative to a body's centre of
// mass: F load (own weight and what stands on it), M its moment sum(x F), x_j places of the n supporting
// points, x_m their mean.
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

struct Bearing {
    int upper = kNone;  // body; kNone: the contact does not bear
    int lower = kNone;
    float steepness = 0;
};

Bearing bearing_of(const ContactRecord& c, Vec2 up) {
    const float along = dot(c.normal, up);
    if (c.count == 0 || std::fabs(along) <= kBearing) return {};
    return along > 0 ? Bearing{c.body_b, c.body_a, along} : Bearing{c.body_a, c.body_b, -along};
}

void share_by_lever(std::span<const Support> supports, float load, float center, std::span<float> shares) {
    const auto [low, high] = std::minmax_element(
        supports.begin(), supports.end(), [](const Support& p, const Support& q) { return p.x < q.x; });
    std::fill(shares.begin(), shares.end(), 0.0f);
    const float width = high->x - low->x;
    const float t = width > 0 ? std::clamp((center - low->x) / width, 0.0f, 1.0f) : 0.0f;
    shares[low - supports.begin()] += (1 - t) * load;
    shares[high - supports.begin()] += t * load;
}

void share(std::span<const Support> supports, float load, float center, std::span<float> shares) {
    const auto n = static_cast<float>(supports.size());
    float mean = 0;
    for (const Support& s : supports) mean += s.x / n;
    float spread = 0;
    for (const Support& s : supports) spread += (s.x - mean) * (s.x - mean);
    bool pulls = false;
    for (std::size_t i = 0; i < supports.size(); ++i) {
        shares[i] = load / n;
        if (spread > 1e-8f) shares[i] += (supports[i].x - mean) * (center - mean) * load / spread;
        pulls |= shares[i] < 0;
    }
    if (pulls) share_by_lever(supports, load, center, shares);
}

void find_supports(const Stores& stores, int body, Vec2 up, std::vector<Support>& supports) {
    const Vec2 right = right_perp(up);
    supports.clear();
    for_each_edge(stores.contacts.slots, stores.bodies.slots[body].first_contact, [&](int contact, int side) {
        const ContactRecord& c = stores.contacts.slots[contact];
        const Bearing bearing = bearing_of(c, up);
        if (bearing.upper != body) return;
        for (int i = 0; i < c.count; ++i) {
            const Vec2 own = side == 1 ? c.points[i].r_b : c.points[i].r_a;
            const Vec2 below = side == 1 ? c.points[i].r_a : c.points[i].r_b;
            supports.push_back(
                {contact, i, bearing.lower, dot(own, right), dot(below, right), bearing.steepness});
        }
    });
}

bool bears_on(const BodyStore& bodies, int body) {
    return body != kNone && bodies.is_awake(body) && bodies.slots[body].inverse_mass > 0;
}

}  // namespace

void estimate_statics(Stores& stores, Vec2 gravity_m_s2, const StepTime& time, StaticsScratch& scratch) {
    const BodyStore& bodies = stores.bodies;
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    const float gravity = length(gravity_m_s2);
    const Vec2 up = gravity > 0 ? (-1 / gravity) * gravity_m_s2 : Vec2{};
    scratch.above.assign(awake.size(), 0);
    for (const int contact : stores.contacts.active) {
        ContactRecord& c = stores.contacts.slots[contact];
        c.points[0].static_impulse = c.points[1].static_impulse = 0;
        const Bearing bearing = bearing_of(c, up);
        if (bears_on(bodies, bearing.lower) && bears_on(bodies, bearing.upper)) {
            ++scratch.above[bodies.slots[bearing.lower].row];
        }
    }
    if (gravity == 0) return;

    scratch.load.assign(awake.size(), 0);
    scratch.moment.assign(awake.size(), 0);
    scratch.ready.clear();
    for (int row = 0; row < awake.size(); ++row) {
        if (scratch.above[row] == 0) scratch.ready.push_back(row);
    }
    for (std::size_t next = 0; next < scratch.ready.size(); ++next) {
        const int row = scratch.ready[next];
        const BodyRecord& record = bodies.slots[awake.body[row]];
        if (record.inverse_mass == 0) continue;
        find_supports(stores, awake.body[row], up, scratch.supports);
        if (scratch.supports.empty()) continue;

        const float load =
            scratch.load[row] + record.mass.mass_kg * gravity * record.gravity_scale * time.h_s;
        scratch.shares.assign(scratch.supports.size(), 0);
        if (load > 0) share(scratch.supports, load, scratch.moment[row] / load, scratch.shares);
        for (std::size_t i = 0; i < scratch.supports.size(); ++i) {
            const Support& s = scratch.supports[i];
            stores.contacts.slots[s.contact].points[s.point].static_impulse = s.steepness * scratch.shares[i];
            if (!bears_on(bodies, s.supporter)) continue;
            const int below = bodies.slots[s.supporter].row;
            scratch.load[below] += scratch.shares[i];
            scratch.moment[below] += s.x_below * scratch.shares[i];
            // Once per contact, with its first point.
            if (s.point == 0 && --scratch.above[below] == 0) scratch.ready.push_back(below);
        }
    }
}

}  // namespace cairn::physics
