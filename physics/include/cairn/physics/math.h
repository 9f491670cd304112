// Vectors, rotations and transforms of the plane. World positions are double, everything relative to a body
// is float, so that a scene far from the origin behaves as at the origin.
#pragma once

#include <cmath>
#include <span>

namespace cairn::physics {

inline constexpr float kPi = 3.14159265358979323846f;

/// A vector, or a point in a body's own frame. Unit by context (m, m/s, N ...).
struct Vec2 {
    float x = 0;
    float y = 0;

    friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
    constexpr Vec2 operator-() const { return {-x, -y}; }
    constexpr Vec2& operator+=(Vec2 b) { return x += b.x, y += b.y, *this; }
    constexpr Vec2& operator-=(Vec2 b) { return x -= b.x, y -= b.y, *this; }
    constexpr Vec2& operator*=(float s) { return x *= s, y *= s, *this; }
    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator*(float s, Vec2 a) { return {s * a.x, s * a.y}; }
    friend constexpr Vec2 operator*(Vec2 a, float s) { return {s * a.x, s * a.y}; }
};

constexpr float dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
constexpr float cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/// w x r: the velocity of a point at r on a body that turns at w.
constexpr Vec2 cross(float w, Vec2 r) {
    return {-w * r.y, w * r.x};
}
/// A quarter turn anticlockwise, and clockwise.
constexpr Vec2 left_perp(Vec2 a) {
    return {-a.y, a.x};
}
constexpr Vec2 right_perp(Vec2 a) {
    return {a.y, -a.x};
}
constexpr float length_squared(Vec2 a) {
    return dot(a, a);
}
inline float length(Vec2 a) {
    return std::sqrt(dot(a, a));
}
/// The unit vector along a, or (0, 0) when a is too short to have a direction.
inline Vec2 normalized(Vec2 a) {
    const float n = length(a);
    return n > 1e-20f ? Vec2{a.x / n, a.y / n} : Vec2{};
}
inline bool is_finite(float a) {
    return std::isfinite(a);
}
inline bool is_finite(Vec2 a) {
    return std::isfinite(a.x) && std::isfinite(a.y);
}

/// m. Nothing is put or asked for farther than this from the world's origin, along either axis. A double
/// still tells places 0.12 mm apart there; farther out, float could not hold the squares of distances, nor
/// the boxes of the trees the places.
inline constexpr double kFarthest_m = 1e12;

/// A point of the world, m.
struct Position {
    double x = 0;
    double y = 0;

    friend constexpr bool operator==(const Position&, const Position&) = default;
    friend constexpr Position operator+(Position p, Vec2 d) {
        return {p.x + static_cast<double>(d.x), p.y + static_cast<double>(d.y)};
    }
    /// From b to a, rounded to float once: exact enough whenever the two are near each other.
    friend constexpr Vec2 operator-(Position a, Position b) {
        return {static_cast<float>(a.x - b.x), static_cast<float>(a.y - b.y)};
    }
};

inline bool is_finite(Position p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

// Own elementary functions: the C library's differ in the last bit between versions and processors, these do
// not. Source: Cody and Waite 1980 for the reductions; Taylor and Chebyshev sums in double. Errors below
// 1e-12 relative; for angles beyond 1e6 rad, of the order of angle times 1e-16.
namespace deterministic {
double sin(double angle_rad);
double cos(double angle_rad);
double tan(double angle_rad);
double asin(double x);
double acos(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double pow(double base, double exponent);
}  // namespace deterministic

/// A rotation of the plane, as the cosine and sine of its angle.
struct Rotation {
    float c = 1;
    float s = 0;

    friend constexpr bool operator==(const Rotation&, const Rotation&) = default;
    [[nodiscard]] static Rotation from_angle(double angle_rad) {
        return {static_cast<float>(deterministic::cos(angle_rad)),
                static_cast<float>(deterministic::sin(angle_rad))};
    }
    /// The same in float only: errors below 1e-7, several times faster, for |angle_rad| <= 0.5; exact calls
    /// beyond.
    [[nodiscard]] static Rotation from_small_angle(float angle_rad) {
        if (!(std::fabs(angle_rad) <= 0.5f)) return from_angle(static_cast<double>(angle_rad));
        const float z = angle_rad * angle_rad;
        const float sine = angle_rad * (1 + z * (-1.0f / 6 + z * (1.0f / 120 - z * (1.0f / 5040))));
        const float cosine = 1 + z * (-0.5f + z * (1.0f / 24 + z * (-1.0f / 720 + z * (1.0f / 40320))));
        return {cosine, sine};
    }
    /// In (-pi, pi], rad.
    [[nodiscard]] float angle_rad() const { return static_cast<float>(deterministic::atan2(s, c)); }
};

/// The angles of many rotations, bit for bit those of `angle_rad`, in a fraction of the time. `out` has as
/// many places.
void angles_rad(std::span<const Rotation> rotations, std::span<float> out);

constexpr Vec2 rotate(Rotation q, Vec2 a) {
    return {q.c * a.x - q.s * a.y, q.s * a.x + q.c * a.y};
}
constexpr Vec2 inverse_rotate(Rotation q, Vec2 a) {
    return {q.c * a.x + q.s * a.y, q.c * a.y - q.s * a.x};
}
/// First b, then a.
constexpr Rotation operator*(Rotation a, Rotation b) {
    return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
}
constexpr Rotation inverse(Rotation q) {
    return {q.c, -q.s};
}
inline Rotation normalized(Rotation q) {
    const float n = std::sqrt(q.c * q.c + q.s * q.s);
    return n > 0 ? Rotation{q.c / n, q.s / n} : Rotation{};
}

/// The place of a body in the world.
struct Transform {
    Position p{};
    Rotation q{};

    friend constexpr bool operator==(const Transform&, const Transform&) = default;
};

constexpr Position transform_point(const Transform& xf, Vec2 local_m) {
    return xf.p + rotate(xf.q, local_m);
}
constexpr Vec2 inverse_transform_point(const Transform& xf, Position world_m) {
    return inverse_rotate(xf.q, world_m - xf.p);
}

}  // namespace cairn::physics
