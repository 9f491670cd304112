// Affine maps and vector lengths. Invariant: results for finite input that does not overflow are finite.
#include <cmath>

#include <cairn/engine/geometry.h>

namespace cairn::engine {

float length(Vec2 v) {
    return std::sqrt(dot(v, v));
}

Affine2 Affine2::rotation(float angle_rad) {
    const float c = std::cos(angle_rad);
    const float s = std::sin(angle_rad);
    return {c, s, -s, c, 0, 0};
}

float Affine2::mean_scale() const {
    return std::sqrt(std::fabs(determinant()));
}

Affine2 Affine2::inverse() const {
    const float det = determinant();
    if (det == 0) return {};
    const float r = 1 / det;
    return {d * r, -b * r, -c * r, a * r, (c * ty - d * tx) * r, (b * tx - a * ty) * r};
}

Affine2 operator*(const Affine2& m, const Affine2& n) {
    const Vec2 x = m.apply_vector({n.a, n.b});
    const Vec2 y = m.apply_vector({n.c, n.d});
    const Vec2 t = m.apply({n.tx, n.ty});
    return {x.x, x.y, y.x, y.y, t.x, t.y};
}

}  // namespace cairn::engine
