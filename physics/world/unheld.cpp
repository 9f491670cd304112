// How loads are followed.
#include "world/unheld.h"

#include <algorithm>
#include <vector>

#include "collide/manifold.h"
#include "world/contact_lists.h"
#include "world/edge_list.h"

namespace cairn::physics {
namespace {

// m/s, by what is remembered for a substep. Where less is gone the solver evens it out, and stacks of a few
// bodies keep what they know; where more is, the load is followed to its end.
constexpr float kLeastLoss_m_s = 0.1f;
constexpr float kLeastThrow_m_s = 0.02f;

// Of the sum: what presses against it by less does not hold.
constexpr float kLeastHold = 0.05f;

struct Press {
    int contact;
    int other;
    Vec2 impulse_ns;  // on the body
};

float pressing(const ContactMemory& memory) {
    return std::max(memory.impulse[0], 0.0f) + std::max(memory.impulse[1], 0.0f);
}

// What a contact would start the next step with, along its normal.
Vec2 remembered(const Stores& stores, int contact, bool is_b) {
    const ContactRecord& c = stores.contacts.slots[contact];
    const float impulse_ns = pressing(memory_of(stores.contacts, contact));
    if (impulse_ns == 0) return {};
    const Transform a = stores.bodies.transform(c.body_a);
    const Transform b = stores.bodies.transform(c.body_b);
    const RelativePose b_in_a{inverse_rotate(a.q, b.p - a.p), inverse(a.q) * b.q};
    const Manifold manifold = collide(stores.shapes[c.shape_a].convex(), stores.shapes[c.shape_b].convex(),
                                      b_in_a, tuning::kSpeculativeDistance_m);
    const Vec2 normal = rotate(a.q, manifold.normal);
    return is_b ? impulse_ns * normal : -impulse_ns * normal;
}

// Those that throw the body, where nothing holds it.
void find_throwing(const Stores& stores, int body, std::vector<Press>& presses) {
    presses.clear();
    const BodyRecord& record = stores.bodies.slots[body];
    if (record.inverse_mass == 0 || record.first_joint != kNone) return;
    Vec2 sum;
    for_each_edge(stores.contacts.slots, record.first_contact, [&](int contact, int side) {
        const ContactRecord& c = stores.contacts.slots[contact];
        if (!c.has_points) return;
        const Vec2 impulse_ns = remembered(stores, contact, side == 1);
        if (impulse_ns == Vec2{}) return;
        presses.push_back({contact, side == 1 ? c.body_a : c.body_b, impulse_ns});
        sum += impulse_ns;
    });
    const float whole = length(sum);
    const auto along = [&](const Press& press) { return dot(press.impulse_ns, sum); };
    const bool is_thrown = whole * record.inverse_mass > kLeastThrow_m_s;
    const auto holds = [&](const Press& press) { return along(press) < -kLeastHold * whole * whole; };
    if (!is_thrown || std::ranges::any_of(presses, holds)) presses.clear();
    std::erase_if(presses, [&](const Press& press) { return !(along(press) > 0); });
}

}  // namespace

void note_unheld(Stores& stores, int contact) {
    const ContactRecord& c = stores.contacts.slots[contact];
    if (!c.has_points) return;
    const float impulse_ns = pressing(memory_of(stores.contacts, contact));
    for (const int body : {c.body_a, c.body_b}) {
        if (impulse_ns * stores.bodies.slots[body].inverse_mass > kLeastLoss_m_s)
            stores.contacts.unheld.push_back(body);
    }
}

void forget_unheld(Stores& stores) {
    std::vector<int>& bodies = stores.contacts.unheld;
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    std::vector<Press> presses;
    while (!bodies.empty()) {
        const int next = bodies.back();
        bodies.pop_back();
        if (!stores.bodies.slots.alive(next)) continue;
        find_throwing(stores, next, presses);
        for (const Press& press : presses) {
            forget_impulses(stores.contacts, press.contact);
            bodies.push_back(press.other);
        }
    }
}

}  // namespace cairn::physics
