// cairn.graphics: state, transforms, images, text and bodies. The shapes stand in graphics_shapes.cpp.
#include <cmath>

#include "bind/graphics_debug.h"
#include "bind/graphics_objects.h"
#include "bind/graphics_shapes.h"
#include "bind/modules.h"
#include "bind/pictures.h"
#include "data/nearest.h"
#include "lua/sandbox.h"
#include "lua/state.h"

namespace cairn::scripting {

Context& drawing_context(lua_State* L) {
    Context& context = context_of(L);
    if (!context.is_drawing) call_error(L, "there is no picture to draw on; call it inside cairn.draw");
    return context;
}

engine::FontId current_font(lua_State* L) {
    const engine::FontId font = context_of(L).draw.font;
    return font.is_null() ? default_font(L) : font;
}

engine::FontId default_font(lua_State* L) {
    constexpr float kDefaultFontSize = 18;
    Context& context = context_of(L);
    if (context.default_font.is_null()) {
        context.default_font =
            value_or_raise(L, context.services.renderer.load_font("fonts/default.ttf", kDefaultFontSize));
    }
    return context.default_font;
}

namespace {

using engine::Color;
using engine::Vec2;

// ---- State

void set_color(lua_State* L, float r, float g, float b, std::optional<float> a) {
    drawing_context(L).draw.color = {r, g, b, a.value_or(1)};
}
std::tuple<float, float, float, float> color(lua_State* L) {
    const Color c = drawing_context(L).draw.color;
    return {c.r, c.g, c.b, c.a};
}
void set_line_width(lua_State* L, NotNegative width) {
    drawing_context(L).draw.line_width = width;
}
void set_blend_mode(lua_State* L, std::string_view mode) {
    engine::Renderer& renderer = drawing_context(L).services.renderer;
    if (mode == "alpha") return renderer.set_blend_mode(engine::BlendMode::Alpha);
    if (mode == "add") return renderer.set_blend_mode(engine::BlendMode::Add);
    if (mode == "multiply") return renderer.set_blend_mode(engine::BlendMode::Multiply);
    if (mode == "screen") return renderer.set_blend_mode(engine::BlendMode::Screen);
    if (mode == "replace") return renderer.set_blend_mode(engine::BlendMode::Replace);
    argument_error(L, 1, "\"alpha\", \"add\", \"multiply\", \"screen\" or \"replace\"");
}
void set_scissor(lua_State* L, std::optional<float> x, std::optional<float> y,
                 std::optional<NotNegative> width, std::optional<NotNegative> height) {
    engine::Renderer& renderer = drawing_context(L).services.renderer;
    if (!x && !y && !width && !height) return renderer.set_scissor(std::nullopt);
    if (!x || !y || !width || !height)
        call_error(L, "x, y, width and height are expected, or no argument at all");
    renderer.set_scissor(engine::Rect{*x, *y, *width, *height});
}
void clear(lua_State* L, float r, float g, float b) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    const engine::Size size = renderer.target_size();
    check_or_raise(L, renderer.push_transform());
    renderer.reset_transform();
    renderer.fill_rectangle({0, 0, static_cast<float>(size.width), static_cast<float>(size.height)},
                            {r, g, b, 1});
    check_or_raise(L, renderer.pop_transform());
}

// ---- Transforms

engine::Result<void> push(lua_State* L) {
    return drawing_context(L).services.renderer.push_transform();
}
engine::Result<void> pop(lua_State* L) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    if (!context.draw.cameras.empty()) {
        const AttachedCamera& last = context.draw.cameras.back();
        if (last.canvas == renderer.current_canvas() && renderer.transform_depth() == last.depth + 1)
            call_error(L, "there was no push since the camera was attached; detach it first");
    }
    return renderer.pop_transform();
}
void translate(lua_State* L, float x, float y) {
    drawing_context(L).services.renderer.translate({x, y});
}
void rotate(lua_State* L, float angle) {
    drawing_context(L).services.renderer.rotate(angle);
}
void scale(lua_State* L, float x, std::optional<float> y) {
    drawing_context(L).services.renderer.scale({x, y.value_or(x)});
}
void shear(lua_State* L, float x, float y) {
    drawing_context(L).services.renderer.apply_transform({1, y, x, 1, 0, 0});
}
void origin(lua_State* L) {
    drawing_context(L).services.renderer.reset_transform();
}
std::tuple<float, float> transform_point(lua_State* L, float x, float y) {
    const Vec2 p = drawing_context(L).services.renderer.transform().apply({x, y});
    return {p.x, p.y};
}
std::tuple<float, float> inverse_transform_point(lua_State* L, float x, float y) {
    const Vec2 p = drawing_context(L).services.renderer.transform().inverse().apply({x, y});
    return {p.x, p.y};
}

