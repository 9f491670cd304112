// The plain 2D values of drawing and input: vectors, sizes, rectangles, colors and affine maps.
// Invariant: no unit is implied; a function says whether it speaks of world metres or of logical pixels.
#pragma once

namespace cairn::engine {

struct Vec2 {
    float x = 0;
    float y = 0;

    friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
    friend Vec2 operator*(Vec2 a, float s) { return {a.x * s, a.y * s}; }
    friend Vec2 operator*(float s, Vec2 a) { return {a.x * s, a.y * s}; }
    friend bool operator==(Vec2, Vec2) = default;
};

inline float dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// The z component of the 3D cross product: twice the signed area of the triangle 0, a, b.
inline float cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
float length(Vec2 v);

/// A size or position in whole pixels.
struct Size {
    int width = 0;
    int height = 0;

    friend bool operator==(Size, Size) = default;
};

struct Rect {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;

    friend bool operator==(const Rect&, const Rect&) = default;
};

/// Components from 0 to 1, alpha not premultiplied.
struct Color {
    float r = 1;
    float g = 1;
    float b = 1;
    float a = 1;

    friend bool operator==(const Color&, const Color&) = default;
};

/// p -> (a p.x + c p.y + tx, b p.x + d p.y + ty): the columns are where the x and the y axis go.
struct Affine2 {
    float a = 1;
    float b = 0;
    float c = 0;
    float d = 1;
    float tx = 0;
    float ty = 0;

    static Affine2 translation(Vec2 offset) { return {1, 0, 0, 1, offset.x, offset.y}; }
    static Affine2 scaling(Vec2 factors) { return {factors.x, 0, 0, factors.y, 0, 0}; }
    static Affine2 rotation(float angle_rad);

    Vec2 apply(Vec2 p) const { return {a * p.x + c * p.y + tx, b * p.x + d * p.y + ty}; }
    Vec2 apply_vector(Vec2 v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
    float determinant() const { return a * d - b * c; }
    /// The length scale of the map: the square root of how much it multiplies areas.
    float mean_scale() const;
    /// The inverse of a map whose determinant is 0 does not exist: the identity is returned.
    Affine2 inverse() const;

    /// (m * n) applies n first.
    friend Affine2 operator*(const Affine2& m, const Affine2& n);
    friend bool operator==(const Affine2&, const Affine2&) = default;
};

}  // namespace cairn::engine
