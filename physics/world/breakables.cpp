// Who breaks, and what goes on through the pieces. The solver knows nothing of breaking: it has stopped what
// hit the body when the body turns out to be too weak. A body that breaks at an impulse S cannot have pressed
// back with more, so the rest of the impulse is taken back from both, but no more of it than brings back the
// speed at which they met: what is squeezed between others would be flung out otherwise. As the energy of the
// two is a convex function of the impulse, it ends up no greater than before or after the blow.
#include "world/breakables.h"

#include <algorithm>

#include "base/split_mix.h"
#include "world/contact_lists.h"
#include "world/fracture.h"
#include "world/sleep.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

void update_watch(Stores& stores, int body) {
    for_each_edge(stores.contacts.slots, stores.bodies.slots[body].first_contact, [&](int contact, int) {
        ContactRecord& c = stores.contacts.slots[contact];
        const bool is_watched = is_breakable(stores, c.body_a) || is_breakable(stores, c.body_b);
        if (special::has(c, special::kWatched) == is_watched) return;
        special::set(c, special::kWatched, is_watched);
        relist_contact(stores, contact);
    });
}

// What the body withstands; more than anything if it is not breakable.
float strength_of(const Stores& stores, int body) {
    const int place = stores.bodies.slots[body].breakable;
    return place == kNone ? std::numeric_limits<float>::infinity() : stores.breakables[place].def.strength_ns;
}

BodyBreak break_event(const Stores& stores, const ContactRecord& c, const ContactConstraint& constraint,
                      const Motion& a, float impulse) {
    // The resultant of the points' impulses, which are parallel, acts here.
    Vec2 arm;
    float closing = 0;
    for (int i = 0; i < constraint.count; ++i) {
        const ContactPointConstraint& p = constraint.points[i];
        const float share = p.total_normal_impulse / impulse;
        arm += share * p.r_a;
        closing += share * p.closing_velocity;
    }
    BodyBreak event;
    event.body = stores.bodies.slots.id(c.body_a);
    event.other = stores.bodies.slots.id(c.body_b);
    event.point_m = stores.bodies.places[c.body_a].center + (a.dp + rotate(a.dq, arm));
    event.normal = -constraint.normal;
    event.approach_speed_m_s = -closing;
    event.impulse_ns = impulse;
    return event;
}

// One of the two bodies of a contact, at the point of the contact.
struct End {
    BodyRecord* record = nullptr;
    BodyRows* rows = nullptr;
    Vec2 arm;

    End(Stores& stores, int body, Position point) {
        wake_body(stores, body);
        record = &stores.bodies.slots[body];
        rows = &stores.bodies.rows_of(body);
        arm = point - stores.bodies.places[body].center;
    }
    [[nodiscard]] float velocity_along(Vec2 n) const {
        return dot(rows->velocity[record->row] + cross(rows->spin[record->row], arm), n);
    }
    // What an impulse of 1 along n adds to that.
    [[nodiscard]] float give_along(Vec2 n) const {
        const float turn = cross(arm, n);
        return record->inverse_mass * dot(without_locked(n, locked_axes(*record)), n) +
               record->inverse_inertia * turn * turn;
    }
    void apply(Vec2 impulse) const {
        rows->velocity[record->row] += without_locked(record->inverse_mass * impulse, locked_axes(*record));
        rows->spin[record->row] += record->inverse_inertia * cross(arm, impulse);
    }
};

void give_back(Stores& stores, Overload& overload) {
    const BodyBreak& e = overload.event;
    const int body = stores.bodies.slots.find(e.body);
    const int other = stores.bodies.slots.find(e.other);
    if (overload.excess_ns <= 0 || body == kNone || other == kNone) return;
    // The normal points into the body: they part when it moves along the normal, past the other.
    const End at_other(stores, other, e.point_m);
    const End at_body(stores, body, e.point_m);
    const float parting = at_body.velocity_along(e.normal) - at_other.velocity_along(e.normal);
    const float give = at_body.give_along(e.normal) + at_other.give_along(e.normal);
    if (!(give > 0)) return;
    const float most = (parting + e.approach_speed_m_s) / give;
    const Vec2 impulse = std::clamp(most, 0.0f, overload.excess_ns) * e.normal;
    overload.excess_ns = 0;
    at_body.apply(-impulse);
    at_other.apply(impulse);
}

void give_back(Stores& stores, Events& events, BodyId body) {
    for (Overload& overload : events.overloads) {
        if (overload.event.body == body) give_back(stores, overload);
    }
}

FracturePlan plan_of(const Stores& stores, int body, Position point) {
    if (validate_divisible(stores, body)) return {};
    const BreakableDef& def = stores.breakables[stores.bodies.slots[body].breakable].def;
    const RingPoint impact = local_point(stores.bodies.transform(body), point);
    FracturePlan plan = plan_break(stores, body, impact, def.fracture);
    if (validate_room(stores, plan)) return {};
    return plan;
}

}  // namespace

