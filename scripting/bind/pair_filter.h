// A script's word on which pairs of shapes collide: world:set_pair_filter.
// Invariant: while the filter runs the world is not to be reached as `WorldObject::world`, so whatever would
// change it fails as with a destroyed world; only what is listed here as looking is let through.
#pragma once

#include <optional>

#include "bind/function.h"
#include "bind/physics_objects.h"
#include "lua/errors.h"

namespace cairn::scripting {

void set_pair_filter(lua_State* L, WorldRef self, std::optional<FunctionArgument> filter);

/// Around a step of a world: where its filter, if it has one, is called and what came of that.
class FilteredStep {
  public:
    FilteredStep(lua_State* L, WorldRef world) : L_(L), world_(world.object), world_index_(world.index) {
        world_.filtered_step = this;
    }
    ~FilteredStep() { world_.filtered_step = nullptr; }
    FilteredStep(const FilteredStep&) = delete;
    FilteredStep& operator=(const FilteredStep&) = delete;

    /// Whether the pair may collide; the answers after an error are yes.
    bool ask(physics::ShapeId a, physics::ShapeId b);
    /// While the filter runs, the world in its step; else null.
    [[nodiscard]] physics::World* looked_at() const { return looked_at_; }
    /// Behind the step.
    void raise_error() const;

  private:
    lua_State* L_;
    WorldObject& world_;
    int world_index_;
    physics::World* looked_at_ = nullptr;
    std::optional<ScriptError> error_{};
};

/// The world, if its filter is being asked and the binding that runs only looks; else null.
physics::World* world_to_look_at(lua_State* L, const WorldObject& object);
/// The same for questions that every binding may ask: also when nothing else is asked, the world itself.
const physics::World* readable_world(const WorldObject& object);

}  // namespace cairn::scripting
