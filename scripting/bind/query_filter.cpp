// Reading filters, and asking the script's function.
#include "bind/query_filter.h"

namespace cairn::scripting {
namespace {

constexpr Field kMask = integer_field("mask", -1, "-1", "bit set: the categories that are met");
constexpr Field kCategories =
    integer_field("categories", -1, "-1", "bit set: only what would collide with one of these is met");
constexpr Field kAccepts = optional_field("accepts", FieldType::Function,
                                          "gets a body and a shape, says true or false: whether it is met");
constexpr Field kIgnored = optional_field("ignored", FieldType::Body, "is not met");
constexpr const Field* kSightOwn[] = {&kMask, &kCategories, &kAccepts, &kIgnored};

}  // namespace

const FieldSet kSightFields{kSightOwn};

FilterArgument Argument<FilterArgument>::get(lua_State* L, int index) {
    const int type = lua_type(L, index);
    if (type == LUA_TNUMBER) Argument<std::int64_t>::get(L, index);
    if (type != LUA_TNUMBER && type != LUA_TTABLE && type != LUA_TFUNCTION)
        argument_error(L, index, "a bit set of categories, a function, or a table");
    return {index};
}

Sight::Sight(lua_State* L, WorldRef world, const Filter& filter, const Ignored& ignored)
    : L_(L), world_(world) {
    if (filter && lua_isfunction(L, filter->index)) function_ = filter->index;
    if (filter && is_integral(L, filter->index))
        filter_.mask = static_cast<std::uint64_t>(lua_tointeger(L, filter->index));
    if (filter && lua_istable(L, filter->index)) read(FieldReader(L, filter->index, kSightFields));
    if (ignored) filter_.ignored_body = ignored->object.id;
}

Sight::Sight(lua_State* L, WorldRef world, const FieldReader& reader) : L_(L), world_(world) {
    read(reader);
}

void Sight::read(const FieldReader& reader) {
    filter_.mask = static_cast<std::uint64_t>(reader.integer(kMask));
    filter_.categories = static_cast<std::uint64_t>(reader.integer(kCategories));
    if (reader.push(kIgnored)) {
        const auto body = living_body_at(L_, -1);
        if (!body) reader.fail(kIgnored, "must be a body that was not destroyed");
        filter_.ignored_body = body->id();
        lua_pop(L_, 1);
    }
    if (reader.push(kAccepts)) function_ = lua_gettop(L_);
}

std::vector<std::uint64_t> Sight::accepted(std::vector<physics::ShapeId> met) const {
    // By slot: the order in which the script is asked must not depend on how the tree of boxes has grown.
    const auto slot_first = [](physics::ShapeId a, physics::ShapeId b) { return a.index1 < b.index1; };
    std::sort(met.begin(), met.end(), slot_first);
    met.erase(std::unique(met.begin(), met.end()), met.end());
    std::vector<std::uint64_t> accepted;
    for (const physics::ShapeId shape : met)
        if (accepts(shape)) accepted.push_back(shape.bits());
    std::sort(accepted.begin(), accepted.end());
    return accepted;
}

bool Sight::accepts(physics::ShapeId shape) const {
    const auto asked = world_.world.shape(shape);
    if (!asked) return false;  // the function has destroyed it
    lua_pushvalue(L_, function_);
    push_body(L_, world_.index, asked->body());
    push_shape(L_, world_.index, world_.object, shape);
    lua_call(L_, 2, 1);
    if (!lua_isboolean(L_, -1))
        call_error(L_, "the filter returned " + describe_value(L_, -1) + "; expected true or false");
    const bool answer = lua_toboolean(L_, -1) != 0;
    lua_pop(L_, 1);
    if (!world_.object.world) call_error(L_, "the filter has destroyed the world");
    return answer;
}

}  // namespace cairn::scripting
