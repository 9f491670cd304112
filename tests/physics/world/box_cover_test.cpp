// Boxes of eight shapes at once against those of one shape, and against the shapes themselves on their way.
#include "world/box_cover.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <cairn/physics/simd.h>
#include <cairn/physics/tuning.h>

#include "physics/support/random.h"
#include "physics/support/random_shapes.h"
#include "world/bodies.h"
#include "world/finalize.h"

namespace cairn::physics {
namespace {

using test::Form;
using test::kForms;
using test::Random;

// Eight shapes on bodies of their own, somewhere.
struct Eight {
    CoverLanes lanes;
    Lanes<Convex> shapes;
    Lanes<Place> places;
    Lanes<Vec2> centers;
    Lanes<Aabb> boxes;

    Eight(Random& random, bool boxes_only) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const Form form =
                boxes_only ? Form::Box : kForms[static_cast<std::size_t>(random.below(std::size(kForms)))];
            // Boxes along the axes are those of which lanes know the half sizes.
            shapes[lane] = boxes_only || random.chance(0.3)
                               ? make_convex(Box{random.real_f(0.05, 1), random.real_f(0.05, 1),
                                                 random.vector(-0.3, 0.3)})
                                     .value()
                               : random_convex(random, form);
            const double far = random.chance(0.2) ? 1e6 : 10;
            places[lane].center = {random.real(-far, far), random.real(-far, far)};
            places[lane].rotation = Rotation::from_angle(random.real(-4, 4));
            centers[lane] = random.vector(-0.5, 0.5);
            lanes.margin[lane] = random.real_f(0.01, 0.2);
            lanes.radius[lane] = shapes[lane].radius();
            lanes.count[lane] = shapes[lane].count();
            lanes.places[lane] = &places[lane];
            lanes.centers[lane] = &centers[lane];
            lanes.shapes[lane] = &shapes[lane];
            lanes.boxes[lane] = &boxes[lane];
            set_lane_bit(lanes.right_boxes, lane, shapes[lane].is_box);
            if (!shapes[lane].is_box) lanes.most_points = std::max(lanes.most_points, shapes[lane].count());
            boxes[lane] = grown(bounds_at(lane, {}, 0), random.real_f(0, 0.1));
        }
    }

    // Where a lane's shape is when its body has moved and turned.
    [[nodiscard]] Aabb bounds_at(int lane, Vec2 moved, float turned) const {
        const Rotation q = Rotation::from_angle(static_cast<double>(turned)) * places[lane].rotation;
        const Position center = places[lane].center + moved;
        return bounds(shapes[lane], {center + -rotate(q, centers[lane]), q});
    }
};

TEST_CASE("boxes of eight shapes that stand are those of each shape, at every SIMD level") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        Random random(7);
        for (int round = 0; round < 200; ++round) {
            Eight eight(random, round % 3 == 0);
            const Lanes<Aabb> before = eight.boxes;
            const LaneBits anew = cover_boxes(eight.lanes, false);
            for (int lane = 0; lane < kLanes; ++lane) {
                const Place& place = eight.places[lane];
                const Transform xf{place.center + -rotate(place.rotation, eight.centers[lane]),
                                   place.rotation};
                const Aabb all = bounds(eight.shapes[lane], xf);
                const Aabb reach = grown(all, tuning::kAabbReach_m);
                const bool left = !contains(before[lane], reach);
                const Aabb expected = left ? grown(all, eight.lanes.margin[lane]) : before[lane];
                INFO(name(level) << ", round " << round << ", lane " << lane);
                CHECK((anew >> lane & 1) == (left ? 1 : 0));
                CHECK(eight.boxes[lane].lower == expected.lower);
                CHECK(eight.boxes[lane].upper == expected.upper);
                CHECK(eight.lanes.slack[lane] == clearance(expected, reach));
            }
        }
    }
    force_simd_level(levels.back()).value();
}

// What a lane's box is to become, shape by shape and in the order in which the lanes add up.
struct Covered {
    Aabb box;
    bool anew = false;
    float slack = 0;
};
Covered covered(const Eight& eight, int lane, const Aabb& before) {
    const CoverLanes& lanes = eight.lanes;
    const Place& place = eight.places[lane];
    const Vec2 way{lanes.way_x[lane], lanes.way_y[lane]};
    const Rotation end_turn = Rotation::from_small_angle(lanes.turn[lane]) * place.rotation;
    const Vec2 center = eight.centers[lane];
    const Vec2 swing = rotate(place.rotation, center) - rotate(end_turn, center);
    const Extents start = extents(eight.shapes[lane], place.rotation);
    const Extents end = extents(eight.shapes[lane], end_turn);
    const bool goes_along = (lanes.going_along >> lane & 1) != 0;
    Vec2 lower = smallest(start.lower, end.lower + (way + swing));
    Vec2 upper = largest(start.upper, end.upper + (way + swing));
    if (goes_along) {
        lower = smallest(start.lower, end.lower + swing) + smallest({}, way);
        upper = largest(start.upper, end.upper + swing) + largest({}, way);
    }
    const Position origin = place.center + -rotate(place.rotation, center);
    const Aabb all = grown(make_aabb(origin, lower, upper), lanes.room[lane]);
    const Aabb reach = grown(all, tuning::kAabbReach_m);
    Covered result;
    result.anew = goes_along || !contains(before, reach);
    result.box = result.anew ? grown(all, lanes.margin[lane]) : before;
    result.slack = clearance(result.box, reach);
    return result;
}

