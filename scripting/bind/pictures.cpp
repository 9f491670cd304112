// Canvases, quads and atlases. Invariant: whatever shows a canvas keeps it alive, so its texture goes only
// when nothing can draw it any more.
#include "bind/pictures.h"

#include <cairn/engine/atlas.h>

#include "bind/fields.h"
#include "bind/modules.h"
#include "data/nearest.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {

engine::Affine2 Picture::texture_from_picture(engine::Size size) const {
    const auto width = static_cast<float>(size.width);
    const auto height = static_cast<float>(size.height);
    return {source.width / width, 0, 0, source.height / height, source.x / width, source.y / height};
}

std::optional<Picture> picture_at(lua_State* L, int index) {
    const auto whole = [](engine::TextureId texture, engine::Size size) {
        return Picture{texture, {0, 0, static_cast<float>(size.width), static_cast<float>(size.height)}};
    };
    if (const auto* image = object_at<ImageObject>(L, index))
        return whole(image->texture, context_of(L).services.renderer.texture_size(image->texture));
    if (const auto* canvas = object_at<CanvasObject>(L, index)) return whole(canvas->texture, canvas->size);
    if (const auto* quad = object_at<QuadObject>(L, index)) return Picture{quad->texture, quad->source};
    return std::nullopt;
}

Picture Argument<Picture>::get(lua_State* L, int index) {
    const std::optional<Picture> picture = picture_at(L, index);
    if (!picture) argument_error(L, index, "an Image, a Canvas or a Quad");
    return *picture;
}

void check_drawable(lua_State* L, engine::TextureId texture) {
    if (!texture.is_null() && texture == context_of(L).services.renderer.current_canvas())
        call_error(L, "the canvas is being drawn into and cannot be drawn at the same time; detach it first");
}

// ---- Canvas

engine::TextureFilter to_filter(lua_State* L, int index, std::optional<std::string_view> name) {
    const std::string_view filter = name.value_or("linear");
    if (filter != "linear" && filter != "nearest") argument_error(L, index, "\"linear\" or \"nearest\"");
    return filter == "nearest" ? engine::TextureFilter::Nearest : engine::TextureFilter::Linear;
}

Pushed new_canvas(lua_State* L, CanvasSide width, CanvasSide height, std::optional<std::string_view> filter) {
    const engine::Size size{static_cast<int>(width.value), static_cast<int>(height.value)};
    new_object<CanvasObject>(
        L, 0, value_or_raise(L, context_of(L).services.renderer.create_canvas(size, to_filter(L, 3, filter))),
        size);
    constexpr std::size_t kBytesPerPixel = 4;
    charge_native_memory(
        L, kBytesPerPixel * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    return {1};
}

int finalize_canvas(lua_State* L) {
    context_of(L).services.renderer.destroy_texture(object_at<CanvasObject>(L, 1)->texture);
    return 0;
}

// ---- Quad

namespace {

/// Pushes a part of the image that stands at an index.
void push_quad(lua_State* L, int image_index, engine::TextureId texture, const engine::Rect& source) {
    image_index = lua_absindex(L, image_index);
    new_object<QuadObject>(L, 1, texture, source);
    lua_pushvalue(L, image_index);
    lua_setiuservalue(L, -2, 1);
}

}  // namespace

Pushed new_quad(lua_State* L, Picture image, float x, float y, float width, float height) {
    const engine::Rect& whole = image.source;
    // Written so that NaN fails too.
    if (!(x >= 0 && y >= 0 && width > 0 && height > 0 && x + width <= whole.width &&
          y + height <= whole.height)) {
        call_error(L, "x, y, width, height is " + describe_value(L, 2) + ", " + describe_value(L, 3) + ", " +
                          describe_value(L, 4) + ", " + describe_value(L, 5) +
                          "; it must have an area and lie inside the image, which has " +
                          std::to_string(static_cast<int>(whole.width)) + " x " +
                          std::to_string(static_cast<int>(whole.height)) + " pixels");
    }
    push_quad(L, 1, image.texture, {whole.x + x, whole.y + y, width, height});
    return {1};
}

// ---- Atlas

namespace {

/// User value 1 is a table, name -> Quad; user value 2 the list of names in the order of the file.
struct AtlasObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Atlas;
};

}  // namespace

template <>
struct Argument<AtlasObject*> {
    static constexpr std::string_view kType = "Atlas";
    static AtlasObject* get(lua_State* L, int index) {
        auto* atlas = object_at<AtlasObject>(L, index);
        if (atlas == nullptr) argument_error(L, index, "an Atlas");
        return atlas;
    }
};

