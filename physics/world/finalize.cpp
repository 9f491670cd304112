// New places of bodies and boxes.
#include "world/finalize.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>

#include <cairn/physics/tuning.h>

#include "world/body_lanes.h"
#include "world/box_cover.h"
#include "world/contact_lists.h"
#include "world/fast_bodies.h"
#include "world/joint_lists.h"
#include "world/tiny_contacts.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kRowsPerChunk = 512;

// Of a body that is kinematic or tiny.
float rest_time_by_rule(const BodyStore& bodies, const Motions& motions, int row, float dt_s) {
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    const BodyRecord& record = bodies.slots[awake.body[row]];
    const float longer = awake.rest_time[row] + dt_s;
    if (!record.allow_sleep) return 0;
    if (record.type == BodyType::Kinematic)
        return awake.velocity[row] == Vec2{} && awake.spin[row] == 0 ? longer : 0;
    // What is tiny has not come to rest while it moves at a speed that is slow for others.
    const float least_m_s = length_unit(record.extent_m) * record.sleep_speed_m_s;
    const float fastest_m_s =
        std::max(length(awake.velocity[row]), std::fabs(awake.spin[row]) * record.extent_m);
    const float farthest_m =
        std::max(length(awake.moved[row]), std::fabs(motions.angle(row + 1)) * record.extent_m);
    return fastest_m_s < least_m_s && farthest_m < dt_s * least_m_s ? longer : 0;
}

bool is_finite(const Motions& motions, int row) {
    const PoseRow& pose = motions.pose[row];
    const VelocityRow& velocity = motions.velocity[row];
    // A sum is finite only if its terms are (or are too large to be anything but a fault). The angle and the
    // spin themselves: what is finite as rows have it may not be so in rad.
    return std::isfinite(pose.d.x + pose.d.y + motions.angle(row) + velocity.v.x + velocity.v.y +
                         motions.spin(row));
}

// m. What never goes further in a step does not leave the world in a year.
constexpr float kFarStride_m = 1e3f;

// Whether the body would be farther out than anything may be put.
bool leaves_world(const BodyStore& bodies, const Motions& motions, int row) {
    const Vec2 way = motions.pose[row].d;
    if (std::fabs(way.x) + std::fabs(way.y) < kFarStride_m) return false;
    const int body = bodies.rows(RowSet::Awake).body[static_cast<std::size_t>(row - 1)];
    const Position end = bodies.places[static_cast<std::size_t>(body)].center + way;
    return std::max(std::fabs(end.x), std::fabs(end.y)) > kFarthest_m;
}

// A body whose motion is no number any more is put back to where the step found it, and stopped. Its box
// would be found by nobody otherwise, and what it touches would follow it.
void halt(Motions& motions, int row) {
    motions.pose[row].d = {};
    motions.pose[row].theta = 0;
    motions.turned[row] = {};
    motions.velocity[row].v = {};
    motions.velocity[row].w = 0;
}

// Makes the boxes anew for which outdated(box, what it must enclose) says so, by set(shape, box).
template <class Outdated, class Set>
void follow(Stores& stores, int body, Outdated&& outdated, Set&& set) {
    const Transform xf = stores.bodies.transform(body);
    float slack = std::numeric_limits<float>::infinity();
    for (int shape = stores.bodies.slots[body].first_shape; shape != kNone;
         shape = stores.shapes[shape].next_of_body) {
        const ShapeRecord& record = stores.shapes[shape];
        const Aabb box = bounds(record.convex(), xf);
        const Aabb reach = grown(box, tuning::kAabbReach_m);
        if (outdated(stores.fat_boxes[shape], reach)) set(shape, grown(box, record.margin_m));
        slack = std::min(slack, clearance(stores.fat_boxes[shape], reach));
    }
    stores.bodies.rows_of(body).box_slack[stores.bodies.slots[body].row] = slack;
}

