// What sensors see: a query of the trees with the sensor's box, then the exact distance.
#include "world/sensors.h"

#include <algorithm>

#include "collide/distance.h"
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
    if (is_behind(b.convex, inverse_transform_point(xf_b, transform_point(xf_a, a.convex.centroid)))) {
        return false;
    }
    return distance_between(a.convex, b.convex, b_in_a).distance <= 0;
}

// A sensor that is fixed in the world does not see the ground on which it stands.
bool may_see(const Stores& stores, int sensor, int shape) {
    const ShapeRecord& own = stores.shapes[sensor];
    const ShapeRecord& other = stores.shapes[shape];
    if (!other.def.seen_by_sensors || own.body == other.body) return false;
    const BodyType type = stores.bodies.slots[own.body].type;
    if (type == BodyType::Static && stores.bodies.slots[other.body].type == BodyType::Static) return false;
    return filters_allow(own.def.filter, other.def.filter);
}

void look(const Stores& stores, int sensor, std::vector<int>& seen) {
    const ShapeRecord& own = stores.shapes[sensor];
    const Aabb box = bounds(own.convex, stores.bodies.transform(own.body));
    seen.clear();
    const auto visit = [&](int shape) {
        if (may_see(stores, sensor, shape) && overlap(stores, sensor, shape)) seen.push_back(shape);
    };
    for (const Layer layer : kLayers) stores.broad.tree(layer).query(box, visit);
    std::sort(seen.begin(), seen.end());
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
    record.convex = convex;
    record.def = def;
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
    stores.shapes.erase(shape);
}

void update_sensors(Stores& stores, Events& events) {
    SensorStore& sensors = stores.sensors;
    if (sensors.all.empty()) return;
    if (stores.bodies.rows(RowSet::Awake).size() == 0 && !sensors.outdated) return;
    sensors.outdated = false;
    for (Sensor& sensor : sensors.all) {
        look(stores, sensor.shape, sensors.seen);
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