void make_breakable(Stores& stores, int body, const BreakableDef& def) {
    int& place = stores.bodies.slots[body].breakable;
    if (place != kNone) {
        stores.breakables[place].def = def;
        return;
    }
    place = static_cast<int>(stores.breakables.size());
    stores.breakables.push_back({body, def});
    update_watch(stores, body);
}

void forget_breakable(Stores& stores, int body) {
    int& place = stores.bodies.slots[body].breakable;
    if (place == kNone) return;
    stores.breakables[place] = stores.breakables.back();
    stores.bodies.slots[stores.breakables[place].body].breakable = place;
    stores.breakables.pop_back();
    place = kNone;
    update_watch(stores, body);
}

void inherit_breakable(Stores& stores, int body, const FracturePlan& plan, const std::vector<int>& pieces) {
    if (!is_breakable(stores, body)) return;
    const BreakableDef of_body = stores.breakables[stores.bodies.slots[body].breakable].def;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        BreakableDef def = of_body;
        if (plan[i].is_shattered && --def.generations == 0) continue;
        // Pieces alike must not break alike.
        def.fracture.seed = SplitMix(of_body.fracture.seed + i + 1).bits();
        make_breakable(stores, pieces[i], def);
    }
}

void find_overloads(const Stores& stores, const StepScratch& scratch, Events& events) {
    if (stores.breakables.empty()) return;
    for (const ContactConstraint& constraint : scratch.contacts) {
        const ContactRecord& c = stores.contacts.slots[constraint.contact];
        if (!special::has(c, special::kWatched)) continue;
        float impulse = 0;
        for (int i = 0; i < constraint.count; ++i) impulse += constraint.points[i].total_normal_impulse;
        const float strength_a = strength_of(stores, c.body_a);
        const float strength_b = strength_of(stores, c.body_b);
        // The weaker one gives way, and the contact bears no more than it does.
        const float strength = std::min(strength_a, strength_b);
        if (!(impulse > strength)) continue;
        BodyBreak event = break_event(stores, c, constraint, scratch.motions.get(constraint.a), impulse);
        float excess = impulse - strength;
        if (strength_a == strength) {
            const bool gives_back = stores.breakables[stores.bodies.slots[c.body_a].breakable].def.gives_back;
            events.overloads.push_back({event, gives_back ? excess : 0});
            excess = 0;  // to be given back once only
        }
        if (strength_b == strength) {
            const bool gives_back = stores.breakables[stores.bodies.slots[c.body_b].breakable].def.gives_back;
            std::swap(event.body, event.other);
            event.normal = -event.normal;
            events.overloads.push_back({event, gives_back ? excess : 0});
        }
    }
    for (const Overload& overload : events.overloads) events.breaks.push_back(overload.event);
    const auto by_body = [](const BodyBreak& a, const BodyBreak& b) {
        return a.body != b.body ? a.body.index1 < b.body.index1 : a.impulse_ns > b.impulse_ns;
    };
    std::stable_sort(events.breaks.begin(), events.breaks.end(), by_body);
    const auto last = std::unique(events.breaks.begin(), events.breaks.end(),
                                  [](const BodyBreak& a, const BodyBreak& b) { return a.body == b.body; });
    events.breaks.erase(last, events.breaks.end());
}

void break_overloaded(WorldState& world) {
    Stores& stores = world.stores;
    Events& events = world.events;
    if (events.breaks.empty()) return;
    struct Planned {
        BodyBreak* event;
        int body;
        FracturePlan plan;
        std::size_t first = 0;
    };
    std::vector<Planned> planned;
    for (BodyBreak& event : events.breaks) {
        const int body = stores.bodies.slots.find(event.body);
        if (!stores.breakables[stores.bodies.slots[body].breakable].def.automatic) continue;
        FracturePlan plan = plan_of(stores, body, event.point_m);
        if (!plan.empty()) planned.push_back({&event, body, std::move(plan)});
    }
    // All impulses first: what one body gives back to another that breaks too, its pieces take along.
    for (const Planned& p : planned) give_back(stores, events, p.event->body);
    for (Planned& p : planned) {
        p.first = events.broken_pieces.size();
        if (validate_room(stores, p.plan)) continue;
        for (const int piece : divide_body(world, p.body, p.plan)) {
            events.broken_pieces.push_back(stores.bodies.slots.id(piece));
        }
    }
    for (std::size_t i = 0; i < planned.size(); ++i) {
        const std::size_t end = i + 1 < planned.size() ? planned[i + 1].first : events.broken_pieces.size();
        planned[i].event->pieces =
            std::span(events.broken_pieces).subspan(planned[i].first, end - planned[i].first);
    }
}

std::vector<int> break_as_told(WorldState& world, int body, Position point) {
    const FracturePlan plan = plan_of(world.stores, body, point);
    if (plan.empty()) return {};
    give_back(world.stores, world.events, world.stores.bodies.slots.id(body));
    return divide_body(world, body, plan);
}

check::Fault validate(const BreakableDef& def) {
    return check::first_of({check::positive("breakable.strength_ns", static_cast<double>(def.strength_ns)),
                            check::within("breakable.generations", def.generations, 1, 16),
                            validate(def.fracture)});
}

}  // namespace cairn::physics