// ---- Images

Pushed new_image(lua_State* L, std::string_view path, std::optional<std::string_view> filter) {
    engine::Renderer& renderer = context_of(L).services.renderer;
    const engine::TextureId texture = value_or_raise(L, renderer.load_texture(path, to_filter(L, 2, filter)));
    new_object<ImageObject>(L, 0, texture);
    return {1};
}

/// The image is mirrored where y points up, so that it stands upright there too.
void draw_upright(lua_State* L, const Picture& picture, engine::ImageDraw draw) {
    Context& context = drawing_context(L);
    check_drawable(L, picture.texture);
    if (context.services.renderer.is_y_up()) draw.scale.y = -draw.scale.y;
    draw.tint = context.draw.color;
    context.services.renderer.draw_image(picture.texture, draw);
}

void draw(lua_State* L, Picture picture, float x, float y, std::optional<float> angle,
          std::optional<float> scale_x, std::optional<float> scale_y, std::optional<float> origin_x,
          std::optional<float> origin_y) {
    const float width_scale = scale_x.value_or(1);
    draw_upright(L, picture,
                 {.position = {x, y},
                  .rotation_rad = angle.value_or(0),
                  .scale = {width_scale, scale_y.value_or(width_scale)},
                  .origin = {origin_x.value_or(0), origin_y.value_or(0)},
                  .source = picture.source});
}

void draw_sized(lua_State* L, Picture picture, float x, float y, float width, float height,
                std::optional<float> angle) {
    const engine::Rect& source = picture.source;
    draw_upright(L, picture,
                 {.position = {x, y},
                  .rotation_rad = angle.value_or(0),
                  .scale = {width / source.width, height / source.height},
                  .origin = {source.width / 2, source.height / 2},
                  .source = source});
}

void draw_region(lua_State* L, Picture picture, float source_x, float source_y, Positive source_width,
                 Positive source_height, float x, float y, float width, float height,
                 std::optional<float> angle) {
    // Of a pixel: what rounding may make of parts that were computed.
    constexpr float kRounding = 0.01f;
    const engine::Rect& whole = picture.source;
    if (!(source_x >= -kRounding && source_y >= -kRounding &&
          source_x + source_width <= whole.width + kRounding &&
          source_y + source_height <= whole.height + kRounding)) {
        call_error(L, "source_x, source_y, source_width, source_height is " + describe_value(L, 2) + ", " +
                          describe_value(L, 3) + ", " + describe_value(L, 4) + ", " + describe_value(L, 5) +
                          "; it must lie inside the image, which has " +
                          std::to_string(static_cast<int>(whole.width)) + " x " +
                          std::to_string(static_cast<int>(whole.height)) + " pixels");
    }
    draw_upright(L, picture,
                 {.position = {x, y},
                  .rotation_rad = angle.value_or(0),
                  .scale = {width / source_width, height / source_height},
                  .origin = {source_width / 2, source_height / 2},
                  .source = engine::Rect{picture.source.x + source_x, picture.source.y + source_y,
                                         source_width, source_height}});
}

