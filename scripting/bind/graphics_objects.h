// Images, what is like them, and fonts as Lua values, and what drawing functions share.
#pragma once

#include <vector>

#include <cairn/engine/renderer.h>

#include "bind/context.h"
#include "bind/function.h"
#include "bind/object.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

struct ImageObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Image;
    engine::TextureId texture;
};
/// A picture that is drawn into. Its texture goes when the garbage collector finds it.
struct CanvasObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Canvas;
    engine::TextureId texture;
    engine::Size size;
};
/// A part of an image or canvas, which is user value 1.
struct QuadObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Quad;
    engine::TextureId texture;
    engine::Rect source;  ///< in pixels
};

/// What can be drawn like an image: an Image, a Canvas, or a Quad, which is a part of either.
struct Picture {
    engine::TextureId texture;
    engine::Rect source;  ///< in pixels

    /// From places in the picture, 0 to 1 from its top left, to those in its texture.
    [[nodiscard]] engine::Affine2 texture_from_picture(engine::Size texture_size) const;
};
/// The picture at an index, or nothing when something else stands there.
std::optional<Picture> picture_at(lua_State* L, int index);
/// Raises an error when what is to be drawn is the canvas that is drawn into.
void check_drawable(lua_State* L, engine::TextureId texture);

template <>
struct Argument<Picture> {
    static constexpr std::string_view kType = "Image|Canvas|Quad";
    static Picture get(lua_State* L, int index);
};

struct FontObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Font;
    engine::FontId font;
    float size;
};

template <>
struct Argument<ImageObject*> {
    static constexpr std::string_view kType = "Image";
    static ImageObject* get(lua_State* L, int index) {
        auto* image = object_at<ImageObject>(L, index);
        if (image == nullptr) argument_error(L, index, "an Image");
        return image;
    }
};
template <>
struct Argument<CanvasObject*> {
    static constexpr std::string_view kType = "Canvas";
    static CanvasObject* get(lua_State* L, int index) {
        auto* canvas = object_at<CanvasObject>(L, index);
        if (canvas == nullptr) argument_error(L, index, "a Canvas");
        return canvas;
    }
};
template <>
struct Argument<QuadObject*> {
    static constexpr std::string_view kType = "Quad";
    static QuadObject* get(lua_State* L, int index) {
        auto* quad = object_at<QuadObject>(L, index);
        if (quad == nullptr) argument_error(L, index, "a Quad");
        return quad;
    }
};
template <>
struct Argument<FontObject*> {
    static constexpr std::string_view kType = "Font";
    static FontObject* get(lua_State* L, int index) {
        auto* font = object_at<FontObject>(L, index);
        if (font == nullptr) argument_error(L, index, "a Font");
        return font;
    }
};

/// The context while a picture is drawn; at other times an error is raised.
Context& drawing_context(lua_State* L);

/// The font that is set, or the default one, which is loaded when it is first needed.
engine::FontId current_font(lua_State* L);

/// "linear", which is also what nothing means, or "nearest".
engine::TextureFilter to_filter(lua_State* L, int index, std::optional<std::string_view> name);

/// The default font, which is loaded when it is first needed.
engine::FontId default_font(lua_State* L);

/// The numbers of { x1, y1, x2, y2, ... } as points.
std::vector<engine::Vec2> read_point_list(lua_State* L, TableArgument list, std::size_t least);

/// Draws one body where it is between the last two steps; its value stands at `body_index`.
void draw_body(lua_State* L, Context& context, const BodyObject& object, physics::Body body, int body_index);

}  // namespace cairn::scripting
