// Shapes as bytes: those that are made as the shape before them take a byte and their box. Then what refers
// to them: chains, sensors, bodies that break, and the rules for materials.
#include <algorithm>
#include <limits>

#include "state/sections.h"
#include "state/slots.h"
#include "world/fracture_plan.h"

namespace cairn::physics {
namespace {

constexpr std::size_t kMakeBytes = packed_size<ShapeMake>();

bool is_sound(const Convex& convex) {
    const int count = convex.count();
    const auto in = [&](int low, int high) { return count >= low && count <= high; };
    switch (convex.outline.kind) {
        case ShapeKind::Circle:
            return in(1, 1);
        case ShapeKind::Capsule:
        case ShapeKind::Segment:
        case ShapeKind::ChainSegment:
            return in(2, 2);
        case ShapeKind::Polygon:
            return in(3, kMaxPolygonVertices);
    }
    return false;
}

bool is_sound(const ShapeMake& shape) {
    const auto within = [](std::span<const Vec2> points) {
        return std::all_of(points.begin(), points.end(), [](Vec2 p) { return is_within_reach(p); });
    };
    const int kind = shape.def.material.kind;
    return is_sound(shape.convex) && is_consistent(shape.convex) && kind >= 0 && kind < kMaterialKinds &&
           shape.convex.radius() >= 0 && shape.convex.radius() <= kMostExtent_m &&
           within(shape.convex.outline.points_m) && within(shape.convex.normals) &&
           is_within_reach(shape.convex.centroid) && is_within_reach(shape.convex.half_size) &&
           is_finite(shape.def.one_way_normal) && shape.margin_m <= kMostExtent_m && shape.margin_m >= 0;
}

// A sensor has no box, so its own may be any; others are met somewhere, but not by everything.
bool is_sound(const Aabb& box, bool sensor) {
    const float extents = (box.upper.x - box.lower.x) + (box.upper.y - box.lower.y);
    const bool is_somewhere = (box.lower.x <= box.upper.x) & (box.lower.y <= box.upper.y);
    if (is_somewhere & (extents <= std::numeric_limits<float>::max())) return true;
    if (has_nan(std::span<const float>(&box.lower.x, 4))) return false;
    return sensor || (is_somewhere && (is_finite(box.lower) || is_finite(box.upper)));
}

bool is_made_alike(const ShapeRecord& a, const ShapeRecord& b) {
    return a.prototype == b.prototype && a.user_data == b.user_data && a.group == b.group &&
           differing_bits(a.margin_m, b.margin_m) == 0;
}

void save_records(const Stores& stores, Writer& out) {
    const std::size_t count = static_cast<std::size_t>(stores.shapes.size());
    std::byte* at = out.room(count * (1 + kMakeBytes + sizeof(Aabb)));
    const ShapeRecord* last = nullptr;
    for_each_alive(stores.shapes, [&](int shape, const ShapeRecord& record) {
        const bool is_new = last == nullptr || !is_made_alike(*last, record);
        at = put(at, is_new);
        if (is_new) at = put(at, make_of(record));
        at = put(at, stores.fat_boxes[static_cast<std::size_t>(shape)]);
        last = &record;
    });
    out.end(at);
}

// Shapes that something else must name.
struct Expected {
    std::size_t segments = 0;  // of chains
    std::size_t sensors = 0;
};

Expected load_records(Reader& in, Stores& stores) {
    Expected expected;
    stores.fat_boxes.resize(static_cast<std::size_t>(stores.shapes.end_index()));
    constexpr std::size_t kLeast = 1 + sizeof(Aabb);
    // Copied from here and not from the shape before: what was stored just now is slow to read in other
    // pieces.
    ShapeMake make;
    ShapePrototype* prototype = nullptr;
    const std::byte* at = in.rest().data();
    std::size_t left = in.rest().size();
    Reading reading;
    for_each_alive(stores.shapes, [&](int shape, ShapeRecord& record) {
        if (!in.ok()) return;
        const bool is_new = left > 0 && *at != std::byte{0};
        const std::size_t size = kLeast + (is_new ? kMakeBytes : 0);
        if (!in.require(size <= left, "it ends in the middle of the shapes")) return;
        left -= size;
        ++at;
        if (is_new) {
            at = get(at, make, reading);
            if (!in.require(is_sound(make), "a shape has points, a radius or a material that none has"))
                return;
            prototype = stores.prototypes.take(make.convex, make.def);
        } else if (in.require(prototype != nullptr, "the first shape is as one before it")) {
            ++prototype->users;
        } else {
            return;
        }
        record = {.margin_m = make.margin_m, .prototype = prototype};
        record.take_own(make.def);
        Aabb& box = stores.fat_boxes[static_cast<std::size_t>(shape)];
        at = get_unchecked(at, box);
        if (!in.require(is_sound(box, make.def.sensor), "a shape has a box that is nowhere or everywhere"))
            return;
        expected.segments += make.convex.is_chained() ? 1 : 0;
        expected.sensors += make.def.sensor ? 1 : 0;
    });
    if (!in.ok()) return expected;
    in.end(at);
    in.reading.bad |= reading.bad;
    in.settle();
    return expected;
}

void save_chains(const Stores& stores, Writer& out) {
    save_slots(stores.chains, out);
    for_each_alive(stores.chains, [&](int, const ChainRecord& chain) {
        const auto& [body, closed, before_m, after_m, points_m, segments, user_data] = chain;
        out.value(body);
        out.value(closed);
        out.value(before_m);
        out.value(after_m);
        out.list(points_m);
        out.list(segments);
        out.value(user_data);
    });
}

void load_chain(Reader& in, Stores& stores, int index, ChainRecord& chain) {
    auto& [body, closed, before_m, after_m, points_m, segments, user_data] = chain;
    in.value(body);
    in.value(closed);
    in.value(before_m);
    in.value(after_m);
    in.list(points_m);
    in.list(segments);
    in.value(user_data);
    if (!in.settle()) return;
    const std::size_t expected = points_m.size() - (closed ? 0 : 1);
    if (!in.require(points_m.size() >= 2 && segments.size() == expected && names(stores.bodies.slots, body),
                    "a chain is of no body, or has not as many segments as its points make"))
        return;
    for (const int shape : segments) {
        const bool is_segment = names(stores.shapes, shape) && stores.shapes[shape].chain == kNone &&
                                stores.shapes[shape].convex().is_chained();
        if (!in.require(is_segment, "a chain has a segment that is none, or of another chain")) return;
        stores.shapes[shape].chain = index;
    }
}

void load_chains(Reader& in, Stores& stores, std::size_t expected) {
    in.begin("chains");
    load_slots(in, stores.chains);
    in.require_built_in(Feature::Chains, stores.chains.size() > 0);
    std::size_t segments = 0;
    if (!in.ok()) return;
    for_each_alive(stores.chains, [&](int index, ChainRecord& chain) {
        if (in.ok()) load_chain(in, stores, index, chain);
        segments += chain.segments.size();
    });
    in.require(segments == expected, "a segment is of no chain");
}

void save_sensors(const SensorStore& sensors, Writer& out) {
    const auto& [all, outdated, seen, strayed, before] = sensors;  // the last three are of one look
    out.value(outdated);
    out.count(all.size());
    for (const auto& [shape, inside, bodies] : all) {
        out.value(shape);
        out.list(inside);
        out.list(bodies);
    }
}

void load_sensors(Reader& in, Stores& stores, std::size_t expected) {
    in.begin("sensors");
    in.value(stores.sensors.outdated);
    stores.sensors.all.resize(in.count(3 * sizeof(int)));
    in.require_built_in(Feature::Sensors, !stores.sensors.all.empty());
    int place = 0;
    for (auto& [shape, inside, bodies] : stores.sensors.all) {
        in.value(shape);
        in.list(inside);
        in.list(bodies);
        if (!in.ok()) return;
        const bool is_sensor = names(stores.shapes, shape) && stores.shapes[shape].def().sensor &&
                               stores.shapes[shape].sensor == kNone && inside.size() == bodies.size();
        if (!in.require(is_sensor, "a shape is listed as a sensor that is none, or twice")) return;
        stores.shapes[shape].sensor = place++;
    }
    in.require(stores.sensors.all.size() == expected, "a sensor is not listed");
    in.settle();
}

void load_breakables(Reader& in, Stores& stores) {
    in.begin("breakable bodies");
    in.list(stores.breakables);
    in.require_built_in(Feature::Fracture, !stores.breakables.empty());
    if (!in.settle()) return;
    int place = 0;
    for (const auto& [body, def] : stores.breakables) {
        const bool sound = names(stores.bodies.slots, body) && stores.bodies.slots[body].breakable == kNone &&
                           !validate(def);
        if (!in.require(sound, "a breakable body is none, or breaks in a way that none does")) return;
        stores.bodies.slots[body].breakable = place++;
    }
}

}  // namespace

void save_shapes(const Stores& stores, Writer& out) {
    save_slots(stores.shapes, out);
    save_records(stores, out);
    save_chains(stores, out);
    save_sensors(stores.sensors, out);
    out.list(stores.breakables);
    StateAccess::rules(stores.rules.mixing, [&](const auto& rules) { out.list(rules); });
}

void load_shapes(Reader& in, RestoreSpace& to) {
    Stores& stores = to.stores;
    in.begin("shapes");
    load_slots(in, stores.shapes);
    stores.prototypes.clear();
    Expected expected;
    if (in.ok()) expected = load_records(in, stores);
    if (in.ok()) load_chains(in, stores, expected.segments);
    if (in.ok()) load_sensors(in, stores, expected.sensors);
    if (in.ok()) load_breakables(in, stores);
    if (!in.ok()) return;
    in.begin("rules of materials");
    StateAccess::rules(stores.rules.mixing, [&](auto& rules) {
        in.list(rules);
        in.require(rules.size() <= kMaterialKinds * (kMaterialKinds + 1) / 2, "there are too many rules");
    });
    in.settle();
}

}  // namespace cairn::physics
