// Which shapes a query from Lua sees: the argument `filter`, and the same as fields of a table. Invariant: a
// function of the script runs between the queries of the physics and never within one, so it may do anything.
#pragma once

#include <algorithm>
#include <compare>
#include <lua.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "bind/fields.h"
#include "bind/function.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

/// An integer (the bit set of categories that are seen), a function, or a table with kSightFields.
struct FilterArgument {
    int index;
};
template <>
struct Argument<FilterArgument> {
    static constexpr std::string_view kType = "integer|function|table";
    static FilterArgument get(lua_State* L, int index);
};
using Filter = std::optional<FilterArgument>;

/// A body that a query does not see.
using Ignored = std::optional<BodyRef>;

/// `mask`, `categories` and `accepts`; what includes it has `ignored` too.
extern const FieldSet kSightFields;

/// What a query sees, without the script's function; whether there is one, and its answers.
class Sight {
  public:
    /// Of the arguments of a query. Pushes the function, where it stays.
    Sight(lua_State* L, WorldRef world, const Filter& filter, const Ignored& ignored);
    /// Of a table whose fields include kSightFields.
    Sight(lua_State* L, WorldRef world, const FieldReader& reader);

    [[nodiscard]] const physics::QueryFilter& filter() const { return filter_; }
    [[nodiscard]] bool asks() const { return function_ != 0; }
    /// Those that the script's function accepts, of shapes in any order, repeated or not; sorted.
    [[nodiscard]] std::vector<std::uint64_t> accepted(std::vector<physics::ShapeId> met) const;

  private:
    void read(const FieldReader& reader);
    [[nodiscard]] bool accepts(physics::ShapeId shape) const;

    lua_State* L_;
    WorldRef world_;
    physics::QueryFilter filter_{};
    int function_ = 0;  ///< where it stands on the stack; 0: there is none
};

/// The Result of `query(QueryFilter)`. With a function it is asked twice: once to learn which shapes it would
/// look at, while it sees none of them, and again with those that the function accepts.
template <class Query>
auto ask(const Sight& sight, Query&& query) {
    physics::QueryFilter filter = sight.filter();
    if (!sight.asks()) return query(filter);
    std::vector<physics::ShapeId> met;
    const auto note = [&met](physics::ShapeId shape, physics::BodyId) {
        met.push_back(shape);
        return false;
    };
    filter.accepts = note;
    if (auto refused = query(filter); !refused) return refused;
    const std::vector<std::uint64_t> accepted = sight.accepted(std::move(met));
    const auto is_accepted = [&accepted](physics::ShapeId shape, physics::BodyId) {
        return std::binary_search(accepted.begin(), accepted.end(), shape.bits());
    };
    filter.accepts = is_accepted;
    return query(filter);
}

}  // namespace cairn::scripting
