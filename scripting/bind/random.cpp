// cairn.random, the Random type, and math.random on top of the gameplay stream.
#include <cmath>

#include <cairn/engine/random.h>
#include <cairn/physics/math.h>

#include "bind/context.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// A generator of a script's own, or the visual one of the context.
struct RandomObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Random;
    engine::Random own;
    engine::Random* shared;  ///< null: `own` is used

    engine::Random& generator() { return shared != nullptr ? *shared : own; }
};

}  // namespace

template <>
struct Argument<RandomObject*> {
    static constexpr std::string_view kType = "Random";
    static RandomObject* get(lua_State* L, int index) {
        auto* random = object_at<RandomObject>(L, index);
        if (random == nullptr) argument_error(L, index, "a Random");
        return random;
    }
};

namespace {

using Probability = Ranged<kShare, double>;
using Deviation = Ranged<kNotNegative, double>;

/// `low` and `high` are the last two arguments.
[[noreturn]] void interval_error(lua_State* L, const char* rule) {
    call_error(L, "low is " + describe_value(L, -2) + " and high is " + describe_value(L, -1) +
                      "; expected " + rule);
}

double number_from(lua_State* L, engine::Random& random, double low, double high) {
    if (!(low <= high) || !std::isfinite(high - low))
        interval_error(L, "low <= high, and no more than 1.8e308 between them");
    return random.uniform(low, high);
}

std::int64_t integer_from(lua_State* L, engine::Random& random, std::int64_t low, std::int64_t high) {
    if (low > high) interval_error(L, "low <= high");
    return random.range(low, high);
}

/// Source: G. Marsaglia, T. A. Bray, "A Convenient Method for Generating Normal Variables", 1964 (polar
/// method).
double normal_from(engine::Random& random, double mean, double deviation) {
    while (true) {
        const double u = random.uniform(-1, 1);
        const double v = random.uniform(-1, 1);
        const double s = u * u + v * v;
        if (s > 0 && s < 1) return mean + deviation * u * std::sqrt(-2 * physics::deterministic::log(s) / s);
    }
}

Pushed choose_from(lua_State* L, engine::Random& random, TableArgument list) {
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, list.index));
    if (count == 0) call_error(L, "the list is empty");
    lua_rawgeti(L, list.index, random.range(1, count));
    return {1};
}

/// Source: R. Durstenfeld, "Algorithm 235: Random permutation", 1964.
void shuffle_with(lua_State* L, engine::Random& random, TableArgument list) {
    for (auto i = static_cast<lua_Integer>(lua_rawlen(L, list.index)); i > 1; --i) {
        const lua_Integer other = random.range(1, i);
        lua_rawgeti(L, list.index, i);
        lua_rawgeti(L, list.index, other);
        lua_rawseti(L, list.index, i);
        lua_rawseti(L, list.index, other);
    }
}

double uniform(lua_State* L) {
    return context_of(L).random.uniform();
}
double number(lua_State* L, double low, double high) {
    return number_from(L, context_of(L).random, low, high);
}
std::int64_t integer(lua_State* L, std::int64_t low, std::int64_t high) {
    return integer_from(L, context_of(L).random, low, high);
}
double normal(lua_State* L, std::optional<double> mean, std::optional<Deviation> deviation) {
    return normal_from(context_of(L).random, mean.value_or(0), deviation.value_or(1));
}
bool chance(lua_State* L, Probability probability) {
    return context_of(L).random.uniform() < probability;
}
Pushed choose(lua_State* L, TableArgument list) {
    return choose_from(L, context_of(L).random, list);
}
void shuffle(lua_State* L, TableArgument list) {
    shuffle_with(L, context_of(L).random, list);
}
void seed(lua_State* L, std::int64_t seed) {
    context_of(L).random = engine::Random(static_cast<std::uint64_t>(seed));
}
Pushed new_random(lua_State* L, std::int64_t seed) {
    new_object<RandomObject>(L, 0, engine::Random(static_cast<std::uint64_t>(seed)), nullptr);
    return {1};
}