/// The affine map that takes three of the points, those that span the largest triangle with the first, to
/// their uvs.
std::optional<engine::Affine2> uv_map(const std::vector<Vec2>& points, const std::vector<Vec2>& uvs) {
    std::size_t best_i = 0;
    std::size_t best_j = 0;
    float best_area = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            const float area = std::abs(engine::cross(points[i] - points[0], points[j] - points[0]));
            if (area <= best_area) continue;
            best_area = area;
            best_i = i;
            best_j = j;
        }
    }
    if (best_area == 0) return std::nullopt;
    // The columns of a map are where (1, 0) and (0, 1) go; a frame maps them to two sides of the triangle.
    const auto frame = [&](const std::vector<Vec2>& p) {
        const Vec2 x = p[best_i] - p[0];
        const Vec2 y = p[best_j] - p[0];
        return engine::Affine2{x.x, x.y, y.x, y.y, p[0].x, p[0].y};
    };
    return frame(uvs) * frame(points).inverse();
}

void draw_polygon(lua_State* L, Picture picture, TableArgument points, TableArgument uvs) {
    Context& context = drawing_context(L);
    check_drawable(L, picture.texture);
    const std::vector<Vec2> corners = read_point_list(L, points, 3);
    const std::vector<Vec2> places = read_point_list(L, uvs, 3);
    if (places.size() != corners.size()) {
        call_error(L, "got " + std::to_string(corners.size()) + " points and " +
                          std::to_string(places.size()) +
                          " places in the image; one for each point is needed");
    }
    if (const auto uv_from_point = uv_map(corners, places)) {
        engine::Renderer& renderer = context.services.renderer;
        const engine::Size size = renderer.texture_size(picture.texture);
        check_or_raise(L, renderer.fill_polygon(corners, picture.texture,
                                                picture.texture_from_picture(size) * *uv_from_point,
                                                context.draw.color));
    }
}

void draw_nine_patch(lua_State* L, Picture picture, float x, float y, NotNegative width, NotNegative height,
                     NotNegative left, std::optional<NotNegative> top, std::optional<NotNegative> right,
                     std::optional<NotNegative> bottom, std::optional<Positive> scale) {
    Context& context = drawing_context(L);
    check_drawable(L, picture.texture);
    engine::NinePatchDraw patch{.area = {x, y, width, height},
                                .left = left,
                                .top = top.value_or(left),
                                .right = right.value_or(left),
                                .bottom = bottom.value_or(top.value_or(left)),
                                .scale = scale.value_or(1),
                                .source = picture.source,
                                .tint = context.draw.color};
    if (patch.left + patch.right > picture.source.width || patch.top + patch.bottom > picture.source.height)
        call_error(
            L,
            "the borders must leave room: left + right is more than the image's width, or top + bottom "
            "more than its height");
    engine::Renderer& renderer = context.services.renderer;
    if (!renderer.is_y_up()) return renderer.draw_nine_patch(picture.texture, patch);
    // Turned upside down about the area's middle, so that it stands upright.
    check_or_raise(L, renderer.push_transform());
    renderer.translate({0, 2 * y + height});
    renderer.scale({1, -1});
    renderer.draw_nine_patch(picture.texture, patch);
    check_or_raise(L, renderer.pop_transform());
}

// ---- Text

constexpr Range kFontSizes{4, 256};

Pushed new_font(lua_State* L, Ranged<kFontSizes, float> size, std::optional<std::string_view> path) {
    engine::Renderer& renderer = context_of(L).services.renderer;
    const engine::FontId font =
        value_or_raise(L, renderer.load_font(path.value_or("fonts/default.ttf"), size));
    new_object<FontObject>(L, 0, font, size);
    return {1};
}
void set_font(lua_State* L, FontObject* font) {
    drawing_context(L).draw.font = font->font;
}

void print(lua_State* L, AnyArgument text, float x, float y, std::optional<std::string_view> align,
           std::optional<NotNegative> wrap_width) {
    Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    engine::TextDraw draw{
        .position = {x, y}, .color = context.draw.color, .wrap_width = wrap_width.value_or(0)};
    const std::string_view where = align.value_or("left");
    if (where == "center") {
        draw.align = engine::TextAlign::Center;
    } else if (where == "right") {
        draw.align = engine::TextAlign::Right;
    } else if (where != "left") {
        argument_error(L, 4, "\"left\", \"center\" or \"right\"");
    }
    const engine::FontId font = current_font(L);
    push_text(L, text.index);
    std::size_t length = 0;
    const char* bytes = lua_tolstring(L, -1, &length);
    if (!renderer.is_y_up()) return renderer.draw_text(font, {bytes, length}, draw);
    // Letters keep their size in pixels under a camera.
    draw.position = renderer.transform().apply(draw.position);
    check_or_raise(L, renderer.push_transform());
    renderer.reset_transform();
    renderer.draw_text(font, {bytes, length}, draw);
    check_or_raise(L, renderer.pop_transform());
}