// Whether the centre of a shape is outside of the box which that has so far.
bool has_lost_its_boxes(const Stores& stores, int body) {
    const Transform xf = stores.bodies.transform(body);
    for (int s = stores.bodies.slots[body].first_shape; s != kNone; s = stores.shapes[s].next_of_body) {
        const Position at = transform_point(xf, stores.shapes[s].convex().centroid);
        if (!contains(stores.fat_boxes[s], make_aabb(at, {}, {}))) return true;
    }
    return false;
}

bool has_left(const Aabb& fat, const Aabb& reach) {
    return !contains(fat, reach);
}

}  // namespace

void set_fat_box(Stores& stores, int shape, const Aabb& box) {
    const int body = stores.shapes[shape].body;
    stores.fat_boxes[shape] = box;
    tell_fat_box(stores, shape);
    stores.bodies.rows_of(body).box_slack[stores.bodies.slots[body].row] = 0;
}

void tell_fat_box(Stores& stores, int shape) {
    stores.broad.move(shape, stores.fat_boxes[shape]);
    note_moved_boxes(stores, stores.shapes[shape].body);
}

void tell_fat_boxes(Stores& stores, StepScratch& scratch, float way_s, TaskPool& tasks) {
    const ChunkedList<int>& shapes = scratch.untold_boxes;
    const std::size_t count = shapes.size();
    if (count == 0) return;
    const auto way_of = [&](int body) {
        const Place& place = stores.bodies.places[body];
        if (way_s == 0 || (place.flags & place_flag::kHasWay) == 0) return Vec2{};
        return way_s * scratch.advances[place.row].velocity_m_s;
    };
    // Where many moved it is less work to go over all nodes of the tree.
    if (8 * count < static_cast<std::size_t>(stores.broad.tree(Layer::Awake).size())) {
        shapes.for_each([&](int shape) {
            tell_fat_box(stores, shape);
            stores.broad.set_way(shape, way_of(stores.shapes[shape].body));
        });
        return;
    }
    // Shapes of a body stand in one part.
    constexpr int kPartsPerChunk = 1;
    if (!scratch.shifted_boxes) scratch.shifted_boxes = std::make_unique<ShiftedBoxes>();
    ShiftedBoxes& shifted = *scratch.shifted_boxes;
    shifted.first_moves.start(shapes.parts(), kPartsPerChunk, tasks);
    shifted.bodies.start(shapes.parts(), kPartsPerChunk, tasks);
    if (way_s > 0) stores.broad.make_room_for_ways();
    std::atomic<int> more_ways = 0;
    tasks.parallel_for(shapes.parts(), kPartsPerChunk, [&](const Chunk& chunk) {
        ChunkedList<int>::Appender first_moves(shifted.first_moves, chunk);
        ChunkedList<int>::Appender bodies(shifted.bodies, chunk);
        int more = 0;
        const auto ask = [&](int shape) { stores.broad.ask_for_shift(shape); };
        const auto shift = [&](int shape) {
            const int body = stores.shapes[shape].body;
            const BroadPhase::Shifted s = stores.broad.shift(shape, stores.fat_boxes[shape], way_of(body));
            if (s.is_first) first_moves.items().push_back(shape);
            more += s.more_ways;
            if (mark_moved_boxes(stores, body)) bodies.items().push_back(body);
        };
        for (int p = chunk.begin; p < chunk.end; ++p)
            visit_asking_ahead(shapes.part(p), kRecordsAhead, ask, shift);
        more_ways.fetch_add(more, std::memory_order_relaxed);
    });
    shifted.bodies.for_each([&](int body) { stores.boxes_moved.push_back(body); });
    stores.broad.end_shifts(shifted.first_moves, more_ways);
}

float clearance(const Aabb& outer, const Aabb& inner) {
    const Vec2 low = inner.lower - outer.lower;
    const Vec2 high = outer.upper - inner.upper;
    return std::min(std::min(low.x, low.y), std::min(high.x, high.y));
}

void update_boxes(Stores& stores, int body) {
    follow(stores, body, has_left, [&](int shape, const Aabb& box) { set_fat_box(stores, shape, box); });
}

