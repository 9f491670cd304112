// Turns the bytes that the fuzzer makes up into numbers and shapes.
// Invariant: any bytes are an input; when they are used up, every draw gives 0. Equal bytes give equal draws.
// Numbers lie on a grid, so that bytes that repeat give what random numbers hardly ever do: parallel edges,
// equal points, shapes that just touch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>

#include <cairn/physics/shape.h>

#include "collide/manifold.h"

namespace cairn::physics::fuzz {

/// What must hold. Ends the program otherwise, and the fuzzer keeps the input.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: it does not hold that %s\n", what);
    std::abort();
}

class Input {
  public:
    Input(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

    [[nodiscard]] bool is_empty() const { return left_.empty(); }
    std::uint8_t byte() {
        if (left_.empty()) return 0;
        const std::uint8_t first = left_.front();
        left_ = left_.subspan(1);
        return first;
    }
    /// From 0 up to, and without, count, which is at most 256.
    int below(int count) { return byte() % count; }
    bool flag() { return (byte() & 1) != 0; }
    /// One of 65,536 evenly spaced numbers.
    float real(float low, float high) {
        const int steps = byte() << 8 | byte();
        return low + (high - low) * (static_cast<float>(steps) / 65535);
    }
    Vec2 vector(float low, float high) {
        const float x = real(low, high);
        return {x, real(low, high)};
    }
    /// Mostly a number from a grid; sometimes any float: infinite, NaN, huge, subnormal.
    float hostile(float low, float high) {
        if (byte() % 16 != 15) return real(low, high);
        std::array<std::uint8_t, 4> bits{};
        for (std::uint8_t& b : bits) b = byte();
        float number = 0;
        std::memcpy(&number, bits.data(), sizeof number);
        return number;
    }
    Vec2 hostile_vector(float low, float high) {
        const float x = hostile(low, high);
        return {x, hostile(low, high)};
    }
    std::uint64_t bits() {
        std::uint64_t value = 0;
        for (int i = 0; i < 8; ++i) value = value << 8 | byte();
        return value;
    }

  private:
    std::span<const std::uint8_t> left_;
};

/// A shape's description, and the points that a polygon's points to.
struct Description {
    std::array<Vec2, kMaxPolygonVertices + 2> points{};
    Geometry geometry;

    Description() = default;
    Description(const Description&) = delete;
    Description& operator=(const Description&) = delete;
};

/// Fills in a shape of any kind. `number` and `vector` draw its numbers, of about -2 to 2.
template <class Number, class Vector>
void describe(Description& shape, Input& in, Number&& number, Vector&& vector) {
    switch (in.below(6)) {
        case 0:
            shape.geometry = Circle{.center_m = vector(), .radius_m = number()};
            return;
        case 1: {
            const Vec2 a = vector();
            const Vec2 b = vector();
            shape.geometry = Capsule{.a_m = a, .b_m = b, .radius_m = number()};
            return;
        }
        case 2: {
            const Vec2 a = vector();
            shape.geometry = Segment{.a_m = a, .b_m = vector()};
            return;
        }
        case 3: {
            const Vec2 half = vector();
            const Vec2 center = vector();
            const bool is_turned = in.flag();
            const float angle = is_turned ? number() : 0;
            shape.geometry = Box{.half_width_m = half.x,
                                 .half_height_m = half.y,
                                 .center_m = center,
                                 .angle_rad = angle,
                                 .radius_m = in.flag() ? number() : 0};
            return;
        }
        default: {
            const int count = in.below(static_cast<int>(shape.points.size()) + 1);
            for (int i = 0; i < count; ++i) shape.points[i] = vector();
            shape.geometry = Polygon{.points_m = std::span(shape.points).first(count),
                                     .radius_m = in.flag() ? number() : 0};
        }
    }
}

inline void describe_hostile(Description& shape, Input& in) {
    describe(
        shape, in, [&] { return in.hostile(-0.5f, 2); }, [&] { return in.hostile_vector(-2, 2); });
}

/// A valid shape with coordinates of at most 2 m, or an error because the numbers do not make one.
inline Result<Convex> small_shape(Input& in) {
    Description shape;
    describe(
        shape, in, [&] { return in.real(0.01f, 1); }, [&] { return in.vector(-2, 2); });
    return make_convex(shape.geometry);
}

/// Nearby and turned by any angle; level or upright now and then, so that edges are parallel.
inline RelativePose small_pose(Input& in) {
    const Vec2 p = in.vector(-4, 4);
    const int turn = in.below(8);
    const double angle = turn < 4 ? turn * 1.5707963267948966 : static_cast<double>(in.real(-4, 4));
    return {p, Rotation::from_angle(angle)};
}

inline RelativePose inverse_of(const RelativePose& pose) {
    return {-inverse_rotate(pose.q, pose.p), inverse(pose.q)};
}

}  // namespace cairn::physics::fuzz