Pushed new_atlas(lua_State* L, std::string_view path, std::optional<std::string_view> filter) {
    const Services& services = context_of(L).services;
    const engine::Atlas atlas = value_or_raise(L, engine::load_atlas(services.files, path));
    const engine::TextureId texture =
        value_or_raise(L, services.renderer.load_texture(atlas.image_path, to_filter(L, 2, filter)));
    const engine::Size size = services.renderer.texture_size(texture);
    check_or_raise(L, engine::check_atlas(atlas, size, path));

    new_object<AtlasObject>(L, 2);
    new_object<ImageObject>(L, 0, texture);
    lua_createtable(L, 0, static_cast<int>(atlas.frames.size()));
    lua_createtable(L, static_cast<int>(atlas.frames.size()), 0);
    lua_Integer count = 0;
    for (const engine::AtlasFrame& frame : atlas.frames) {
        lua_pushlstring(L, frame.name.data(), frame.name.size());
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, ++count);  // into the names
        push_quad(L, -4, texture, frame.source);
        lua_rawset(L, -4);  // into the quads
    }
    lua_setiuservalue(L, -4, 2);
    lua_setiuservalue(L, -3, 1);
    lua_pop(L, 1);  // the image, which the quads keep
    return {1};
}

namespace {

Pushed atlas_quad(lua_State* L, AtlasObject*, std::string_view name) {
    lua_getiuservalue(L, 1, 1);
    lua_pushlstring(L, name.data(), name.size());
    lua_rawget(L, -2);
    if (!lua_isnil(L, -1)) return {1};
    std::vector<std::string> names;
    lua_getiuservalue(L, 1, 2);
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TSTRING; ++i) {
        names.emplace_back(lua_tostring(L, -1));
        lua_pop(L, 1);
    }
    call_error(L,
               "name is " + quote_text(name) + ": the atlas has no such picture" + suggestion(name, names));
}

Pushed atlas_names(lua_State* L, AtlasObject*) {
    lua_getiuservalue(L, 1, 2);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    lua_createtable(L, static_cast<int>(count), 0);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, -2, i);
        lua_rawseti(L, -2, i);
    }
    return {1};
}

// ---- Methods

std::tuple<std::int64_t, std::int64_t> canvas_size(CanvasObject* self) {
    return {self->size.width, self->size.height};
}

engine::Result<void> attach(lua_State* L, CanvasObject* self, std::optional<float> r, std::optional<float> g,
                            std::optional<float> b, std::optional<float> a) {
    std::optional<engine::Color> clear;
    if (r) clear = engine::Color{*r, g.value_or(*r), b.value_or(*r), a.value_or(1)};
    return drawing_context(L).services.renderer.begin_canvas(self->texture, clear);
}

engine::Result<void> detach(lua_State* L, CanvasObject* self) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    if (renderer.current_canvas() != self->texture)
        call_error(L, "it is not the canvas that was attached last");
    std::erase_if(context.draw.cameras,
                  [&](const AttachedCamera& attached) { return attached.canvas == self->texture; });
    return renderer.end_canvas();
}

std::tuple<float, float> quad_size(QuadObject* self) {
    return {self->source.width, self->source.height};
}

std::tuple<float, float, float, float> quad_region(QuadObject* self) {
    return {self->source.x, self->source.y, self->source.width, self->source.height};
}

constexpr std::array<std::string_view, 1> kReturnsQuad = {"Quad"};
constexpr std::array<std::string_view, 1> kReturnsNames = {"string[]"};

constexpr Function kCanvasFunctions[] = {
    function<&attach>(
        "attach", "r = nil, g = r, b = r, a = 1", "",
        "From here on drawing goes into the canvas, from its top left, with transforms, blend mode and "
        "scissor of its own; only in `cairn.draw`. With a color it is filled with it first, else it "
        "keeps what it shows, from picture to picture too."),
    function<&detach>("detach", "", "", "Drawing goes where it went before `attach`."),
    function<&canvas_size>("size", "", "width [px], height [px]", ""),
};
constexpr Function kQuadFunctions[] = {
    function<&quad_size>("size", "", "width [px], height [px]", ""),
    function<&quad_region>("region", "", "x [px], y [px], width [px], height [px]",
                           "Where in its image it lies."),
};
constexpr Function kAtlasFunctions[] = {
    function_pushing<&atlas_quad>("quad", "name", "quad", kReturnsQuad,
                                  "A part by its name; an unknown one is an error."),
    function_pushing<&atlas_names>("names", "", "names", kReturnsNames,
                                   "A new list of all names, as the file has them."),
};

}  // namespace

const Module kCanvasMethods = {
    "Canvas",
    "A picture that is drawn into, and can be drawn like an image. Headless runs draw only "
    "now and then, so what gameplay needs to know does not belong here.",
    kCanvasFunctions, true};
const Module kQuadMethods = {"Quad", "A part of an image, which can be drawn like one.", kQuadFunctions,
                             true};
const Module kAtlasMethods = {"Atlas", "Named parts of one image.", kAtlasFunctions, true};

}  // namespace cairn::scripting