double self_uniform(RandomObject* self) {
    return self->generator().uniform();
}
double self_number(lua_State* L, RandomObject* self, double low, double high) {
    return number_from(L, self->generator(), low, high);
}
std::int64_t self_integer(lua_State* L, RandomObject* self, std::int64_t low, std::int64_t high) {
    return integer_from(L, self->generator(), low, high);
}
double self_normal(RandomObject* self, std::optional<double> mean, std::optional<Deviation> deviation) {
    return normal_from(self->generator(), mean.value_or(0), deviation.value_or(1));
}
bool self_chance(RandomObject* self, Probability probability) {
    return self->generator().uniform() < probability;
}
Pushed self_choose(lua_State* L, RandomObject* self, TableArgument list) {
    return choose_from(L, self->generator(), list);
}
void self_shuffle(lua_State* L, RandomObject* self, TableArgument list) {
    shuffle_with(L, self->generator(), list);
}
void self_seed(RandomObject* self, std::int64_t seed) {
    self->generator() = engine::Random(static_cast<std::uint64_t>(seed));
}

constexpr std::array<std::string_view, 1> kReturnsRandom = {"Random"};
constexpr std::array<std::string_view, 1> kReturnsAny = {"any"};

constexpr Function kFunctions[] = {
    function<&uniform>("uniform", "", "number", "In [0, 1)."),
    function<&number>("number", "low, high", "number", "In [low, high)."),
    function<&integer>("integer", "low, high", "integer",
                       "In [low, high], both included, all equally likely."),
    function<&normal>("normal", "mean = 0, deviation = 1", "number",
                      "Normally distributed: most lie near the mean."),
    function<&chance>("chance", "probability", "happens", "True with that probability."),
    function_pushing<&choose>("choose", "list", "member", kReturnsAny,
                              "One of a list's members, all equally likely."),
    function<&shuffle>("shuffle", "list", "",
                       "Brings the members of a list into a random order, all equally likely."),
    function<&seed>("seed", "seed", "", "Starts the stream anew."),
    function_pushing<&new_random>("new", "seed", "random", kReturnsRandom,
                                  "A generator of its own; it is not part of the state hash."),
};
constexpr Function kMethods[] = {
    function<&self_uniform>("uniform", "", "number", "In [0, 1)."),
    function<&self_number>("number", "low, high", "number", "In [low, high)."),
    function<&self_integer>("integer", "low, high", "integer", "In [low, high], both included."),
    function<&self_normal>("normal", "mean = 0, deviation = 1", "number", "Normally distributed."),
    function<&self_chance>("chance", "probability", "happens", "True with that probability."),
    function_pushing<&self_choose>("choose", "list", "member", kReturnsAny, "One of a list's members."),
    function<&self_shuffle>("shuffle", "list", "", "Brings the members of a list into a random order."),
    function<&self_seed>("seed", "seed", "", "Starts the stream anew."),
};

// ---- math.random: the arguments of Lua's own, the numbers of the gameplay stream.

int math_random(lua_State* L) {
    engine::Random& random = context_of(L).random;
    const int count = lua_gettop(L);
    if (count == 0) {
        lua_pushnumber(L, random.uniform());
        return 1;
    }
    const lua_Integer low = count == 1 ? 1 : luaL_checkinteger(L, 1);
    const lua_Integer high = luaL_checkinteger(L, count == 1 ? 1 : 2);
    if (count > 2) return luaL_error(L, "math.random: got %d arguments; expected at most 2", count);
    if (count == 1 && high == 0) {
        lua_pushinteger(L, static_cast<lua_Integer>(random.next_u64()));
        return 1;
    }
    if (low > high) return luaL_error(L, "math.random: the interval from %I to %I is empty", low, high);
    lua_pushinteger(L, random.range(low, high));
    return 1;
}

int math_randomseed(lua_State* L) {
    if (lua_gettop(L) == 0)
        return luaL_error(L, "math.randomseed: expected a seed; a random one would break replays");
    context_of(L).random = engine::Random(static_cast<std::uint64_t>(luaL_checkinteger(L, 1)));
    return 0;
}

}  // namespace

void install_random(lua_State* L) {
    new_object<RandomObject>(L, 0, engine::Random(), &context_of(L).visual_random);
    lua_setfield(L, -2, "visual");
    lua_getglobal(L, "math");
    lua_pushcfunction(L, math_random);
    lua_setfield(L, -2, "random");
    lua_pushcfunction(L, math_randomseed);
    lua_setfield(L, -2, "randomseed");
    lua_pop(L, 1);
}

const Module kRandomModule = {
    "cairn.random",
    "The gameplay stream: seeded by `--seed`, recorded in replays, part of the state hash; `math.random` and "
    "`math.randomseed` use it too. `cairn.random.visual` is a Random for what decides nothing (sparks, "
    "pitch): "
    "`cairn.random.visual:uniform()`.",
    kFunctions};
const Module kRandomMethods = {"Random", "A generator of random numbers.", kMethods, true};

}  // namespace cairn::scripting
