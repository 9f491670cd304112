// What sensors see: a query of the trees with the sensor's box, then the exact distance; and of what could
// have passed through within the step, the way. Boxes of fast bodies still cover their ways at this stage,
// but of those that strayed.
#include "world/sensors.h"

#include <algorithm>
#include <iterator>

#include <cairn/physics/tuning.h>

#include "collide/distance.h"
#include "continuous/sweep.h"
#include "world/fast_bodies.h"
#include "world/filtering.h"

namespace cairn::physics {
namespace {

// A sensor sees a segment of a chain from its front only.
bool overlap(const Stores& stores, int shape_a, int shape_b) {
    const ShapeRecord& a = stores.shapes[shape_a];
    const ShapeRecord& b = stores.shapes[shape_b];
    const Transform xf_a = stores.bodies.transform(a.body);
    const Transform xf_b = stores.bodies.transform(b.body);
    const RelativePose b_in_a{inverse_rotate(xf_a.q, xf_b.p - xf_a.p), inverse(xf_a.q) * xf_b.q};
    if (is_behind(b.convex(), inverse_transform_point(xf_b, transform_point(xf_a, a.convex().centroid)))) {
        return false;
    }
    return distance_between(a.convex(), b.convex(), b_in_a).distance <= 0;
}

// m. What comes this near on its way has touched.
constexpr float kTouching_m = 0.05f * tuning::kLinearSlop_m;

// What the last step did to a body.
struct BodyWay {
    Vec2 moved;
    Rotation before;
    float chord = 0;  // of its turn
};

BodyWay way_of(const Stores& stores, int body) {
    const Rotation now = stores.bodies.places[body].rotation;
    if (!stores.bodies.is_awake(body)) return {{}, now, 0};
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const int row = stores.bodies.slots[body].row;
    const Rotation before = awake.rotation_before[row];
    return {awake.moved[row], before, length(Vec2{now.c - before.c, now.s - before.s})};
}

// As steady motions that take one second.
Sweep make_sweep(const Stores& stores, int shape, const BodyWay& way, Position origin) {
    const int body = stores.shapes[shape].body;
    const Place& place = stores.bodies.places[body];
    return {&stores.shapes[shape].convex(),
            place.center - origin - way.moved,
            way.before,
            stores.bodies.slots[body].mass.center_m,
            way.moved,
            way.chord == 0 ? 0 : (inverse(way.before) * place.rotation).angle_rad()};
}

// How far the turn takes a point of the shape, at most.
float swing(const Stores& stores, int shape, const BodyWay& way) {
    if (way.chord == 0) return 0;
    const ShapeRecord& record = stores.shapes[shape];
    return way.chord * farthest_distance(record.convex(), stores.bodies.slots[record.body].mass.center_m);
}

// Whether a shape that was outside before the step, and is after it, was inside in between. What moved less
// than a part of its own thickness, as seen from the sensor, would have been met at the end of a step.
bool passed(const Stores& stores, int sensor, int shape) {
    const BodyWay own = way_of(stores, stores.shapes[sensor].body);
    const BodyWay other = way_of(stores, stores.shapes[shape].body);
    const float turning = swing(stores, sensor, own) + swing(stores, shape, other);
    const Convex& visitor = stores.shapes[shape].convex();
    if (length(other.moved - own.moved) + turning <= kFastShare * inner_radius(visitor)) return false;
    const Position origin = stores.bodies.places[stores.shapes[sensor].body].center;
    const Sweep a = make_sweep(stores, sensor, own, origin);
    const Sweep b = make_sweep(stores, shape, other, origin);
    const RelativePose start = relative_pose_at(b, a, 0);
    if (is_behind(visitor, start.p + rotate(start.q, a.shape->centroid))) return false;
    return time_of_impact(a, b, 1, kTouching_m).has_value();
}

// A sensor that is fixed in the world does not see the ground on which it stands.
bool may_see(const Stores& stores, int sensor, int shape) {
    const ShapeRecord& own = stores.shapes[sensor];
    const ShapeRecord& other = stores.shapes[shape];
    if (!other.def().seen_by_sensors || own.body == other.body) return false;
    const BodyType type = stores.bodies.slots[own.body].type;
    if (type == BodyType::Static && stores.bodies.slots[other.body].type == BodyType::Static) return false;
    return filters_allow(own.def().filter, other.def().filter);
}

// Of all of the sensor's way.
Aabb box_of_way(const Stores& stores, int sensor) {
    const ShapeRecord& own = stores.shapes[sensor];
    const Transform now = stores.bodies.transform(own.body);
    const Aabb box = bounds(own.convex(), now);
    const BodyWay way = way_of(stores, own.body);
    if (way.moved == Vec2{} && way.chord == 0) return box;
    const Vec2 center = stores.bodies.slots[own.body].mass.center_m;
    const Position before = stores.bodies.places[own.body].center + -way.moved;
    const Aabb start = bounds(own.convex(), {before + -rotate(way.before, center), way.before});
    // What turns is at most this far from the straight way between its ends: less than its chord.
    return grown(merged(start, box), swing(stores, sensor, way));
}

// `strayed`: those of which the boxes no longer cover their ways.
void look(const Stores& stores, int sensor, std::span<const int> strayed, std::vector<int>& seen) {
    const Aabb box = box_of_way(stores, sensor);
    seen.clear();
    const auto visit = [&](int shape) {
        if (!may_see(stores, sensor, shape)) return;
        if (overlap(stores, sensor, shape) || passed(stores, sensor, shape)) seen.push_back(shape);
    };
    for (const Layer layer : kLayers) stores.broad.tree(layer).query(box, visit);
    for (const int body : strayed) {
        for (int s = stores.bodies.slots[body].first_shape; s != kNone; s = stores.shapes[s].next_of_body)
            visit(s);
    }
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
}

// Fast bodies with new boxes since contacts were updated.
void find_strayed(const Stores& stores, std::span<const int> fast, std::vector<int>& strayed) {
    strayed.clear();
    std::copy_if(fast.begin(), fast.end(), std::back_inserter(strayed),
                 [&](int body) { return (stores.bodies.places[body].flags & place_flag::kBoxesMoved) != 0; });
}

template <class Event>
Event make_event(const Stores& stores, const Sensor& sensor, ShapeId visitor, BodyId body) {
    return {stores.shapes.id(sensor.shape), visitor, stores.bodies.slots.id(stores.shapes[sensor.shape].body),
            body};
}

// A slot may hold another shape than before: then one went and one came.
bool comes_before(ShapeId a, ShapeId b) {
    return a.index1 != b.index1 ? a.index1 < b.index1 : a.generation < b.generation;
}

void report_changes(const Stores& stores, const Sensor& before, const Sensor& now, Events& events) {
    std::size_t i = 0;
    std::size_t k = 0;
    while (i < before.inside.size() || k < now.inside.size()) {
        const bool old_left = i < before.inside.size();
        const bool new_left = k < now.inside.size();
        if (old_left && new_left && before.inside[i] == now.inside[k]) {
            ++i;
            ++k;
        } else if (!new_left || (old_left && comes_before(before.inside[i], now.inside[k]))) {
            events.sensor_ends.push_back(
                make_event<SensorEnd>(stores, now, before.inside[i], before.bodies[i]));
            ++i;
        } else {
            events.sensor_begins.push_back(
                make_event<SensorBegin>(stores, now, now.inside[k], now.bodies[k]));
            ++k;
        }
    }
}

}  // namespace

int create_sensor(Stores& stores, int body, const Convex& convex, const ShapeDef& def) {
    ShapeRecord record;
    record.body = body;
    record.take_prototype(stores.prototypes, convex, def);
    record.sensor = static_cast<int>(stores.sensors.all.size());
    const int shape = insert_shape(stores, record, Aabb{});
    stores.sensors.all.push_back({shape, {}, {}});
    int& first = stores.bodies.slots[body].first_sensor;
    stores.shapes[shape].next_of_body = first;
    first = shape;
    stores.sensors.outdated = true;
    return shape;
}

void destroy_sensor(WorldState& world, int shape) {
    Stores& stores = world.stores;
    std::vector<Sensor>& all = stores.sensors.all;
    const int place = stores.shapes[shape].sensor;
    const Sensor& sensor = all[place];
    for (std::size_t i = 0; i < sensor.inside.size(); ++i) {
        world.events.pending_sensor_ends.push_back(
            make_event<SensorEnd>(stores, sensor, sensor.inside[i], sensor.bodies[i]));
    }
    int* link = &stores.bodies.slots[stores.shapes[shape].body].first_sensor;
    while (*link != shape) link = &stores.shapes[*link].next_of_body;
    *link = stores.shapes[shape].next_of_body;
    if (place + 1 < static_cast<int>(all.size())) {
        all[place] = std::move(all.back());
        stores.shapes[all[place].shape].sensor = place;
    }
    all.pop_back();
    erase_shape(stores, shape);
}

void update_sensors(Stores& stores, std::span<const int> fast, Events& events) {
    SensorStore& sensors = stores.sensors;
    if (sensors.all.empty()) return;
    if (stores.bodies.rows(RowSet::Awake).size() == 0 && !sensors.outdated) return;
    sensors.outdated = false;
    find_strayed(stores, fast, sensors.strayed);
    for (Sensor& sensor : sensors.all) {
        look(stores, sensor.shape, sensors.strayed, sensors.seen);
        sensors.before.inside.assign(sensor.inside.begin(), sensor.inside.end());
        sensors.before.bodies.assign(sensor.bodies.begin(), sensor.bodies.end());
        sensor.inside.clear();
        sensor.bodies.clear();
        for (const int shape : sensors.seen) {
            sensor.inside.push_back(stores.shapes.id(shape));
            sensor.bodies.push_back(stores.bodies.slots.id(stores.shapes[shape].body));
        }
        report_changes(stores, sensors.before, sensor, events);
    }
}

}  // namespace cairn::physics
