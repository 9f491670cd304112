// What a body is made of: geometry in the body's frame, material and filter.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>

#include <cairn/physics/math.h>

namespace cairn::physics {

inline constexpr int kMaxPolygonVertices = 8;

/// A disc. radius_m > 0.
struct Circle {
    Vec2 center_m{};
    float radius_m = 0.5f;
};

/// All points within radius_m of the segment from a_m to b_m. radius_m > 0; a_m and b_m apart by more than 5
/// mm (for one point take a Circle).
struct Capsule {
    Vec2 a_m{-0.5f, 0};
    Vec2 b_m{0.5f, 0};
    float radius_m = 0.25f;
};

/// A line without thickness or mass, from a_m to b_m, apart by more than 5 mm. Solid from both sides; meets
/// every shape but other segments. A dynamic body of segments alone has no mass: nothing pushes it, and it
/// keeps its velocity until it gets a shape that has mass.
struct Segment {
    Vec2 a_m{-0.5f, 0};
    Vec2 b_m{0.5f, 0};
};

/// A rectangle, turned by angle_rad about its centre; corners rounded outward by radius_m >= 0. Its sides are
/// longer than what float rounds off at its place on the body.
struct Box {
    float half_width_m = 0.5f;
    float half_height_m = 0.5f;
    Vec2 center_m{};
    float angle_rad = 0;
    float radius_m = 0;
};

/// The convex hull of the points, in any order, with 3 to kMaxPolygonVertices corners, rounded outward by
/// radius_m >= 0. The points are copied when the shape is made.
struct Polygon {
    std::span<const Vec2> points_m{};
    float radius_m = 0;
};

using Geometry = std::variant<Circle, Capsule, Box, Polygon, Segment>;

enum class ShapeKind : std::uint8_t { Circle, Capsule, Polygon, Segment, ChainSegment };

inline constexpr int kMaterialKinds = 64;

/// How a surface rubs, bounces, rolls and runs. Two materials mix as sqrt(f_a f_b) and max(e_a, e_b), unless
/// World::set_material_rule says otherwise for their kinds; of two rolling resistances the larger counts,
/// surface speeds add up.
struct Material {
    float friction = 0.6f;  ///< Coulomb coefficient, >= 0
    float restitution = 0;  ///< share of the approach speed given back, 0..1
    /// Coefficient, >= 0: a torque of up to this times the normal force times the radius by which the shape
    /// is rounded (the larger of the two) resists rolling. A disc that rolls on level ground slows down by
    /// 2/3 of this times g.
    float rolling_resistance = 0;
    /// The surface runs clockwise round the shape, as a conveyor belt does: positive carries to the right
    /// what lies on top. Friction does the carrying.
    float surface_speed_m_s = 0;
    int kind = 0;  ///< what World::set_material_rule knows it by, 0..kMaterialKinds - 1
};

/// Who collides with whom. A pair collides when each one's categories meet the other's mask. Two shapes of
/// the same non-zero group ignore the masks: they collide when it is positive, and never when it is negative.
struct Filter {
    std::uint64_t categories = 1;
    std::uint64_t mask = ~std::uint64_t{0};
    std::int32_t group = 0;
};

/// Everything about a shape besides its geometry.
struct ShapeDef {
    float density_kg_m2 = 1;  ///< mass per area, >= 0
    Material material{};
    Filter filter{};
    bool contact_events = false;  ///< report begin and end of touching; either shape of a pair is enough
    bool hit_events = false;  ///< report impacts faster than WorldDef::hit_speed_m_s; either shape is enough
    /// A sensor collides with nothing and has no mass; it notes which shapes overlap it at the end of each
    /// step, or passed through it within the step, on a straight way and turning by
    /// less than half a round, chain segments from their front: of static, kinematic, dynamic and
    /// sleeping bodies alike, without waking them. It does not see other sensors, shapes of its own body,
    /// what the filters forbid, nor, on a static body, other static shapes. Rays and other queries do not see
    /// sensors.
    bool sensor = false;
    bool seen_by_sensors = true;
    /// In the body's frame. Not (0, 0): the shape is solid only for what comes from the side to which this
    /// points, within 60 degrees, as a platform that is jumped onto from below. All else goes through, until
    /// it is apart from the shape or in front of it.
    Vec2 one_way_normal{};
    std::uint64_t user_data = 0;
};

/// A shape as the world keeps it: the hull of `count` points (1: circle, 2: capsule or segments, else
/// polygon, anticlockwise), rounded by radius_m, in the body's frame.
struct Outline {
    ShapeKind kind = ShapeKind::Circle;
    std::uint8_t count = 0;
    float radius_m = 0;
    std::array<Vec2, kMaxPolygonVertices> points_m{};
};

}  // namespace cairn::physics
