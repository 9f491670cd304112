// What Lua calls the kinds of things of the physics.
#pragma once

#include <string_view>

#include <cairn/physics/body.h>
#include <cairn/physics/shape.h>

namespace cairn::scripting {

constexpr std::string_view name_of(physics::BodyType type) {
    switch (type) {
        case physics::BodyType::Static:
            return "static";
        case physics::BodyType::Kinematic:
            return "kinematic";
        case physics::BodyType::Dynamic:
            return "dynamic";
    }
    return "";
}

constexpr std::string_view name_of(physics::ShapeKind kind) {
    switch (kind) {
        case physics::ShapeKind::Circle:
            return "circle";
        case physics::ShapeKind::Capsule:
            return "capsule";
        case physics::ShapeKind::Polygon:
            return "polygon";
        case physics::ShapeKind::Segment:
            return "segment";
        case physics::ShapeKind::ChainSegment:
            return "chain_segment";
    }
    return "";
}

}  // namespace cairn::scripting