// ---- Bodies

void draw_one_body(lua_State* L, BodyRef body) {
    draw_body(L, drawing_context(L), body.object, body.body, body.index);
}

void draw_world(lua_State* L, WorldRef world) {
    Context& context = drawing_context(L);
    for (const physics::BodyId id : world.world.bodies()) {
        push_body(L, world.index, id);
        const auto* object = object_at<BodyObject>(L, -1);
        if (object != nullptr)
            draw_body(L, context, *object, value_or_raise(L, world.world.body(id)), lua_gettop(L));
        lua_pop(L, 1);
    }
}

// ---- Facts

std::tuple<std::int64_t, std::int64_t> size(lua_State* L) {
    const engine::Size logical = context_of(L).services.window.logical_size();
    return {logical.width, logical.height};
}
double alpha(lua_State* L) {
    return context_of(L).alpha;
}
std::tuple<std::int64_t, std::int64_t> stats(lua_State* L) {
    const engine::RenderStats& stats = context_of(L).services.renderer.stats();
    return {stats.draw_calls, stats.vertices};
}

constexpr std::array<std::string_view, 1> kReturnsImage = {"Image"};
constexpr std::array<std::string_view, 1> kReturnsFont = {"Font"};
constexpr std::array<std::string_view, 1> kReturnsCanvas = {"Canvas"};
constexpr std::array<std::string_view, 1> kReturnsQuad = {"Quad"};
constexpr std::array<std::string_view, 1> kReturnsAtlas = {"Atlas"};
constexpr std::array<std::string_view, 1> kReturnsBatch = {"Batch"};

