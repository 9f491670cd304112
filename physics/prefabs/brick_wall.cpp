// A joint of mortar between two bricks bears the force of its length, and the torque that the same stress has
// about its middle when it bends: a quarter of force times length.
#include <string>

#include <cairn/physics/prefabs/brick_wall.h>

#include "prefabs/builder.h"

namespace cairn::physics {
namespace {

struct Brick {
    BodyId body{};
    float left_m = 0;
    float right_m = 0;
};

/// Bricks of one course from left to right, as they lie about the middle of the wall.
std::vector<Brick> lay_out(const BrickWallDef& def, int course) {
    const float half = static_cast<float>(def.columns) * def.brick_width_m / 2;
    const bool is_shifted = course % 2 == 1;
    std::vector<Brick> bricks;
    float left = -half;
    while (left < half - 0.25f * def.brick_width_m) {
        const bool is_half = is_shifted && bricks.empty();
        const float right = std::min(half, left + (is_half ? 0.5f : 1.0f) * def.brick_width_m);
        bricks.push_back({.left_m = left, .right_m = right});
        left = right;
    }
    return bricks;
}

class Mason {
  public:
    Mason(Builder& builder, const BrickWallDef& def) : builder_(builder), def_(def) {}

    void lay(Brick& brick, int course) {
        const float width = brick.right_m - brick.left_m;
        brick.body =
            builder_.body({.position_m = at(brick.left_m + width / 2, static_cast<float>(course) + 0.5f)});
        builder_.shape(brick.body, Box{width / 2, def_.brick_height_m / 2}, def_.shape);
    }
    /// Two bricks side by side.
    void bind_beside(const Brick& left, const Brick& right, int course) {
        weld(left, right, at(left.right_m, static_cast<float>(course) + 0.5f), def_.brick_height_m);
    }
    /// Two bricks of which one lies on the other, if they touch.
    void bind_above(const Brick& lower, const Brick& upper, int course) {
        const float left = std::max(lower.left_m, upper.left_m);
        const float right = std::min(lower.right_m, upper.right_m);
        if (right - left < 0.1f * def_.brick_width_m) return;
        weld(lower, upper, at((left + right) / 2, static_cast<float>(course) + 1), right - left);
    }

  private:
    [[nodiscard]] Position at(float x_m, float courses) const {
        return def_.position_m + Vec2{x_m, courses * def_.brick_height_m};
    }
    void weld(const Brick& a, const Brick& b, Position point, float mortar_m) {
        WeldJointDef weld;
        builder_.place(weld, a.body, b.body, point);
        weld.strength.break_force_n = def_.mortar_n_m * mortar_m;
        weld.strength.break_torque_nm = weld.strength.break_force_n * mortar_m / 4;
        builder_.joint(weld);
    }

    Builder& builder_;
    const BrickWallDef& def_;
};

}  // namespace

Result<BrickWall> create_brick_wall(World& world, const BrickWallDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("brick_wall.position_m", def.position_m),
        check_count("brick_wall.columns", def.columns, 1, 1000),
        check_count("brick_wall.courses", def.courses, 1, 1000),
        check::require(std::isfinite(def.brick_width_m) && def.brick_width_m > 0.02f,
                       "brick_wall.brick_width_m", as_double(def.brick_width_m),
                       "finite and greater than 0.02 m"),
        check::require(std::isfinite(def.brick_height_m) && def.brick_height_m > 0.01f,
                       "brick_wall.brick_height_m", as_double(def.brick_height_m),
                       "finite and greater than 0.01 m"),
        check::positive("brick_wall.mortar_n_m", as_double(def.mortar_n_m)),
    });
    const bool has_counts =
        def.columns >= 1 && def.columns <= 1000 && def.courses >= 1 && def.courses <= 1000;
    if (has_counts) {
        const int most = kMaxBricks / def.columns;
        const std::string rule = "at most " + std::to_string(most) + " where columns is " +
                                 std::to_string(def.columns) + ": a wall has at most " +
                                 std::to_string(kMaxBricks) + " bricks";
        builder.require(
            {check::require(def.courses <= most, "brick_wall.courses", def.courses, rule.c_str())});
    }
    Mason mason(builder, def);
    std::vector<Brick> below;
    for (int course = 0; builder.good() && course < def.courses; ++course) {
        std::vector<Brick> bricks = lay_out(def, course);
        for (Brick& brick : bricks) mason.lay(brick, course);
        for (std::size_t i = 1; i < bricks.size(); ++i) mason.bind_beside(bricks[i - 1], bricks[i], course);
        for (const Brick& lower : below) {
            for (const Brick& upper : bricks) mason.bind_above(lower, upper, course - 1);
        }
        below = std::move(bricks);
    }
    return builder.finish(BrickWall{});
}

}  // namespace cairn::physics
