// 3,000 bodies of two triangles each fall into a trough.
#include <array>

#include "scene.h"
#include "trough.h"

namespace cairn::bench {

using physics::Polygon;
using physics::Segment;
using physics::ShapeDef;
using physics::Vec2;

Scene compounds() {
    return {.name = "compounds",
            .summary = "3,000 bodies of two triangles each fall into a trough",
            .steps = 500,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                const BodyRef ground = add_trough(engine, 40, 100);
                engine.add_shape(ground, Segment{{-800, -80}, {800, -80}}, {});
                const std::array left{Vec2{-1, 0}, Vec2{0.5f, 1}, Vec2{0, 2}};
                const std::array right{Vec2{1, 0}, Vec2{-0.5f, 1}, Vec2{0, 2}};
                const ShapeDef def{.material = {.friction = 0.5f}};
                double shift = 0.25;
                for (int column = 0; column < 20; ++column) {
                    for (int row = 0; row < 150; ++row) {
                        const BodyRef body =
                            engine.add_body({.position_m = {2.0 * column - 19 + shift, 2.25 * row + 5.575}});
                        engine.add_shape(body, Polygon{.points_m = left}, def);
                        engine.add_shape(body, Polygon{.points_m = right}, def);
                        shift = -shift;
                    }
                }
                return {};
            }};
}

}  // namespace cairn::bench
