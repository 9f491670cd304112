// The default look of bodies: the outlines of their shapes, filled with a color or an image.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "bind/fields.h"
#include "bind/graphics_objects.h"
#include "bind/outline_corners.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using engine::Color;
using engine::Vec2;

constexpr float kPi = 3.14159265f;
/// The rim of a body in pixels: wide enough to tell stacked boxes apart, narrow enough not to look like a
/// cartoon.
constexpr float kRimPixels = 1.5f;
constexpr float kRimShade = 0.62f;
/// Corners of a full circle, when it must become a polygon.
constexpr int kCircleCorners = 48;

Vec2 to_engine(physics::Vec2 v) {
    return {v.x, v.y};
}

Color default_color(physics::BodyType type) {
    switch (type) {
        case physics::BodyType::Static:
            return {0.44f, 0.49f, 0.45f, 1};
        case physics::BodyType::Kinematic:
            return {0.36f, 0.53f, 0.72f, 1};
        case physics::BodyType::Dynamic:
            return {0.87f, 0.66f, 0.40f, 1};
    }
    return {};
}

Color shaded(Color color, float factor) {
    return {color.r * factor, color.g * factor, color.b * factor, color.a};
}

/// A segment: there is nothing to fill.
bool is_line(const physics::Outline& outline) {
    return outline.count == 2 && outline.radius_m == 0;
}

void draw_textured(engine::Renderer& renderer, const physics::Outline& outline, const Picture& picture,
                   Color tint) {
    const std::vector<Vec2> corners = rounded_corners(outline);
    Vec2 low = corners.front();
    Vec2 high = low;
    for (const Vec2 corner : corners) {
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    // The image spans the bounds, its top at the greatest y.
    const engine::Affine2 uv_from_local{
        1 / (high.x - low.x),     0, 0, 1 / (low.y - high.y), -low.x / (high.x - low.x),
        high.y / (high.y - low.y)};
    const engine::Affine2 within = picture.texture_from_picture(renderer.texture_size(picture.texture));
    renderer.fill_convex_polygon(corners, picture.texture, within * uv_from_local, tint);
}

void draw_plain(engine::Renderer& renderer, const physics::Outline& outline, Color color, float rim) {
    const Color rim_color = shaded(color, kRimShade);
    const Vec2 a = to_engine(outline.points_m[0]);
    if (outline.kind == physics::ShapeKind::Circle) {
        renderer.fill_circle(a, outline.radius_m, color);
        renderer.outline_circle(a, std::max(outline.radius_m - rim / 2, rim / 2), rim, rim_color);
        // A spoke, so that one sees it roll.
        renderer.draw_line(a, a + Vec2{outline.radius_m, 0}, rim, rim_color, engine::LineCap::Butt);
        return;
    }
    if (is_line(outline)) {
        renderer.draw_line(a, to_engine(outline.points_m[1]), 2 * rim, rim_color);
        return;
    }
    const std::vector<Vec2> corners = rounded_corners(outline);
    renderer.fill_convex_polygon(corners, color);
    renderer.outline_polygon(corners, rim, rim_color);
}

/// The named field of the table on top of the stack is pushed.
bool push_field(lua_State* L, const char* name) {
    lua_pushstring(L, name);
    lua_rawget(L, -2);
    return !lua_isnil(L, -1);
}

/// For messages, as bodies have no names.
std::string place_text(physics::Body body) {
    std::ostringstream text;
    text << "the body at (" << body.position().x << ", " << body.position().y << ')';
    return text.str();
}

/// { r, g, b, a? } on top of the stack; a color of that body.
Color read_color(lua_State* L, physics::Body body) {
    Color color;
    float* const parts[] = {&color.r, &color.g, &color.b, &color.a};
    for (int i = 0; i < 4; ++i) {
        lua_rawgeti(L, -1, i + 1);
        if (lua_type(L, -1) == LUA_TNUMBER) {
            *parts[i] = static_cast<float>(lua_tonumber(L, -1));
        } else if (i < 3) {
            call_error(L, "data.color of " + place_text(body) +
                              " must be {r, g, b} or {r, g, b, a} with numbers from 0 to 1");
        }
        lua_pop(L, 1);
    }
    return color;
}

}  // namespace

std::vector<Vec2> rounded_corners(const physics::Outline& outline) {
    std::vector<Vec2> corners;
    const std::size_t count = outline.count;
    if (outline.radius_m == 0) {
        for (std::size_t i = 0; i < count; ++i) corners.push_back(to_engine(outline.points_m[i]));
        return corners;
    }
    // Each corner turns from the normal of the edge before it to that of the edge behind it; anticlockwise.
    const auto normal_behind = [&](std::size_t i) {
        const physics::Vec2 edge = outline.points_m[(i + 1) % count] - outline.points_m[i];
        return std::atan2(-edge.x, edge.y);
    };
    for (std::size_t i = 0; i < count; ++i) {
        float from = 0;
        float to = 2 * kPi;
        if (count > 1) {
            from = normal_behind((i + count - 1) % count);
            to = normal_behind(i);
            while (to < from) to += 2 * kPi;
        }
        const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / (2 * kPi) * kCircleCorners)));
        for (int step = 0; step < steps + (count > 1 ? 1 : 0); ++step) {
            const float angle = from + (to - from) * static_cast<float>(step) / static_cast<float>(steps);
            const Vec2 center = to_engine(outline.points_m[i]);
            corners.push_back(center + outline.radius_m * Vec2{std::cos(angle), std::sin(angle)});
        }
    }
    return corners;
}

void draw_body(lua_State* L, Context& context, const BodyObject& object, physics::Body body, int body_index) {
    Color color = default_color(body.type());
    bool has_color = false;
    std::optional<Picture> picture;
    const int top = lua_gettop(L);
    lua_getfield(L, body_index, "data");
    if (push_field(L, "visible") && lua_toboolean(L, -1) == 0) {
        lua_settop(L, top);
        return;
    }
    lua_pop(L, 1);
    if (push_field(L, "color")) {
        if (!lua_istable(L, -1)) {
            call_error(L, "data.color of " + place_text(body) + " is " + describe_value(L, -1) +
                              "; expected a table {r, g, b, a?}");
        }
        color = read_color(L, body);
        has_color = true;
    }
    lua_pop(L, 1);
    if (push_field(L, "image")) {
        picture = picture_at(L, -1);
        if (!picture) {
            call_error(L, "data.image of " + place_text(body) + " is " + describe_value(L, -1) +
                              "; expected an Image, a Canvas or a Quad");
        }
        check_drawable(L, picture->texture);
    }
    lua_settop(L, top);

    engine::Renderer& renderer = context.services.renderer;
    const physics::Transform xf = body.interpolated_transform(static_cast<float>(context.alpha));
    check_or_raise(L, renderer.push_transform());
    renderer.translate({static_cast<float>(xf.p.x), static_cast<float>(xf.p.y)});
    renderer.rotate(xf.q.angle_rad());
    const float pixels_per_unit = renderer.transform().mean_scale();
    const float rim = pixels_per_unit > 0 ? kRimPixels / pixels_per_unit : 0;
    for (const physics::ShapeId id : body.shapes()) {
        const auto shape = object.world->world->shape(id);
        if (!shape || shape->is_sensor()) continue;
        if (picture && !is_line(shape->outline())) {
            draw_textured(renderer, shape->outline(), *picture, has_color ? color : Color{});
        } else {
            draw_plain(renderer, shape->outline(), color, rim);
        }
    }
    check_or_raise(L, renderer.pop_transform());
}

}  // namespace cairn::scripting
