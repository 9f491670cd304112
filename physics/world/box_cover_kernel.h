// Boxes of the broad phase for eight shapes at a time.
#pragma once

#include "base/aabb.h"
#include "base/lanes.h"
#include "base/place.h"
#include "collide/convex.h"

namespace cairn::physics {

/// One shape per lane. The box encloses the shape where it is and where its body is expected, which is `way`
/// on and `turn` further round, and all that lies between.
struct alignas(32) CoverLanes {
    Lanes<float> way_x{};  // m
    Lanes<float> way_y{};
    Lanes<float> turn{};    // rad
    Lanes<float> room{};    // m, about all that is enclosed
    Lanes<float> margin{};  // m, about that, for boxes that are made anew
    Lanes<float> radius{};  // of the shape
    Lanes<std::int32_t> count{};
    Lanes<float> slack{};  // what the kernel finds: m that the shape may move within its box
    Lanes<const Place*> places{};
    Lanes<const Vec2*> centers{};  // of mass, in the body's frame
    Lanes<const Convex*> shapes{};
    Lanes<Aabb*> boxes{};
    LaneBits right_boxes = 0;  // lanes of which the shape is a box
    LaneBits going_along = 0;  // lanes of which the box goes along the way: it holds the shape on all of it
    int most_points = 0;
};

/// Makes those boxes anew that do not enclose what they must with kAabbReach_m to spare, and those that go
/// along: the lanes of them. All eight lanes are read and written, so those that are not needed must name
/// something, too. `moving`: some lane has a way or a turn. Same bits at every SIMD level, and as `extents`
/// and `make_aabb` give.
LaneBits cover_boxes(CoverLanes& lanes, bool moving);

}  // namespace cairn::physics
