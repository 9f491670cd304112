// Lists of sprites from one texture. Invariant: all sprites of a batch show the same texture, so that a batch
// is one draw call, however many there are.
#include <vector>

#include "bind/modules.h"
#include "bind/pictures.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// Far beyond what can be drawn in time; a script that adds and never clears meets it.
constexpr std::size_t kMaxSprites = 1'000'000;

/// User value 1 is the image.
struct BatchObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Batch;
    Picture picture;
    engine::Color color;
    std::vector<engine::ImageDraw> sprites;
};

}  // namespace

template <>
struct Argument<BatchObject*> {
    static constexpr std::string_view kType = "Batch";
    static BatchObject* get(lua_State* L, int index) {
        auto* batch = object_at<BatchObject>(L, index);
        if (batch == nullptr) argument_error(L, index, "a Batch");
        return batch;
    }
};

Pushed new_batch(lua_State* L, Picture image) {
    new_object<BatchObject>(L, 1, image, engine::Color{}, std::vector<engine::ImageDraw>{});
    lua_pushvalue(L, 1);
    lua_setiuservalue(L, -2, 1);
    return {1};
}

int finalize_batch(lua_State* L) {
    object_at<BatchObject>(L, 1)->~BatchObject();
    return 0;
}

namespace {

std::int64_t append(lua_State* L, BatchObject& batch, const engine::ImageDraw& sprite) {
    if (batch.sprites.size() >= kMaxSprites)
        call_error(
            L, "the batch holds " + std::to_string(kMaxSprites) + " sprites already; is a clear missing?");
    const std::size_t capacity = batch.sprites.capacity();
    batch.sprites.push_back(sprite);
    charge_growth(L, batch.sprites, capacity);
    return static_cast<std::int64_t>(batch.sprites.size());
}

void check_texture(lua_State* L, const BatchObject& batch, const Picture& picture) {
    if (picture.texture != batch.picture.texture)
        call_error(L, "the quad is a part of another image than that of the batch");
}

std::int64_t add(lua_State* L, BatchObject* self, float x, float y, std::optional<float> angle,
                 std::optional<float> scale_x, std::optional<float> scale_y, std::optional<float> origin_x,
                 std::optional<float> origin_y, std::optional<Picture> picture) {
    if (picture) check_texture(L, *self, *picture);
    const float scale = scale_x.value_or(1);
    return append(L, *self,
                  {.position = {x, y},
                   .rotation_rad = angle.value_or(0),
                   .scale = {scale, scale_y.value_or(scale)},
                   .origin = {origin_x.value_or(0), origin_y.value_or(0)},
                   .source = picture.value_or(self->picture).source,
                   .tint = self->color});
}

void add_bodies(lua_State* L, BatchObject* self, WorldRef world, TableArgument quads, float scale) {
    const double alpha = context_of(L).alpha;
    for (const physics::BodyId id : world.world.bodies()) {
        push_body(L, world.index, id);
        lua_rawget(L, quads.index);
        if (lua_isnil(L, -1)) {
            lua_pop(L, 1);
            continue;
        }
        // Their index on the stack means nothing to the author, so what is wrong is said here.
        const auto* quad = object_at<QuadObject>(L, -1);
        const bool is_whole = lua_isboolean(L, -1) && lua_toboolean(L, -1) != 0;
        if (quad == nullptr && !is_whole)
            call_error(L, "the values of quads must be Quads, or true for the whole image");
        const Picture picture = quad != nullptr ? Picture{quad->texture, quad->source} : self->picture;
        check_texture(L, *self, picture);
        lua_pop(L, 1);
        const physics::Transform xf =
            value_or_raise(L, world.world.body(id)).interpolated_transform(static_cast<float>(alpha));
        append(L, *self,
               {.position = {static_cast<float>(xf.p.x), static_cast<float>(xf.p.y)},
                .rotation_rad = xf.q.angle_rad(),
                .scale = {scale, scale},
                .origin = {picture.source.width / 2, picture.source.height / 2},
                .source = picture.source,
                .tint = self->color});
    }
}

void set_color(BatchObject* self, float r, float g, float b, std::optional<float> a) {
    self->color = {r, g, b, a.value_or(1)};
}
void clear(BatchObject* self) {
    self->sprites.clear();
}
std::int64_t count(BatchObject* self) {
    return static_cast<std::int64_t>(self->sprites.size());
}

void draw(lua_State* L, BatchObject* self) {
    engine::Renderer& renderer = drawing_context(L).services.renderer;
    check_drawable(L, self->picture.texture);
    const float upright = renderer.is_y_up() ? -1.0f : 1.0f;
    for (engine::ImageDraw sprite : self->sprites) {
        sprite.scale.y *= upright;
        renderer.draw_image(self->picture.texture, sprite);
    }
}

constexpr Function kFunctions[] = {
    function<&add>(
        "add",
        "x, y, angle [rad] = 0, scale_x = 1, scale_y = scale_x, origin_x [px] = 0, origin_y [px] = 0, quad = "
        "nil",
        "index",
        "Adds a sprite, placed as cairn.graphics.draw places images: the whole image, or the quad, which "
        "must be a part of it."),
    function<&add_bodies>(
        "add_bodies", "world, quads, scale", "",
        "Adds a sprite for each body of the world that is a key of `quads`, where it is between the last two "
        "steps: the Quad that is its value, or the whole image for `true`. `scale` is metres per pixel of "
        "the image."),
    function<&set_color>("set_color", "r, g, b, a = 1", "", "Tints what is added from here on."),
    function<&clear>("clear", "", "", "Takes all sprites out."),
    function<&count>("count", "", "count", "How many sprites it holds."),
    function<&draw>("draw", "", "", "Draws all of it in the order of adding; only in `cairn.draw`."),
};

}  // namespace

const Module kBatchMethods = {"Batch", "Sprites from one image, drawn with one call.", kFunctions, true};

}  // namespace cairn::scripting
