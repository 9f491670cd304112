// What stages do with each awake body, for eight rows at a time.
#pragma once

#include <span>

#include "base/lanes.h"
#include "collide/place_lanes.h"
#include "world/body_store.h"

namespace cairn::physics {

/// Eight awake rows from `first` on, or as many as there are. Where there are fewer the last stands for the
/// others.
struct BodyLanes {
    int first = 0;
    int count = 0;
    Lanes<const BodyRecord*> records{};
    Lanes<Place*> places{};
};
BodyLanes body_lanes(BodyStore& bodies, int first, int last);

/// What a step is expected to do with eight bodies.
struct alignas(32) AheadLanes {
    Lanes<float> way_x{};  // m
    Lanes<float> way_y{};
    Lanes<float> turn{};      // rad
    Lanes<float> rounding{};  // m that float may lose where the way is added up
    Lanes<float>
        room{};  // m: no point goes further aside from the straight way between its ends; rounding included
    Lanes<Advance> advances{};
    LaneBits fast = 0;       // a point goes further than half of what is solid about the thinnest shape
    LaneBits hasty = 0;      // further than `calm_way_m`: all fast ones, too
    LaneBits far_ways = 0;   // the centre of mass goes further than the body's extent
    LaneBits seen_late = 0;  // a point goes further than `seen_m`
};
void look_ahead(const BodyStore& bodies, const BodyLanes& lanes, Vec2 gravity_m_s2, float dt_s, float seen_m,
                AheadLanes& ahead);

struct PlaceOutcome {
    LaneBits hurled = 0;    // gone so far, unexpectedly, that they could have passed through others
    LaneBits box_left = 0;  // of which a box may have been left
    LaneBits rest_by_rule =
        0;  // kinematic or tiny: how long they have been at rest is left for the caller to tell
};
/// Bodies take the places to which their motions led them, and keep what the step did, and how long they have
/// been at rest if they may sleep.
PlaceOutcome take_places(BodyStore& bodies, const BodyLanes& lanes, const Motions& motions,
                         std::span<const Advance> advances, float dt_s, bool sleep_enabled);

}  // namespace cairn::physics