constexpr Function kFunctions[] = {
    function<&set_color>("set_color", "r, g, b, a = 1", "",
                         "Of all that is drawn; it tints images. Starts white."),
    function<&color>("color", "", "r, g, b, a", ""),
    function<&set_line_width>("set_line_width", "width", "", "In the present units. Starts 1."),
    function<&set_blend_mode>(
        "set_blend_mode", "mode", "",
        "\"alpha\" covers, \"add\" adds light, \"multiply\" darkens, \"screen\" lightens up to white, "
        "\"replace\" takes the place of what was there, transparency too; edges mix by the share of a pixel "
        "that is covered, but are hard where a translucent color is drawn into a canvas."),
    function<&set_scissor>(
        "set_scissor", "x [px] = nil, y [px] = nil, width [px] = nil, height [px] = nil", "",
        "Only what lies inside is drawn; screen pixels, whatever the transform. Without arguments: "
        "everything."),
    function<&clear>("clear", "r, g, b", "", "Fills the picture."),
    function<&push>("push", "", "", "Remembers the transform."),
    function<&pop>("pop", "", "", "Goes back to the transform of the last push."),
    function<&translate>("translate", "x, y", "", ""),
    function<&rotate>("rotate", "angle [rad]", "", "From the x axis towards the y axis."),
    function<&scale>(
        "scale", "x, y = x", "",
        "About (0, 0). Negative factors mirror what is drawn, pictures and texts too: `scale(-1, 1)` from "
        "left to right, `scale(1, -1)` from top to bottom. Under a camera the letters of texts keep their "
        "size and the way they stand."),
    function<&shear>("shear", "x, y", "", "(1, 0) goes to (1, y), and (0, 1) to (x, 1)."),
    function<&origin>("origin", "", "",
                      "Forgets the transforms since the last push: drawing is in screen pixels."),
    function<&transform_point>("transform_point", "x, y", "x [px], y [px]",
                               "Where on the screen, or in the canvas, a point lies."),
    function<&inverse_transform_point>("inverse_transform_point", "x [px], y [px]", "x, y",
                                       "The point that is drawn there."),
    function<&rectangle>(
        "rectangle", "mode, x, y, width, height, radius = 0", "",
        "`mode` is \"fill\" or \"line\"; (x, y) is the corner of least x and y; the radius rounds the "
        "corners inward."),
    function<&circle>("circle", "mode, x, y, radius", "", ""),
    function<&ellipse>("ellipse", "mode, x, y, radius_x, radius_y", "", ""),
    function<&arc>("arc", "mode, x, y, radius, from [rad], to [rad]", "",
                   "\"fill\" draws the slice of a disc between two angles, \"line\" the arc alone."),
    function<&capsule>("capsule", "mode, x1, y1, x2, y2, radius", "", ""),
    function<&polygon>("polygon", "mode, points", "",
                       "Through points = { x1, y1, x2, y2, ... } or { {x1, y1}, {x2, y2}, ... }. It may have "
                       "dents; with \"fill\" its sides must not cross."),
    function<&line>("line", "points", "",
                    "Through all points: `line{ x1, y1, x2, y2, ... }`, `line{ {x1, y1}, {x2, y2}, ... }`, "
                    "or the numbers as "
                    "arguments, `line(x1, y1, x2, y2, ...)`."),
    function<&mesh>("mesh", "vertices, image = nil", "",
                    "Triangles without smooth edges: three vertices each, { x, y, r, g, b, a, ... }, with an "
                    "image { x, y, "
                    "r, g, b, a, u, v, ... }. For gradients."),
    function_pushing<&new_image>(
        "new_image", "path, filter = \"linear\"", "image", kReturnsImage,
        "Loads a PNG or JPEG file; the same path gives the same picture. Where it is scaled, "
        "\"linear\" mixes its pixels and \"nearest\" shows them as they are: pixel art. Wherever an image "
        "is drawn, a Canvas or a Quad can be too."),
    function_pushing<&new_canvas>("new_canvas", "width [px], height [px], filter = \"linear\"", "canvas",
                                  kReturnsCanvas,
                                  "Makes a transparent picture to draw into. Its pixels are logical ones."),
    function_pushing<&new_quad>("new_quad", "image, x [px], y [px], width [px], height [px]", "quad",
                                kReturnsQuad,
                                "A part of an image, to be drawn like one; it must lie inside."),
    function_pushing<&new_atlas>(
        "new_atlas", "path, filter = \"linear\"", "atlas", kReturnsAtlas,
        "Loads many named parts of one image: a JSON file as TexturePacker, free-tex-packer "
        "and Aseprite write them, \"hash\" or \"array\", without rotation and trimming."),
    function_pushing<&new_batch>("new_batch", "image", "batch", kReturnsBatch,
                                 "A list of sprites from one image that is drawn with one call."),
    function<&draw>(
        "draw",
        "image, x, y, angle [rad] = 0, scale_x = 1, scale_y = scale_x, origin_x [px] = 0, origin_y [px] = 0",
        "",
        "Draws an image with its origin (pixels from its top left) at (x, y). Under a camera the scale is "
        "metres per pixel of the image."),
    function<&draw_sized>("draw_sized", "image, x, y, width, height, angle [rad] = 0", "",
                          "Draws an image centred at (x, y) with a size in the present units."),
    function<&draw_region>("draw_region",
                           "image, source_x [px], source_y [px], source_width [px], source_height [px], x, "
                           "y, width, height, angle [rad] = 0",
                           "", "As draw_sized, with a part of the image."),
    function<&draw_polygon>(
        "draw_polygon", "image, points, uvs", "",
        "A polygon whose sides do not cross, { x1, y1, ... }, filled with the image; uvs = { u1, v1, ... } "
        "says which "
        "place of the image, 0 to 1 from its top left, lies at each point. The image is laid on flat: "
        "three of the points decide how."),
    function<&draw_nine_patch>(
        "draw_nine_patch",
        "image, x, y, width, height, left [px], top [px] = left, right [px] = left, bottom [px] = top, scale "
        "= 1",
        "",
        "Fills a rectangle with an image whose corners keep their size and whose sides are stretched only "
        "along "
        "themselves: frames, panels, buttons. The borders are of the image; `scale` is how large one of its "
        "pixels is drawn."),
    function_pushing<&new_font>("new_font", "size [px], path = \"fonts/default.ttf\"", "font", kReturnsFont,
                                "Loads a TrueType font."),
    function<&set_font>("set_font", "font", "", "Starts with the default font at 18 pixels."),
    function<&print>(
        "print", "text, x, y, align = \"left\", wrap_width [px] = 0", "",
        "(x, y) is the top of the text at its left, center or right, by `align`; with a wrap width, lines "
        "are "
        "broken to fit x .. x + wrap_width and aligned inside. Under a camera (x, y) is in the world and the "
        "letters keep their size in pixels."),
    function<&draw_one_body>(
        "draw_body", "body", "",
        "Draws the body's shapes between the last two steps: with `body.data.image`, an Image, "
        "Canvas or Quad spread over each shape, or `body.data.color`, {r, g, b, a?}, or a default. Not when "
        "`body.data.visible` is false."),
    function<&draw_world>("draw_world", "world", "",
                          "Draws every body, in the order of `world:bodies()`, without its sensors."),
    function<&draw_debug_world>(
        "draw_debug", "world, options = {}", "",
        "Draws what the physics works with, under the present camera: `draw_debug(world, { islands = true "
        "})`. "
        "Sleeping bodies are dark. In a window, F2 draws it over every game.",
        &kDebugDrawFields),
    function<&size>("size", "", "width [px], height [px]", "The logical size of the picture."),
    function<&alpha>("alpha", "", "alpha", "How far the picture lies between the last two updates, 0 to 1."),
    function<&stats>("stats", "", "draw_calls, vertices", "Of the picture before."),
};

