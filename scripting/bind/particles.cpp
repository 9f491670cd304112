// cairn.particles and the methods of Particles.
#include <cairn/engine/particles.h>

#include "bind/fields.h"
#include "bind/graphics_objects.h"
#include "bind/modules.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// User value 1 is the image, if it has one.
struct ParticlesObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Particles;
    engine::ParticleSystem system;
    engine::TextureId texture;
    engine::Rect source;
    engine::BlendMode blend;
};

}  // namespace

template <>
struct Argument<ParticlesObject*> {
    static constexpr std::string_view kType = "Particles";
    static ParticlesObject* get(lua_State* L, int index) {
        auto* particles = object_at<ParticlesObject>(L, index);
        if (particles == nullptr) argument_error(L, index, "a Particles");
        return particles;
    }
};

namespace {

/// What a frame can draw; more stand still on most machines.
constexpr double kMostParticles = 100000;

constexpr Field kMaxCount =
    within(integer_field("max_count", 1000, "1000", "how many may live"), 1, kMostParticles);
constexpr Range kRates{0, 1e6};
constexpr Field kRate =
    within(number_field("rate", 0, "0", "1/s; born per second while it is started"), kRates);
constexpr Field kX = number_field("x", 0, "0", "where they are born");
constexpr Field kY = number_field("y", 0, "0", "");
constexpr Field kAreaWidth =
    at_least(number_field("area_width", 0, "0", "of the rectangle in which they are born"), 0);
constexpr Field kAreaHeight = at_least(number_field("area_height", 0, "0", ""), 0);
constexpr Field kLifetime = above(number_field("lifetime", 1, "1", "s"), 0, 1e6);
constexpr Field kLifetimeMax =
    optional_field("lifetime_max", FieldType::Number, "s; with it, any between the two");
constexpr Field kSpeed = number_field("speed", 0, "0", "per second");
constexpr Field kSpeedMax = optional_field("speed_max", FieldType::Number, "with it, any between the two");
constexpr Field kDirection = number_field("direction", 0, "0", "rad, from the x axis towards the y axis");
constexpr Field kSpread =
    number_field("spread", 6.28318530717958648, "2 * math.pi", "rad, around the direction");
constexpr Field kAccelerationX = number_field("acceleration_x", 0, "0", "per second squared");
constexpr Field kAccelerationY = number_field("acceleration_y", 0, "0", "");
constexpr Field kDamping = at_least(number_field("damping", 0, "0", "1/s; c in v e^(-c t)"), 0);
constexpr Field kSize = at_least(number_field("size", 8, "8", "at birth"), 0);
constexpr Field kSizeMax = optional_field("size_max", FieldType::Number, "with it, any between the two");
constexpr Field kSizeEnd =
    at_least(optional_field("size_end", FieldType::Number, "at the end; absent: as at birth"), 0);
constexpr Field kRotation = number_field("rotation", 0, "0", "rad, at birth");
constexpr Field kRotationMax =
    optional_field("rotation_max", FieldType::Number, "rad; with it, any between the two");
constexpr Field kSpin = number_field("spin", 0, "0", "rad/s");
constexpr Field kSpinMax =
    optional_field("spin_max", FieldType::Number, "rad/s; with it, any between the two");
constexpr Field kColors = optional_field(
    "colors", FieldType::Table, "{ {r, g, b, a?}, ... } over the lifetime, evenly; absent: white that fades");
constexpr Field kBlend{"blend", FieldType::String, "alpha", "\"alpha\" or \"add\""};
constexpr const Field* kOwn[] = {
    &kMaxCount,      &kRate,          &kX,       &kY,        &kAreaWidth, &kAreaHeight,
    &kLifetime,      &kLifetimeMax,   &kSpeed,   &kSpeedMax, &kDirection, &kSpread,
    &kAccelerationX, &kAccelerationY, &kDamping, &kSize,     &kSizeMax,   &kSizeEnd,
    &kRotation,      &kRotationMax,   &kSpin,    &kSpinMax,  &kColors,    &kBlend};
constexpr FieldSet kParticleFields{kOwn};

engine::Range range(const FieldReader& reader, const Field& low, const Field& high) {
    const float from = reader.real(low);
    const std::optional<double> to = reader.optional_number(high);
    if (to && !(*to >= static_cast<double>(from)))
        reader.fail(high, std::string("must be at least ") + low.name);
    return {from, to ? static_cast<float>(*to) : from};
}

std::vector<engine::Color> read_colors(lua_State* L, const FieldReader& reader) {
    if (!reader.push(kColors)) return {{1, 1, 1, 1}, {1, 1, 1, 0}};
    constexpr std::size_t kMostColors = 16;
    std::vector<engine::Color> colors;
    const std::size_t count = lua_rawlen(L, -1);
    if (count < 1 || count > kMostColors) reader.fail(kColors, "must have 1 to 16 colors");
    for (std::size_t i = 1; i <= count; ++i) {
        lua_rawgeti(L, -1, static_cast<lua_Integer>(i));
        engine::Color color;
        float* const parts[] = {&color.r, &color.g, &color.b, &color.a};
        for (int k = 0; k < 4; ++k) {
            if (!lua_istable(L, -1)) break;
            lua_rawgeti(L, -1, k + 1);
            const bool is_number = lua_type(L, -1) == LUA_TNUMBER;
            if (is_number) *parts[k] = static_cast<float>(lua_tonumber(L, -1));
            lua_pop(L, 1);
            if (!is_number && k < 3) {
                lua_pushnil(L);  // not a color
                lua_replace(L, -2);
                break;
            }
        }
        if (!lua_istable(L, -1))
            call_error(L, "colors[" + std::to_string(i) +
                              "] must be {r, g, b} or {r, g, b, a} with numbers from 0 to 1");
        lua_pop(L, 1);
        colors.push_back(color);
    }
    lua_pop(L, 1);
    return colors;
}

Pushed new_particles(lua_State* L, std::optional<TableArgument> fields, std::optional<Picture> image) {
    if (!fields) lua_newtable(L);
    const FieldReader reader(L, fields ? fields->index : -1, kParticleFields);
    const std::string_view blend = reader.text(kBlend);
    if (blend != "alpha" && blend != "add") reader.fail(kBlend, "must be \"alpha\" or \"add\"");
    engine::ParticleDef def{.max_count = static_cast<int>(reader.integer(kMaxCount)),
                            .rate_1_s = reader.real(kRate),
                            .lifetime_s = range(reader, kLifetime, kLifetimeMax),
                            .area = {reader.real(kAreaWidth), reader.real(kAreaHeight)},
                            .speed = range(reader, kSpeed, kSpeedMax),
                            .direction_rad = reader.real(kDirection),
                            .spread_rad = reader.real(kSpread),
                            .acceleration = {reader.real(kAccelerationX), reader.real(kAccelerationY)},
                            .damping_1_s = reader.real(kDamping),
                            .size_start = range(reader, kSize, kSizeMax),
                            .rotation_rad = range(reader, kRotation, kRotationMax),
                            .spin_rad_s = range(reader, kSpin, kSpinMax),
                            .colors = read_colors(L, reader)};
    const std::optional<double> end = reader.optional_number(kSizeEnd);
    def.size_end = end ? engine::Range{static_cast<float>(*end), static_cast<float>(*end)} : def.size_start;
    const engine::Vec2 place{reader.real(kX), reader.real(kY)};

    Context& context = context_of(L);
    // From the visual stream: particles decide nothing, and must not shift what gameplay draws.
    engine::ParticleSystem system(std::move(def), context.visual_random.next_u64());
    system.set_position(place);
    Picture picture;
    if (image) {
        picture = *image;
    } else {
        engine::Renderer& renderer = context.services.renderer;
        picture.texture = value_or_raise(L, renderer.soft_disc());
        const engine::Size size = renderer.texture_size(picture.texture);
        picture.source = {0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
    }
    const std::size_t bytes = system.most_bytes();
    new_object<ParticlesObject>(L, 1, std::move(system), picture.texture, picture.source,
                                blend == "add" ? engine::BlendMode::Add : engine::BlendMode::Alpha);
    charge_native_memory(L, bytes);
    if (image) {
        lua_pushvalue(L, 2);
        lua_setiuservalue(L, -2, 1);
    }
    return {1};
}

void emit(ParticlesObject* self, Count count, std::optional<float> x, std::optional<float> y) {
    const engine::Vec2 here = self->system.position();
    self->system.emit(static_cast<int>(std::min<std::int64_t>(count, 1 << 20)),
                      {x.value_or(here.x), y.value_or(here.y)});
}
void start(ParticlesObject* self) {
    self->system.set_started(true);
}
void stop(ParticlesObject* self) {
    self->system.set_started(false);
}
bool is_active(ParticlesObject* self) {
    return self->system.is_started() || self->system.count() > 0;
}
std::int64_t count(ParticlesObject* self) {
    return self->system.count();
}
void clear(ParticlesObject* self) {
    self->system.clear();
}
std::tuple<float, float> position(ParticlesObject* self) {
    return {self->system.position().x, self->system.position().y};
}
void set_position(ParticlesObject* self, float x, float y) {
    self->system.set_position({x, y});
}
void set_direction(ParticlesObject* self, float direction_rad) {
    self->system.set_direction(direction_rad);
}
void set_rate(ParticlesObject* self, Ranged<kRates, float> rate) {
    self->system.set_rate(rate);
}
void update(ParticlesObject* self, StepTime dt) {
    self->system.update(dt);
}
void draw(lua_State* L, ParticlesObject* self) {
    Context& context = drawing_context(L);
    check_drawable(L, self->texture);
    engine::Renderer& renderer = context.services.renderer;
    const engine::BlendMode before = renderer.blend_mode();
    renderer.set_blend_mode(self->blend);
    self->system.draw(renderer, self->texture, self->source, context.draw.color,
                      static_cast<float>(context.alpha));
    renderer.set_blend_mode(before);
}

constexpr std::array<std::string_view, 1> kReturnsParticles = {"Particles"};

constexpr Function kModuleFunctions[] = {
    function_pushing<&new_particles>(
        "new", "fields = {}, image = nil", "particles", kReturnsParticles,
        "Makes an emitter, which is stopped. Each particle is a square of the image, or a "
        "soft disc. Lengths are in the units it is drawn in: pixels, or metres under a "
        "camera.",
        &kParticleFields),
};
constexpr Function kMethods[] = {
    function<&emit>("emit", "count, x = nil, y = nil", "",
                    "That many at once, where it stands or at (x, y)."),
    function<&start>("start", "", "", "From now on `rate` are born per second."),
    function<&stop>("stop", "", "", "None are born any more; those that live go on."),
    function<&is_active>("is_active", "", "active", "Whether it is started, or some still live."),
    function<&count>("count", "", "count", "How many live."),
    function<&clear>("clear", "", "", "Takes all away."),
    function<&position>("position", "", "x, y", ""),
    function<&set_position>("set_position", "x, y", "", "Where the next ones are born."),
    function<&set_direction>("set_direction", "direction [rad]", "",
                             "Where the next ones fly, as the flame of a rocket that turns."),
    function<&set_rate>("set_rate", "rate [1/s]", "", "How many are born per second from now on."),
    function<&update>("update", "dt [s]", "", "Moves them on; once per update."),
    function<&draw>("draw", "", "",
                    "All with one draw call, tinted by the color that is set; only in `cairn.draw`."),
};

}  // namespace

int finalize_particles(lua_State* L) {
    object_at<ParticlesObject>(L, 1)->~ParticlesObject();
    return 0;
}

const Module kParticlesModule = {"cairn.particles",
                                 "Sparks, smoke, rain, dust. They use the visual random numbers and decide "
                                 "nothing, so gameplay must not ask them.",
                                 kModuleFunctions};
const Module kParticlesMethods = {"Particles", "An emitter and what it has emitted.", kMethods, true};

}  // namespace cairn::scripting
