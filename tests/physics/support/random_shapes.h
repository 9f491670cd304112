// Random shapes of every kind, of the sizes that games have: 10 cm to 2 m.
#pragma once

#include <array>

#include "collide/convex.h"
#include "physics/support/random.h"

namespace cairn::physics::test {

enum class Form { Circle, Capsule, Segment, Box, RoundedBox, Polygon, RoundedPolygon };

/// The forms that have an inside.
inline constexpr std::array kForms{Form::Circle,     Form::Capsule, Form::Box,
                                   Form::RoundedBox, Form::Polygon, Form::RoundedPolygon};

inline Convex random_polygon(Random& random, float radius) {
    for (;;) {
        std::array<Vec2, kMaxPolygonVertices> points;
        const int count = 3 + random.below(kMaxPolygonVertices - 2);
        for (int i = 0; i < count; ++i) points[i] = random.vector(-1, 1);
        const Result<Convex> convex =
            make_convex(Polygon{.points_m = std::span(points).first(count), .radius_m = radius});
        if (convex) return *convex;
    }
}

inline Convex random_convex(Random& random, Form form) {
    switch (form) {
        case Form::Circle:
            return make_convex(Circle{random.vector(-0.3, 0.3), random.real_f(0.05, 1)}).value();
        case Form::Capsule: {
            const Vec2 a = random.vector(-1, 0);
            return make_convex(Capsule{a, a + random.vector(0.05, 1), random.real_f(0.05, 0.5)}).value();
        }
        case Form::Segment: {
            const Vec2 a = random.vector(-1, 0);
            return make_convex(Segment{a, a + random.vector(0.05, 1)}).value();
        }
        case Form::Box:
        case Form::RoundedBox: {
            const Vec2 half = random.vector(0.05, 1);
            const float angle = random.real_f(-4, 4);
            const float radius = form == Form::RoundedBox ? random.real_f(0.02, 0.3) : 0;
            return make_convex(Box{half.x, half.y, random.vector(-0.3, 0.3), angle, radius}).value();
        }
        case Form::Polygon:
            return random_polygon(random, 0);
        case Form::RoundedPolygon:
            return random_polygon(random, random.real_f(0.02, 0.3));
    }
    return {};
}

/// Of any form that has an inside.
inline Convex random_solid(Random& random) {
    return random_convex(random,
                         kForms[static_cast<std::size_t>(random.below(static_cast<int>(kForms.size())))]);
}

}  // namespace cairn::physics::test
