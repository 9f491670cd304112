// The public cuts and breaks: checks what comes from outside, then plans and divides.
#include <algorithm>

#include <cairn/physics/tuning.h>
#include <cairn/physics/world.h>

#include "world/breakables.h"
#include "world/fracture.h"
#include "world/query_traversal.h"
#include "world/sleep.h"
#include "world/validation.h"

namespace cairn::physics {
namespace {

check::Fault validate_cut(Position from, Position to) {
    if (auto fault = check::first_of({check::placed("cut.from_m", from), check::placed("cut.to_m", to)})) {
        return fault;
    }
    const double way = length(RingPoint{to.x - from.x, to.y - from.y});
    return check::require(way > static_cast<double>(tuning::kLinearSlop_m) && way <= 1e9,
                          "the length of the cut", way, "greater than 0.005 m and at most 1e9 m");
}

// The body's way under the cut, from where it enters the body first to where it leaves it last; nothing when
// the cut does not come into the body.
std::optional<Interval> way_through(const Stores& stores, int body, const CutWay& way) {
    std::optional<Interval> all;
    for_each_solid_shape(stores, body, [&](int shape) {
        const Convex& convex = stores.shapes[shape].convex();
        if (convex.is_line()) return;
        const std::optional<Interval> found = interval_near(ring_of(convex), way.line, kLineReach_m);
        if (!found || found->high < 0 || found->low > way.length_m) return;
        const Interval within{std::max(found->low, 0.0), std::min(found->high, way.length_m)};
        if (!all) all = within;
        all = Interval{std::min(all->low, within.low), std::max(all->high, within.high)};
    });
    return all;
}

std::vector<int> bodies_along(const Stores& stores, Position from, Position to, const QueryFilter& filter) {
    std::vector<int> bodies;
    visit_along_ray(stores, from, to - from, filter, [&](int shape) {
        bodies.push_back(stores.shapes[shape].body);
        return 1.0f;
    });
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return bodies;
}

std::vector<BodyId> ids_of(const Stores& stores, const std::vector<int>& bodies) {
    std::vector<BodyId> ids;
    for (const int body : bodies) ids.push_back(stores.bodies.slots.id(body));
    return ids;
}

// The pieces; none when the body stays as it is.
Result<std::vector<BodyId>> divide(WorldState& world, int body, const FracturePlan& plan) {
    if (plan.empty()) return std::vector<BodyId>{};
    if (auto fault = validate_room(world.stores, plan)) return *fault;
    return ids_of(world.stores, divide_body(world, body, plan));
}

Result<int> find_body(const WorldState& world, BodyId id) {
    const auto& slots = world.stores.bodies.slots;
    return find_slot(slots, id, "body", slots.world_tag());
}

// The slot of a body that could be divided.
Result<int> find_divisible(const WorldState& world, BodyId id) {
    const Result<int> body = find_body(world, id);
    if (!body) return body;
    if (auto fault = validate_divisible(world.stores, *body)) return *fault;
    return body;
}

}  // namespace

Result<std::vector<BodyId>> World::cut_body(BodyId id, Position from_m, Position to_m) {
    if (auto fault = check::first_of({refuse_within_step(*state_), validate_cut(from_m, to_m)}))
        return *fault;
    const Result<int> body = find_divisible(*state_, id);
    if (!body) return body.error();
    const CutWay way = cut_way(state_->stores.bodies.transform(*body), from_m, to_m);
    return divide(*state_, *body, plan_cut(state_->stores, *body, way));
}

Result<std::vector<BodyId>> World::break_body(BodyId id, Position impact_m, const FractureDef& def) {
    if (auto fault = check::first_of(
            {refuse_within_step(*state_), check::placed("impact_m", impact_m), validate(def)})) {
        return *fault;
    }
    const Result<int> body = find_divisible(*state_, id);
    if (!body) return body.error();
    const RingPoint impact = local_point(state_->stores.bodies.transform(*body), impact_m);
    return divide(*state_, *body, plan_break(state_->stores, *body, impact, def));
}

Result<void> World::set_breakable(BodyId id, const BreakableDef& def) {
    if (auto fault = check::first_of({refuse_within_step(*state_), validate(def)})) return *fault;
    const Result<int> body = find_divisible(*state_, id);
    if (!body) return body.error();
    make_breakable(state_->stores, *body, def);
    wake_body(state_->stores, *body);
    return {};
}

Result<void> World::clear_breakable(BodyId id) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const Result<int> body = find_body(*state_, id);
    if (!body) return body.error();
    forget_breakable(state_->stores, *body);
    return {};
}

Result<std::optional<BreakableDef>> World::breakable(BodyId id) const {
    const Result<int> body = find_body(*state_, id);
    if (!body) return body.error();
    const int place = state_->stores.bodies.slots[*body].breakable;
    if (place == kNone) return std::optional<BreakableDef>{};
    return std::optional(state_->stores.breakables[place].def);
}

std::span<const BodyBreak> World::body_breaks() const {
    return state_->events.breaks;
}

Result<std::vector<BodyId>> World::break_body(const BodyBreak& event) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const Result<int> body = find_divisible(*state_, event.body);
    if (!body) return body.error();
    const auto is_told = [&](const BodyBreak& told) { return told.body == event.body; };
    const auto& breaks = state_->events.breaks;
    const auto told = std::find_if(breaks.begin(), breaks.end(), is_told);
    if (told == breaks.end() || !is_breakable(state_->stores, *body)) {
        return Error{"the body is none that World::body_breaks tells about, but must be one"};
    }
    return ids_of(state_->stores, break_as_told(*state_, *body, told->point_m));
}

Result<std::vector<CutHit>> World::cuts_along(Position from_m, Position to_m, QueryFilter filter) const {
    if (auto fault = validate_cut(from_m, to_m)) return *fault;
    const Stores& stores = state_->stores;
    std::vector<std::pair<double, CutHit>> found;
    for (const int body : bodies_along(stores, from_m, to_m, filter)) {
        const CutWay way = cut_way(stores.bodies.transform(body), from_m, to_m);
        const std::optional<Interval> inside = way_through(stores, body, way);
        if (!inside) continue;
        const auto at = [&](double along) {
            const double share = along / way.length_m;
            return Position{from_m.x + share * (to_m.x - from_m.x), from_m.y + share * (to_m.y - from_m.y)};
        };
        CutHit hit{stores.bodies.slots.id(body), at(inside->low), at(inside->high)};
        if (!validate_divisible(stores, body)) {
            hit.pieces = std::max(1, static_cast<int>(plan_cut(stores, body, way).size()));
        }
        found.emplace_back(inside->low, hit);
    }
    // Bodies were in the order of their slots, and stay so where the cut enters them at the same place.
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<CutHit> hits;
    for (const auto& [along, hit] : found) hits.push_back(hit);
    return hits;
}

}  // namespace cairn::physics
