// Shapes in the present color and line width.
#include "bind/graphics_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bind/fields.h"

namespace cairn::scripting {
namespace {

using engine::Vec2;

/// "fill" gives true, "line" false; it is the first argument of every shape.
bool is_filled(lua_State* L, std::string_view mode) {
    if (mode == "fill") return true;
    if (mode != "line") argument_error(L, 1, "\"fill\" or \"line\"");
    return false;
}

/// Appends the numbers of a list.
void read_numbers(lua_State* L, int table, std::vector<float>& out) {
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, table));
    out.reserve(out.size() + static_cast<std::size_t>(count));
    for (lua_Integer i = 1; i <= count; ++i) {
        if (lua_rawgeti(L, table, i) != LUA_TNUMBER) {
            call_error(L, "the list's member " + std::to_string(i) + " is " + describe_value(L, -1) +
                              "; expected a number");
        }
        const double number = lua_tonumber(L, -1);
        if (!(std::fabs(number) <= static_cast<double>(std::numeric_limits<float>::max()))) {
            call_error(L, "the list's member " + std::to_string(i) + " is " + describe_value(L, -1) +
                              "; expected a number " + kWithinFloat);
        }
        out.push_back(static_cast<float>(number));
        lua_pop(L, 1);
    }
}

/// Appends the numbers of a list of points: x1, y1, x2, y2, ... or {x1, y1}, {x2, y2}, ..., as the physics
/// has it.
void read_points(lua_State* L, int table, std::vector<float>& out) {
    const bool is_of_pairs = lua_rawgeti(L, table, 1) == LUA_TTABLE;
    lua_pop(L, 1);
    if (!is_of_pairs) return read_numbers(L, table, out);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, table));
    for (lua_Integer i = 1; i <= count; ++i) {
        if (lua_rawgeti(L, table, i) != LUA_TTABLE || lua_rawlen(L, -1) != 2) {
            call_error(L, "the list's member " + std::to_string(i) + " is " + describe_value(L, -1) +
                              "; expected {x, y}");
        }
        read_numbers(L, lua_gettop(L), out);
        lua_pop(L, 1);
    }
}

std::vector<Vec2> to_points(lua_State* L, const std::vector<float>& numbers, std::size_t least) {
    if (numbers.size() % 2 != 0) {
        call_error(L, "got " + std::to_string(numbers.size()) +
                          " numbers; points need two each: x1, y1, x2, y2, ...");
    }
    if (numbers.size() / 2 < least) {
        call_error(L, "got " + std::to_string(numbers.size() / 2) + " points; at least " +
                          std::to_string(least) + " are needed");
    }
    std::vector<Vec2> points(numbers.size() / 2);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {numbers[2 * i], numbers[2 * i + 1]};
    return points;
}

std::vector<Vec2> rounded_rectangle(float x, float y, float width, float height, float radius) {
    constexpr int kStepsPerCorner = 10;
    constexpr float kQuarterTurn = 1.57079633f;
    const float r = std::min(radius, std::min(width, height) / 2);
    const Vec2 centers[] = {
        {x + width - r, y + height - r}, {x + r, y + height - r}, {x + r, y + r}, {x + width - r, y + r}};
    std::vector<Vec2> points;
    for (int corner = 0; corner < 4; ++corner) {
        for (int step = 0; step <= kStepsPerCorner; ++step) {
            const float turn = static_cast<float>(corner) + static_cast<float>(step) / kStepsPerCorner;
            points.push_back(centers[corner] +
                             r * Vec2{std::cos(turn * kQuarterTurn), std::sin(turn * kQuarterTurn)});
        }
    }
    return points;
}

}  // namespace

std::vector<Vec2> read_point_list(lua_State* L, TableArgument list, std::size_t least) {
    std::vector<float> numbers;
    read_points(L, list.index, numbers);
    return to_points(L, numbers, least);
}

