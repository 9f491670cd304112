// Many bodies at once: all of a call are checked before the first is made or destroyed.
#include <algorithm>
#include <utility>

#include <cairn/physics/world.h>

#include "world/bodies.h"
#include "world/validation.h"

namespace cairn::physics {
namespace {

std::string place(const char* list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

using Named = std::pair<int, std::size_t>;  // slot, and where the list names it

// Of two places that name the same body, the later that comes first.
check::Fault find_named_twice(std::vector<Named> named) {
    std::sort(named.begin(), named.end());
    check::Fault fault;
    std::size_t earliest = named.size();
    for (std::size_t i = 1; i < named.size(); ++i) {
        if (named[i].first != named[i - 1].first || named[i].second >= earliest) continue;
        earliest = named[i].second;
        fault = Error{place("bodies", earliest) + " is the same body as " +
                      place("bodies", named[i - 1].second) + ", but each may be named once"};
    }
    return fault;
}

}  // namespace

Result<void> World::create_bodies(std::span<const BodyDef> defs, std::span<BodyId> ids) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    if (defs.size() != ids.size()) {
        return Error{"create_bodies.ids has " + std::to_string(ids.size()) +
                     " places, but must have one for each of the " + std::to_string(defs.size()) +
                     " definitions"};
    }
    for (std::size_t i = 0; i < defs.size(); ++i) {
        if (auto fault = validate(defs[i])) return Error{place("bodies", i) + ": " + fault->message};
    }
    Stores& stores = state_->stores;
    if (defs.size() > stores.bodies.slots.room()) {
        return Error{"the world has room for " + std::to_string(stores.bodies.slots.room()) +
                     " bodies more, but not for " + std::to_string(defs.size())};
    }
    for (std::size_t i = 0; i < defs.size(); ++i) {
        ids[i] = stores.bodies.slots.id(physics::create_body(stores, defs[i]));
    }
    return {};
}

Result<void> World::destroy_bodies(std::span<const BodyId> ids) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const auto& slots = state_->stores.bodies.slots;
    std::vector<Named> named;
    named.reserve(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const Result<int> body = find_slot(slots, ids[i], "body", slots.world_tag());
        if (!body) return Error{place("bodies", i) + ": " + body.error().message};
        named.emplace_back(*body, i);
    }
    if (auto fault = find_named_twice(named)) return *fault;
    for (const auto& [body, index] : named) physics::destroy_body(*state_, body);
    return {};
}

}  // namespace cairn::physics
