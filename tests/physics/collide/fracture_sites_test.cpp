#include "collide/fracture_sites.h"

#include <catch2/catch.hpp>

#include "physics/support/rings.h"

namespace cairn::physics {
namespace {

using namespace test;

double least_distance(const std::vector<RingPoint>& sites) {
    double least = 1e9;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) least = std::min(least, length(sites[i] - sites[k]));
    }
    return least;
}

TEST_CASE("Uniform sites lie within the rings, in proportion to their areas, and apart", "[fracture]") {
    Ring small = box_ring(1, 1);
    for (RingPoint& p : small) p.x += 10;
    const std::vector<Ring> rings{box_ring(3, 1), small};
    const std::vector<RingPoint> sites = uniform_sites(rings, 100, 7);
    REQUIRE(sites.size() == 100);
    int in_first = 0;
    for (const RingPoint p : sites) {
        REQUIRE((contains(rings[0], p) || contains(rings[1], p)));
        in_first += contains(rings[0], p) ? 1 : 0;
    }
    CHECK(in_first >= 65);  // 75 by area
    CHECK(in_first <= 85);
    // Each site has 0.16 m2; drawn without care, the nearest two would be about 0.01 m apart.
    CHECK(least_distance(sites) > 0.1);
}

TEST_CASE("Radial sites are about as many as asked for, and denser towards the centre", "[fracture]") {
    const std::vector<Ring> rings{box_ring(2, 2)};
    for (const int count : {12, 40, 150}) {
        for (const RingPoint center : {RingPoint{}, RingPoint{-2, 0.3}, RingPoint{2, 2}}) {
            const std::vector<RingPoint> sites = radial_sites(rings, center, count, 0.01, 3);
            CHECK(static_cast<double>(sites.size()) == Approx(count).epsilon(0.3));
            int near = 0;
            for (const RingPoint p : sites) {
                REQUIRE(contains(rings[0], p));
                near += length(p - center) < 1 ? 1 : 0;
            }
            // Of the area, at most pi / 16 is as near as that.
            CHECK(near > 0.3 * static_cast<double>(sites.size()));
        }
    }
}

TEST_CASE("Sites depend on the seed, and on nothing else", "[fracture]") {
    const std::vector<Ring> rings{box_ring(1, 1)};
    CHECK(uniform_sites(rings, 20, 5) == uniform_sites(rings, 20, 5));
    CHECK(uniform_sites(rings, 20, 5) != uniform_sites(rings, 20, 6));
    CHECK(radial_sites(rings, {}, 20, 0.01, 5) == radial_sites(rings, {}, 20, 0.01, 5));
    CHECK(radial_sites(rings, {}, 20, 0.01, 5) != radial_sites(rings, {}, 20, 0.01, 6));
}

}  // namespace
}  // namespace cairn::physics
