// What shapes are made of.
#pragma once

#include <map>
#include <string>

#include <cairn/physics/shape.h>

namespace cairn::scripting {

struct Matter {
    float density_kg_m2 = 0;
    physics::Material material = {};
};

/// Those to which a game gave names.
using Materials = std::map<std::string, Matter, std::less<>>;

}  // namespace cairn::scripting