TEST_CASE("boxes of eight shapes that move are those of each shape, and hold it on all of its way") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        Random random(11);
        for (int round = 0; round < 200; ++round) {
            Eight eight(random, round % 3 == 0);
            for (int lane = 0; lane < kLanes; ++lane) {
                const Vec2 way = random.vector(-3, 3);
                // Some turn too far for the polynomial, some not at all.
                const float turn = random.chance(0.2)   ? 0
                                   : random.chance(0.3) ? random.real_f(-3, 3)
                                                        : random.real_f(-0.4, 0.4);
                const float arm = farthest_distance(eight.shapes[lane], eight.centers[lane]);
                eight.lanes.way_x[lane] = way.x;
                eight.lanes.way_y[lane] = way.y;
                eight.lanes.turn[lane] = turn;
                // A chord is this far from its arc at most; float may lose a little of a way.
                eight.lanes.room[lane] =
                    arm * (1 - std::cos(0.5f * turn) + 1e-6f) + 1e-6f * (length(way) + arm);
                set_lane_bit(eight.lanes.going_along, lane, random.chance(0.5));
            }
            const Lanes<Aabb> before = eight.boxes;
            const LaneBits anew = cover_boxes(eight.lanes, true);
            for (int lane = 0; lane < kLanes; ++lane) {
                INFO(name(level) << ", round " << round << ", lane " << lane);
                const Covered expected = covered(eight, lane, before[lane]);
                CHECK((anew >> lane & 1) == (expected.anew ? 1 : 0));
                CHECK(eight.boxes[lane].lower == expected.box.lower);
                CHECK(eight.boxes[lane].upper == expected.box.upper);
                CHECK(eight.lanes.slack[lane] == expected.slack);

                const Position center = eight.places[lane].center;
                // What is exact about a million metres away is a sixteenth of one.
                const float exact = std::max(std::abs(center.x), std::abs(center.y)) > 1e3 ? 0.2f : 2e-6f;
                const Aabb held = grown(eight.boxes[lane], exact);
                const Vec2 way{eight.lanes.way_x[lane], eight.lanes.way_y[lane]};
                for (int i = 0; i <= 8; ++i) {
                    const float share = static_cast<float>(i) / 8;
                    CHECK(contains(held, eight.bounds_at(lane, share * way, share * eight.lanes.turn[lane])));
                }
                // What goes along holds the shape at either end, turned as at the other.
                if ((eight.lanes.going_along >> lane & 1) == 0) continue;
                CHECK(contains(held, eight.bounds_at(lane, way, 0)));
                CHECK(contains(held, eight.bounds_at(lane, {}, eight.lanes.turn[lane])));
            }
        }
    }
    force_simd_level(levels.back()).value();
}

// Bodies of so many shapes each, which have moved since their boxes were made: some of them far enough to
// leave some.
struct Crowd {
    Stores stores{1};
    std::vector<int> bodies;

    Crowd() {
        Random random(13);
        for (const int count : {0, 1, 7, 8, 9, 20, 2, 0, 3, 1}) {
            BodyDef def;
            def.position_m = {random.real(-9, 9), random.real(-9, 9)};
            def.angle_rad = random.real_f(-3, 3);
            const int body = create_body(stores, def);
            for (int i = 0; i < count; ++i)
                add_shape(stores, body,
                          random_convex(random, kForms[static_cast<std::size_t>(i) % kForms.size()]), {});
            Place& place = stores.bodies.places[static_cast<std::size_t>(body)];
            place.center = place.center + random.vector(-0.2, 0.2);
            place.rotation = Rotation::from_angle(random.real(-0.1, 0.1)) * place.rotation;
            bodies.push_back(body);
        }
    }
};

TEST_CASE("bodies of many shapes have the boxes in lanes that each of them has by itself") {
    Crowd together;
    Crowd alone;
    std::vector<int> untold;
    BoxCover boxes(together.stores, untold);
    for (const int body : together.bodies) boxes.add(body);
    boxes.finish();
    std::vector<int> expected;
    for (const int body : alone.bodies) {
        const std::vector<Aabb> before = alone.stores.fat_boxes;
        update_boxes(alone.stores, body);
        for (int s = alone.stores.bodies.slots[body].first_shape; s != kNone;
             s = alone.stores.shapes[s].next_of_body) {
            const auto at = static_cast<std::size_t>(s);
            const Aabb& now = alone.stores.fat_boxes[at];
            if (now.lower != before[at].lower || now.upper != before[at].upper) expected.push_back(s);
            CHECK(together.stores.fat_boxes[at].lower == now.lower);
            CHECK(together.stores.fat_boxes[at].upper == now.upper);
        }
    }
    CHECK(untold == expected);
    CHECK((!expected.empty() && expected.size() < alone.stores.fat_boxes.size()));
    CHECK(together.stores.bodies.rows(RowSet::Awake).box_slack ==
          alone.stores.bodies.rows(RowSet::Awake).box_slack);
}

}  // namespace
}  // namespace cairn::physics