void rectangle(lua_State* L, std::string_view mode, float x, float y, NotNegative width, NotNegative height,
               std::optional<NotNegative> radius) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    const bool filled = is_filled(L, mode);
    if (radius && *radius > 0 && width > 0 && height > 0) {
        const std::vector<Vec2> points = rounded_rectangle(x, y, width, height, *radius);
        if (filled) return renderer.fill_convex_polygon(points, context.draw.color);
        return renderer.outline_polygon(points, context.draw.line_width, context.draw.color);
    }
    if (filled) return renderer.fill_rectangle({x, y, width, height}, context.draw.color);
    renderer.outline_rectangle({x, y, width, height}, context.draw.line_width, context.draw.color);
}

void circle(lua_State* L, std::string_view mode, float x, float y, NotNegative radius) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    if (is_filled(L, mode)) return renderer.fill_circle({x, y}, radius, context.draw.color);
    renderer.outline_circle({x, y}, radius, context.draw.line_width, context.draw.color);
}

void ellipse(lua_State* L, std::string_view mode, float x, float y, NotNegative radius_x,
             NotNegative radius_y) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    if (is_filled(L, mode)) return renderer.fill_ellipse({x, y}, {radius_x, radius_y}, context.draw.color);
    renderer.outline_ellipse({x, y}, {radius_x, radius_y}, context.draw.line_width, context.draw.color);
}

void arc(lua_State* L, std::string_view mode, float x, float y, NotNegative radius, float from, float to) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    if (is_filled(L, mode)) return renderer.fill_sector({x, y}, radius, from, to, context.draw.color);
    renderer.draw_arc({x, y}, radius, from, to, context.draw.line_width, context.draw.color);
}

void capsule(lua_State* L, std::string_view mode, float x1, float y1, float x2, float y2,
             NotNegative radius) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    if (is_filled(L, mode)) return renderer.fill_capsule({x1, y1}, {x2, y2}, radius, context.draw.color);
    renderer.outline_capsule({x1, y1}, {x2, y2}, radius, context.draw.line_width, context.draw.color);
}

void polygon(lua_State* L, std::string_view mode, TableArgument points) {
    Context& context = drawing_context(L);
    const bool filled = is_filled(L, mode);
    const std::vector<Vec2> corners = read_point_list(L, points, 3);
    if (filled) return check_or_raise(L, context.services.renderer.fill_polygon(corners, context.draw.color));
    context.services.renderer.outline_polygon(corners, context.draw.line_width, context.draw.color);
}

void line(lua_State* L, FurtherArguments points) {
    Context& context = drawing_context(L);
    std::vector<float> numbers;
    if (lua_istable(L, points.first)) {
        if (points.count > 1) count_error(L, 1);
        read_points(L, points.first, numbers);
    } else {
        for (int i = points.first; i < points.first + std::max(points.count, 1); ++i) {
            if (lua_type(L, i) != LUA_TNUMBER) argument_error(L, i, "a number, or one list of numbers");
            numbers.push_back(Argument<float>::get(L, i));
        }
    }
    const std::vector<Vec2> path = to_points(L, numbers, 2);
    context.services.renderer.draw_polyline(path, context.draw.line_width, context.draw.color);
}

void mesh(lua_State* L, TableArgument vertices, std::optional<Picture> image) {
    Context& context = drawing_context(L);
    if (image) check_drawable(L, image->texture);
    const std::size_t stride = image ? 8 : 6;
    std::vector<float> numbers;
    read_numbers(L, vertices.index, numbers);
    if (numbers.size() % (3 * stride) != 0) {
        call_error(L, "got " + std::to_string(numbers.size()) +
                          " numbers; every triangle needs three vertices of " + std::to_string(stride) +
                          " numbers");
    }
    std::vector<engine::MeshVertex> corners(numbers.size() / stride);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const float* n = &numbers[i * stride];
        corners[i] = {{n[0], n[1]}, {n[2], n[3], n[4], n[5]}, image ? Vec2{n[6], n[7]} : Vec2{}};
    }
    engine::Renderer& renderer = context.services.renderer;
    if (image) {
        const engine::Affine2 map = image->texture_from_picture(renderer.texture_size(image->texture));
        for (engine::MeshVertex& corner : corners) corner.uv = map.apply(corner.uv);
    }
    std::vector<std::uint32_t> indices(corners.size());
    std::iota(indices.begin(), indices.end(), 0u);
    renderer.draw_mesh(corners, indices, image ? image->texture : engine::TextureId{});
}

}  // namespace cairn::scripting
