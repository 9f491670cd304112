// A floor and two walls made of static boxes one metre apart that overlap a little, as level editors leave
// them.
#pragma once

#include "scene.h"

namespace cairn::bench {

/// The floor runs from -half_width_m to half_width_m at y = 0, the walls up to wall_height_m. The result is
/// their body.
inline BodyRef add_trough(Engine& engine, int half_width_m, int wall_height_m) {
    const BodyRef ground = engine.add_body({.type = physics::BodyType::Static});
    const auto add_box = [&](int x, int y, float half_width, float half_height) {
        const physics::Vec2 center{static_cast<float>(x), static_cast<float>(y)};
        engine.add_shape(ground, physics::Box{half_width, half_height, center}, {});
    };
    for (int x = -half_width_m; x <= half_width_m; ++x) add_box(x, 0, 0.55f, 0.5f);
    for (const int x : {-half_width_m, half_width_m}) {
        for (int y = 1; y <= wall_height_m; ++y) add_box(x, y, 0.5f, 0.55f);
    }
    return ground;
}

}  // namespace cairn::bench