// ---- Methods of Image and Font

// Asked for each time: the file may have been saved with another size since.
engine::Size size_of(lua_State* L, const ImageObject& image) {
    return context_of(L).services.renderer.texture_size(image.texture);
}
std::tuple<std::int64_t, std::int64_t> image_size(lua_State* L, ImageObject* self) {
    const engine::Size size = size_of(L, *self);
    return {size.width, size.height};
}
std::int64_t image_width(lua_State* L, ImageObject* self) {
    return size_of(L, *self).width;
}
std::int64_t image_height(lua_State* L, ImageObject* self) {
    return size_of(L, *self).height;
}

std::tuple<float, float> measure(lua_State* L, FontObject* self, AnyArgument text,
                                 std::optional<NotNegative> wrap_width) {
    push_text(L, text.index);
    std::size_t length = 0;
    const char* bytes = lua_tolstring(L, -1, &length);
    const Vec2 extent =
        context_of(L).services.renderer.measure_text(self->font, {bytes, length}, wrap_width.value_or(0));
    return {extent.x, extent.y};
}
float font_height(lua_State* L, FontObject* self) {
    return context_of(L).services.renderer.line_height(self->font);
}
float font_size(FontObject* self) {
    return self->size;
}

constexpr Function kImageFunctions[] = {
    function<&image_size>("size", "", "width [px], height [px]", ""),
    function<&image_width>("width", "", "width [px]", ""),
    function<&image_height>("height", "", "height [px]", ""),
};
constexpr Function kFontFunctions[] = {
    function<&measure>("measure", "text, wrap_width [px] = 0", "width [px], height [px]",
                       "The width of the longest line and the height of all lines."),
    function<&font_height>("height", "", "height [px]", "From the top of one line to the top of the next."),
    function<&font_size>("size", "", "size [px]", ""),
};

}  // namespace

const Module kGraphicsModule = {
    "cairn.graphics",
    "Drawing, only inside `cairn.draw` (images and fonts can be loaded and measured at any time). Color, "
    "line width, blend "
    "mode, font, scissor, transforms and camera start anew with each picture. Edges are anti-aliased. "
    "Without a camera units "
    "are logical pixels, y down, (0, 0) at the top left; under a camera they are metres, y up, and images "
    "and text stay "
    "upright.",
    kFunctions,
};
const Module kImageMethods = {"Image", "A picture that can be drawn.", kImageFunctions, true};
const Module kFontMethods = {"Font", "A typeface in one size.", kFontFunctions, true};

}  // namespace cairn::scripting
