// cairn.tween and the Tween type.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bind/context.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "bind/timers.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

struct TweenObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Tween;
    std::uint64_t number;
};

}  // namespace

template <>
struct Argument<TweenObject*> {
    static constexpr std::string_view kType = "Tween";
    static TweenObject* get(lua_State* L, int index) {
        auto* tween = object_at<TweenObject>(L, index);
        if (tween == nullptr) argument_error(L, index, "a Tween");
        return tween;
    }
};

namespace {

/// More than any game moves at once; a script that starts some in every update and never ends them meets it.
constexpr std::size_t kMaxTweens = 10000;

constexpr Field kEase{
    "ease", FieldType::String, "quad_out",
    "\"linear\", or quad, cubic, quart, quint, sine, expo, circ, back, elastic or bounce with _in, "
    "_out or _in_out: where it is slow"};
constexpr Field kDelay = at_least(number_field("delay", 0, "0", "s until it begins"), 0);
constexpr Field kRepeats =
    at_least(integer_field("repeats", 0, "0", "how often it runs again; -1: until it is cancelled"), -1);
constexpr Field kYoyo = boolean_field("yoyo", false, "every second run goes back");
constexpr Field kDone = optional_field("done", FieldType::Function, "called at the end");
constexpr const Field* kToOwn[] = {&kEase, &kDelay, &kRepeats, &kYoyo, &kDone};
constexpr FieldSet kToFields{kToOwn};

/// Forgets a tween that is over.
Tween take_out(lua_State* L, Tweens& tweens, std::map<std::uint64_t, Tween>::iterator place) {
    Tween tween = std::move(place->second);
    tweens.running.erase(place);
    luaL_unref(L, LUA_REGISTRYINDEX, tween.target);
    return tween;
}

void drop(lua_State* L, Tweens& tweens, std::map<std::uint64_t, Tween>::iterator place) {
    luaL_unref(L, LUA_REGISTRYINDEX, take_out(L, tweens, place).done);
}

/// Ends what older tweens do to fields that a new one moves.
void take_over(lua_State* L, Tweens& tweens, const Tween& newer) {
    for (auto place = tweens.running.begin(); place != tweens.running.end();) {
        const auto older = place++;
        if (older->second.identity != newer.identity) continue;
        std::erase_if(older->second.fields, [&](const TweenField& field) {
            for (const TweenField& taken : newer.fields)
                if (taken.name == field.name) return true;
            return false;
        });
        if (older->second.fields.empty()) drop(L, tweens, older);
    }
}

std::vector<TweenField> read_goals(lua_State* L, int index) {
    std::vector<TweenField> fields;
    lua_pushnil(L);
    while (lua_next(L, index) != 0) {
        if (lua_type(L, -2) != LUA_TSTRING)
            call_error(L, "the key " + describe_value(L, -2) + " of goals is not a name");
        const std::string name = lua_tostring(L, -2);
        if (lua_type(L, -1) != LUA_TNUMBER || !std::isfinite(lua_tonumber(L, -1)))
            call_error(L, "goals." + name + " is " + describe_value(L, -1) + "; expected a finite number");
        fields.push_back({name, lua_tonumber(L, -1), 0});
        lua_pop(L, 1);
    }
    if (fields.empty()) call_error(L, "goals is empty; expected fields with numbers");
    // lua_next has no fixed order.
    std::sort(fields.begin(), fields.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return fields;
}

Pushed to(lua_State* L, TableArgument target, TableArgument goals, Seconds seconds,
          std::optional<TableArgument> options) {
    if (!options) lua_newtable(L);
    const FieldReader reader(L, options ? options->index : -1, kToFields);
    Context& context = context_of(L);
    Tweens& tweens = context.tweens;
    if (tweens.running.size() >= kMaxTweens)
        call_error(L, std::to_string(kMaxTweens) +
                          " tweens are running already; cancel those that are no longer needed");

    Tween tween;
    tween.fields = read_goals(L, goals.index);
    const auto ease = ease_from_name(reader.text(kEase));
    if (!ease) reader.fail(kEase, no_such_ease(reader.text(kEase)));
    tween.ease = *ease;
    const std::int64_t repeats = reader.integer(kRepeats);
    const double delay = reader.number(kDelay);
    const bool is_yoyo = reader.boolean(kYoyo);
    // A field that is no number shows here, where the script's own line is named.
    for (const TweenField& field : tween.fields) {
        lua_getfield(L, target.index, field.name.c_str());
        if (lua_type(L, -1) != LUA_TNUMBER)
            call_error(L, "target." + field.name + " is " + describe_value(L, -1) + "; expected a number");
        lua_pop(L, 1);
    }
    tween.begin = context.frame + (delay > 0 ? context.frames_of(delay) : 0);
    tween.frames = context.frames_of(seconds);
    tween.ways = static_cast<std::uint64_t>(repeats + 1);
    tween.is_yoyo = is_yoyo;
    tween.identity = lua_topointer(L, target.index);
    take_over(L, tweens, tween);

    if (reader.push(kDone)) tween.done = luaL_ref(L, LUA_REGISTRYINDEX);
    lua_pushvalue(L, target.index);
    tween.target = luaL_ref(L, LUA_REGISTRYINDEX);
    luaL_where(L, 1);
    tween.place = lua_tostring(L, -1);
    lua_pop(L, 1);
    const std::uint64_t number = ++tweens.made;
    tweens.running.emplace(number, std::move(tween));
    new_object<TweenObject>(L, 0, number);
    return {1};
}

void cancel_all(lua_State* L, TableArgument target) {
    Tweens& tweens = context_of(L).tweens;
    const void* identity = lua_topointer(L, target.index);
    for (auto place = tweens.running.begin(); place != tweens.running.end();) {
        const auto tween = place++;
        if (tween->second.identity == identity) drop(L, tweens, tween);
    }
}

double ease_value(lua_State* L, std::string_view name, double t) {
    const auto ease = ease_from_name(name);
    if (!ease) call_error(L, "name is " + quote_text(name) + ": " + no_such_ease(name));
    return eased(*ease, t);
}

void cancel(lua_State* L, TweenObject* self) {
    Tweens& tweens = context_of(L).tweens;
    if (const auto place = tweens.running.find(self->number); place != tweens.running.end())
        drop(L, tweens, place);
}
bool is_active(lua_State* L, TweenObject* self) {
    return context_of(L).tweens.running.contains(self->number);
}

/// How far a tween is, and whether that is its end.
struct Progress {
    double share;
    bool is_over;
};
Progress progress_of(const Tween& tween, std::uint64_t frame) {
    const std::uint64_t passed = frame - tween.begin;
    std::uint64_t way = passed / tween.frames;
    double t = static_cast<double>(passed % tween.frames) / static_cast<double>(tween.frames);
    const bool is_over = tween.ways > 0 && way >= tween.ways;
    if (is_over || (t == 0 && passed > 0)) {
        // The end of a way is that way's, not the start of the next.
        way = (is_over ? tween.ways : way) - 1;
        t = 1;
    }
    const double share = eased(tween.ease, t);
    return {tween.is_yoyo && way % 2 == 1 ? 1 - share : share, is_over};
}

/// Of the target on top of the stack. The tween ends where the field is no number any more.
double number_in(lua_State* L, Tweens& tweens, std::uint64_t number, const TweenField& field) {
    lua_getfield(L, -1, field.name.c_str());
    const auto place = tweens.running.find(number);
    if (lua_type(L, -1) != LUA_TNUMBER && place != tweens.running.end()) {
        const std::string start = place->second.place;
        drop(L, tweens, place);
        raise(L, start + "target." + field.name + " of the tween that is started here is " +
                     describe_value(L, -1) + " by now; expected a number");
    }
    const double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
}

constexpr std::array<std::string_view, 1> kReturnsTween = {"Tween"};

constexpr Function kFunctions[] = {
    function_pushing<&to>("to", "target, goals, seconds [s], fields = {}", "tween", kReturnsTween,
                          "Moves number fields of a table to goals: `cairn.tween.to(menu, { y = 100, alpha = "
                          "1 }, 0.4)`. It starts from "
                          "the values at its beginning. A newer tween of the same field takes it over. A "
                          "field that is no number any more ends it with an error.",
                          &kToFields),
    function<&cancel_all>("cancel_all", "target", "", "Ends all tweens of a table where they are."),
    function<&ease_value>("ease", "name, t", "share", "What a curve makes of t, 0 to 1."),
};
constexpr Function kMethods[] = {
    function<&cancel>("cancel", "", "", "Ends it where it is; `done` is not called."),
    function<&is_active>("is_active", "", "active", "Whether it waits or moves."),
};

}  // namespace

int run_tweens(lua_State* L) {
    Context& context = context_of(L);
    Tweens& tweens = context.tweens;
    // By number and not by place: what is called at an end may start and cancel tweens.
    std::uint64_t number = 0;
    for (auto place = tweens.running.begin(); place != tweens.running.end();
         place = tweens.running.upper_bound(number)) {
        number = place->first;
        if (context.frame <= place->second.begin) continue;
        Tween& tween = place->second;
        lua_rawgeti(L, LUA_REGISTRYINDEX, tween.target);
        const Progress progress = progress_of(tween, context.frame);
        // Copied: a metamethod of the target may cancel the tween.
        std::vector<TweenField> fields = tween.fields;
        if (!std::exchange(tween.has_begun, true)) {
            for (TweenField& field : fields) field.start = number_in(L, tweens, number, field);
            if (const auto same = tweens.running.find(number); same != tweens.running.end())
                same->second.fields = fields;
        }
        for (const TweenField& field : fields) {
            number_in(L, tweens, number, field);  // the script may have made it something else
            // Exactly the goal at the end, whatever the rounding on the way.
            const double value =
                progress.share == 1 ? field.goal : field.start + (field.goal - field.start) * progress.share;
            lua_pushnumber(L, value);
            lua_setfield(L, -2, field.name.c_str());
        }
        lua_pop(L, 1);
        const auto still = tweens.running.find(number);
        if (!progress.is_over || still == tweens.running.end()) continue;
        const int done = take_out(L, tweens, still).done;
        if (done == LUA_NOREF) continue;
        lua_rawgeti(L, LUA_REGISTRYINDEX, done);
        luaL_unref(L, LUA_REGISTRYINDEX, done);
        lua_call(L, 0, 0);
    }
    return 0;
}

const Module kTweenModule = {"cairn.tween",
                             "Smooth movements of values, in game time: menus that slide, lights that fade, "
                             "doors that open. Tweens run after "
                             "timers and before `cairn.update`.",
                             kFunctions};
const Module kTweenMethods = {"Tween", "A movement of values.", kMethods, true};

}  // namespace cairn::scripting
