// Patterns of sites.
#include "collide/fracture_sites.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "base/split_mix.h"

namespace cairn::physics {
namespace {

// Tries for each uniform site. Fewer: pieces of very different sizes; more: they look laid out by hand.
constexpr int kCandidates = 10;

// Of a cell between rays and circles: how much longer it is outward than around. Glass breaks into shards.
constexpr double kShardAspect = 2.5;
// How far a radial site may be out of place, in spacings. Larger: the rays can no longer be seen.
constexpr double kJitter = 0.14;
// The innermost circle, of the farthest way from the centre.
constexpr double kInnermost = 0.1;
constexpr int kMaxRays = 64;

struct Triangle {
    RingPoint a, b, c;
};

// Draws points evenly from the area of the rings.
class PointsWithin {
  public:
    explicit PointsWithin(std::span<const Ring> rings) {
        for (const Ring& ring : rings) {
            for (std::size_t i = 2; i < ring.size(); ++i) {
                const Triangle t{ring[0], ring[i - 1], ring[i]};
                total_ += cross(t.b - t.a, t.c - t.a) / 2;
                triangles_.emplace_back(total_, t);
            }
        }
    }

    RingPoint draw(SplitMix& random) const {
        const double at = random.real(0, total_);
        const auto found = std::find_if(triangles_.begin(), triangles_.end() - 1,
                                        [&](const auto& entry) { return at < entry.first; });
        double u = random.real(0, 1);
        double v = random.real(0, 1);
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        const Triangle& t = found->second;
        return t.a + u * (t.b - t.a) + v * (t.c - t.a);
    }

  private:
    std::vector<std::pair<double, Triangle>> triangles_;  // with the area up to and with each
    double total_ = 0;
};

double distance_to_nearest(std::span<const RingPoint> sites, RingPoint point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const RingPoint site : sites) nearest = std::min(nearest, length(site - point));
    return nearest;
}

bool is_within(std::span<const Ring> rings, RingPoint point) {
    return std::any_of(rings.begin(), rings.end(), [&](const Ring& ring) { return contains(ring, point); });
}

std::vector<RingPoint> web_sites(std::span<const Ring> rings, RingPoint center, int rays, double innermost,
                                 double outermost, std::uint64_t seed) {
    SplitMix random(seed);
    const double turn = 2 * deterministic::acos(-1);
    const double growth = 1 + kShardAspect * turn / rays;
    const double start = random.real(0, turn);
    std::vector<RingPoint> sites;
    if (is_within(rings, center)) sites.push_back(center);
    for (double radius = innermost; radius < outermost; radius *= growth) {
        for (int ray = 0; ray < rays; ++ray) {
            const double angle = start + (ray + random.real(-kJitter, kJitter)) * turn / rays;
            const double way = radius * (1 + random.real(-kJitter, kJitter) * (growth - 1));
            const RingPoint site =
                center + way * RingPoint{deterministic::cos(angle), deterministic::sin(angle)};
            if (is_within(rings, site)) sites.push_back(site);
        }
    }
    return sites;
}

}  // namespace

std::vector<RingPoint> uniform_sites(std::span<const Ring> rings, int count, std::uint64_t seed) {
    SplitMix random(seed);
    const PointsWithin points(rings);
    std::vector<RingPoint> sites;
    while (static_cast<int>(sites.size()) < count) {
        RingPoint best = points.draw(random);
        double best_distance = distance_to_nearest(sites, best);
        for (int i = 1; i < kCandidates; ++i) {
            const RingPoint candidate = points.draw(random);
            const double distance = distance_to_nearest(sites, candidate);
            if (distance <= best_distance) continue;
            best = candidate;
            best_distance = distance;
        }
        sites.push_back(best);
    }
    return sites;
}

std::vector<RingPoint> radial_sites(std::span<const Ring> rings, RingPoint center, int count,
                                    double least_radius, std::uint64_t seed) {
    double outermost = 0;
    for (const Ring& ring : rings) {
        for (const RingPoint p : ring) outermost = std::max(outermost, length(p - center));
    }
    const double innermost = std::max(least_radius, kInnermost * outermost);
    // More rays make more circles too. How many sites fall within the body only trying tells.
    std::vector<RingPoint> best;
    for (int rays = 3; rays <= kMaxRays; ++rays) {
        std::vector<RingPoint> sites = web_sites(rings, center, rays, innermost, outermost, seed);
        const auto miss = [&](const auto& list) { return std::abs(static_cast<int>(list.size()) - count); };
        const bool is_enough = static_cast<int>(sites.size()) >= count;
        if (miss(sites) < miss(best) || best.empty()) best = std::move(sites);
        if (is_enough) break;
    }
    return best;
}

}  // namespace cairn::physics