void renew_boxes(Stores& stores, int body, std::vector<int>& untold) {
    const auto always = [](const Aabb&, const Aabb&) { return true; };
    follow(stores, body, always, [&](int shape, const Aabb& box) {
        stores.fat_boxes[shape] = box;
        untold.push_back(shape);
    });
}

void halt_lost_bodies(const BodyStore& bodies, StepScratch& scratch, std::vector<BodyId>& quarantined,
                      TaskPool& tasks) {
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    Motions& motions = scratch.motions;
    const auto is_lost = [&](int row) {
        return !is_finite(motions, row + 1) || leaves_world(bodies, motions, row + 1);
    };
    std::atomic<bool> some_are_lost = false;
    tasks.parallel_for(awake.size(), kRowsPerChunk, [&](const Chunk& chunk) {
        bool some_here = false;
        for (int row = chunk.begin; row < chunk.end; ++row) some_here |= is_lost(row);
        if (some_here) some_are_lost.store(true, std::memory_order_relaxed);
    });
    if (!some_are_lost) return;
    for (int row = 0; row < awake.size(); ++row) {
        if (!is_lost(row)) continue;
        halt(motions, row + 1);
        quarantined.push_back(bodies.slots.id(awake.body[row]));
    }
}

void forget_halted(Stores& stores, std::span<const BodyId> halted) {
    for (const BodyId id : halted) {
        const BodyRecord& record = stores.bodies.slots[stores.bodies.slots.find(id)];
        for_each_edge(stores.contacts.slots, record.first_contact,
                      [&](int contact, int) { forget_impulses(stores.contacts, contact); });
        for_each_edge(stores.joints.slots, record.first_joint,
                      [&](int joint, int) { forget_memory(stores, joint); });
    }
}

void finalize_bodies(Stores& stores, StepScratch& scratch, float dt_s, bool sleep_enabled, TaskPool& tasks) {
    BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    scratch.untold_boxes.start(awake.size(), kRowsPerChunk, tasks);
    scratch.fast_found.start(awake.size(), kRowsPerChunk, tasks);
    tasks.parallel_for(awake.size(), kRowsPerChunk, [&](const Chunk& chunk) {
        ChunkedList<int>::Appender untold(scratch.untold_boxes, chunk);
        ChunkedList<int>::Appender fast(scratch.fast_found, chunk);
        BoxCover boxes(stores, untold.items());
        for (int row = chunk.begin; row < chunk.end; row += kLanes) {
            const BodyLanes lanes = body_lanes(stores.bodies, row, chunk.end);
            const PlaceOutcome outcome =
                take_places(stores.bodies, lanes, scratch.motions, scratch.advances, dt_s, sleep_enabled);
            for (unsigned left = outcome.rest_by_rule; left != 0; left &= left - 1) {
                const int at = row + std::countr_zero(left);
                awake.rest_time[at] = rest_time_by_rule(stores.bodies, scratch.motions, at, dt_s);
            }
            for (unsigned left = outcome.hurled; left != 0; left &= left - 1) {
                const int lane = std::countr_zero(left);
                lanes.places[lane]->flags |= place_flag::kFast;
                fast.items().push_back(awake.body[row + lane]);
            }
            for (unsigned left = outcome.box_left; left != 0; left &= left - 1) {
                const int lane = std::countr_zero(left);
                std::uint32_t& flags = lanes.places[lane]->flags;
                const int body = awake.body[row + lane];
                const bool keeps_near = -awake.box_slack[row + lane] <= scratch.stray_m;
                if ((flags & place_flag::kHasWay) != 0 && !keeps_near) flags |= place_flag::kStrayed;
                if ((flags & place_flag::kFast) != 0 && has_lost_its_boxes(stores, body))
                    flags |= place_flag::kLost;
                boxes.add(body);
            }
        }
        boxes.finish();
    });
    tell_fat_boxes(stores, scratch, 0, tasks);
    scratch.fast_found.for_each([&](int body) { scratch.fast.push_back(body); });
}

}  // namespace cairn::physics
