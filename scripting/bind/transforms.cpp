// The methods of Transforms.
#include "bind/transforms.h"

#include "bind/modules.h"

namespace cairn::scripting {

Pushed new_transforms(lua_State* L) {
    new_object<TransformsObject>(L, 1, std::vector<physics::BodyTransform>{});
    return {1};
}

std::int64_t read_transforms(lua_State* L, WorldRef self, TransformsObject* transforms) {
    const std::size_t capacity = transforms->places.capacity();
    self.world.read_transforms(transforms->places);
    charge_growth(L, transforms->places, capacity);
    transforms->angles_rad.clear();
    lua_pushvalue(L, self.index);
    lua_setiuservalue(L, self.index + 1, 1);
    return static_cast<std::int64_t>(transforms->places.size());
}

namespace {

std::int64_t count(TransformsObject* self) {
    return static_cast<std::int64_t>(self->places.size());
}

const physics::BodyTransform& place_at(lua_State* L, const TransformsObject& self, std::int64_t index) {
    if (index < 1 || index > static_cast<std::int64_t>(self.places.size())) {
        call_error(
            L, "index is " + std::to_string(index) + "; expected 1 to " + std::to_string(self.places.size()));
    }
    return self.places[static_cast<std::size_t>(index - 1)];
}

/// All at once, because that takes a fraction of the time.
void find_angles(TransformsObject& self) {
    self.rotations.clear();
    for (const physics::BodyTransform& place : self.places) self.rotations.push_back(place.transform.q);
    self.angles_rad.resize(self.places.size());
    physics::angles_rad(self.rotations, self.angles_rad);
}

std::tuple<double, double, float> transform(lua_State* L, TransformsObject* self, std::int64_t index) {
    const physics::Transform& place = place_at(L, *self, index).transform;
    if (self->angles_rad.empty()) find_angles(*self);
    return {place.p.x, place.p.y, self->angles_rad[static_cast<std::size_t>(index - 1)]};
}
std::tuple<double, double> position(lua_State* L, TransformsObject* self, std::int64_t index) {
    const physics::Transform& place = place_at(L, *self, index).transform;
    return {place.p.x, place.p.y};
}
Pushed body(lua_State* L, TransformsObject* self, std::int64_t index) {
    const physics::BodyId id = place_at(L, *self, index).body;
    lua_getiuservalue(L, 1, 1);
    push_body(L, -1, id);
    return {1};
}

constexpr std::array<std::string_view, 1> kReturnsBody = {"Body?"};

constexpr Function kFunctions[] = {
    function<&count>("count", "", "count", "How many places it holds."),
    function<&position>("position", "index", "x [m], y [m]",
                        "Indices count from 1, in the order of `world:bodies()`."),
    function<&transform>("transform", "index", "x [m], y [m], angle [rad]", ""),
    function_pushing<&body>("body", "index", "body", kReturnsBody, "nil when it was destroyed long since."),
};

}  // namespace

int finalize_transforms(lua_State* L) {
    object_at<TransformsObject>(L, 1)->~TransformsObject();
    return 0;
}

const Module kTransformsMethods = {"Transforms",
                                   "Where the bodies of a world were when `world:read_transforms` was called "
                                   "last. It is filled again and again "
                                   "and makes no garbage.",
                                   kFunctions, true};

}  // namespace cairn::scripting
