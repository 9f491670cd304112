#include "collide/voronoi.h"

#include <catch2/catch.hpp>

#include "physics/support/rings.h"

namespace cairn::physics {
namespace {

using namespace test;

std::vector<RingPoint> random_sites(Random& random, int count) {
    std::vector<RingPoint> sites;
    for (int i = 0; i < count; ++i) {
        const double x = random.real(-2, 2);
        sites.push_back({x, random.real(-1, 1)});
    }
    return sites;
}

TEST_CASE("Voronoi cells tile their bounds", "[voronoi]") {
    Random random(1);
    for (int count = 1; count <= 60; ++count) {
        const std::vector<RingPoint> sites = random_sites(random, count);
        double sum = 0;
        for (const Ring& cell : voronoi_cells(sites, box_ring(2, 1))) {
            REQUIRE(is_convex(cell));
            sum += area(cell);
        }
        REQUIRE(sum == Approx(8).epsilon(1e-12));
    }
}

TEST_CASE("A point is in the Voronoi cell of the site nearest to it", "[voronoi]") {
    Random random(2);
    const std::vector<RingPoint> sites = random_sites(random, 50);
    const std::vector<Ring> cells = voronoi_cells(sites, box_ring(2, 1));
    for (const RingPoint point : random_sites(random, 2000)) {
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < sites.size(); ++i) {
            if (length(sites[i] - point) < length(sites[nearest] - point)) nearest = i;
        }
        REQUIRE(contains(cells[nearest], point));
    }
}

TEST_CASE("Sites in a lattice, on a line, twice, or outside give the cells that they should", "[voronoi]") {
    const Ring bounds = box_ring(2, 1);
    const std::vector<Ring> lattice =
        voronoi_cells(std::array<RingPoint, 4>{{{-1, -.5}, {1, -.5}, {-1, .5}, {1, .5}}}, bounds);
    for (const Ring& cell : lattice) CHECK(area(cell) == Approx(2));
    const std::vector<Ring> line = voronoi_cells(std::array<RingPoint, 3>{{{-1, 0}, {0, 0}, {1, 0}}}, bounds);
    CHECK(area(line[0]) == Approx(3));
    CHECK(area(line[1]) == Approx(2));
    const std::vector<Ring> twice = voronoi_cells(std::array<RingPoint, 2>{{{0.5, 0}, {0.5, 0}}}, bounds);
    CHECK(area(twice[0]) == Approx(8));
    CHECK(twice[1].empty());
    const std::vector<Ring> outside = voronoi_cells(std::array<RingPoint, 2>{{{0, 0}, {9, 0}}}, bounds);
    CHECK(area(outside[0]) == Approx(8));
    CHECK(outside[1].empty());
}

}  // namespace
}  // namespace cairn::physics
