// The functions that stand in `cairn` itself, and `require`.
#include "bind/core.h"

#include <algorithm>
#include <string>

#include "bind/callbacks.h"
#include "bind/context.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "data/nearest.h"
#include "data/table_writer.h"
#include "lua/errors.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

constexpr Field kOutcome = required_field("outcome", FieldType::String, "\"won\", \"lost\", ...");
constexpr Field kLevel = optional_field("level", FieldType::String, "");
constexpr Field kScore = optional_field("score", FieldType::Number, "");
constexpr Field kStars = integer_field("stars", 0, "", "");
constexpr const Field* kResultOwn[] = {&kOutcome, &kLevel, &kScore, &kStars};
constexpr FieldSet kResultFields{kResultOwn};

void quit(lua_State* L) {
    context_of(L).wants_quit = true;
}

void result(lua_State* L, TableArgument description) {
    const FieldReader reader(L, description.index, kResultFields);
    GameResult report;
    report.outcome = reader.text(kOutcome);
    if (reader.has(kLevel)) report.level = std::string(reader.text(kLevel));
    report.score = reader.optional_number(kScore);
    if (reader.has(kStars)) report.stars = reader.integer(kStars);
    context_of(L).result = report;
}

/// Orders keys: numbers by value, strings bytewise, false, true.
int rank_of(lua_State* L, int index) {
    switch (lua_type(L, index)) {
        case LUA_TNUMBER:
            return 0;
        case LUA_TSTRING:
            return 1;
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) != 0 ? 3 : 2;
        default:
            return -1;
    }
}

/// next for sorted_pairs: upvalue 1 is the table, 2 the sorted list of its keys, 3 the place in it.
int next_sorted(lua_State* L) {
    lua_Integer place = lua_tointeger(L, lua_upvalueindex(3));
    while (true) {
        lua_settop(L, 0);
        ++place;
        if (lua_rawgeti(L, lua_upvalueindex(2), place) == LUA_TNIL) return 1;
        lua_pushvalue(L, 1);
        // A key that the loop removed meanwhile is passed over, as `pairs` does.
        if (lua_rawget(L, lua_upvalueindex(1)) == LUA_TNIL) continue;
        lua_pushinteger(L, place);
        lua_replace(L, lua_upvalueindex(3));
        return 2;
    }
}

Pushed sorted_pairs(lua_State* L, TableArgument table) {
    struct SortKey {
        int rank;
        double number;
        std::string_view text;
        lua_Integer place;
    };
    std::vector<SortKey> keys;
    lua_settop(L, 1);
    lua_newtable(L);  // 2: the keys, unsorted; they keep the strings alive
    lua_pushnil(L);
    while (lua_next(L, table.index) != 0) {
        lua_pop(L, 1);
        const int rank = rank_of(L, -1);
        if (rank < 0) {
            call_error(
                L, "a key is " + describe_value(L, -1) +
                       "; only numbers, strings and booleans have an order that is the same in every run");
        }
        SortKey key{rank, 0, {}, static_cast<lua_Integer>(keys.size() + 1)};
        if (rank == 0) key.number = lua_tonumber(L, -1);
        if (rank == 1) {
            std::size_t length = 0;
            const char* text = lua_tolstring(L, -1, &length);
            key.text = {text, length};
        }
        keys.push_back(key);
        lua_pushvalue(L, -1);
        lua_rawseti(L, 2, keys.back().place);
    }
    std::sort(keys.begin(), keys.end(), [](const SortKey& a, const SortKey& b) {
        return std::tie(a.rank, a.number, a.text) < std::tie(b.rank, b.number, b.text);
    });
    lua_pushvalue(L, 1);
    lua_createtable(L, static_cast<int>(keys.size()), 0);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        lua_rawgeti(L, 2, keys[i].place);
        lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, next_sorted, 3);
    return {1};
}

constexpr std::array<std::string_view, 1> kReturnsIterator = {"fun(): any, any"};

constexpr Function kFunctions[] = {
    function<&quit>("quit", "", "", "Ends the game after this frame."),
    function<&result>("result", "fields", "",
                      "Reports how a level ended. Headless runs print the last report.", &kResultFields),
    function_pushing<&sorted_pairs>("sorted_pairs", "t", "iterator", kReturnsIterator,
                                    "Iterates like `pairs`, in one fixed order: numbers ascending, then "
                                    "strings bytewise, then false, true. Plain `pairs` "
                                    "visits keys that are not list indices in an order that differs between "
                                    "runs, because Lua seeds its string hash anew "
                                    "in each process; whatever that order decides would break replays. Use "
                                    "`ipairs` or `sorted_pairs` for all that "
                                    "gameplay depends on."),
};

// ---- Slips

/// __index of `cairn`: reached for callbacks, and for names that are not there.
int get_member(lua_State* L) {
    if (lua_type(L, 2) != LUA_TSTRING) return 0;
    const std::string_view name = lua_tostring(L, 2);
    if (is_callback(name)) return push_callback(L, name) ? 1 : 0;
    if (!meant_callback(name).empty()) return 0;
    std::vector<std::string> names;
    for (const Module* module : all_modules()) {
        if (!module->is_type && module != &kCoreModule) names.emplace_back(module->short_name());
    }
    for (const Function& function : kFunctions) names.emplace_back(function.name);
    if (std::find(names.begin(), names.end(), name) != names.end()) return 0;  // cairn.test outside of tests
    constexpr std::size_t kShort = 5;  // of short names too many words are near
    constexpr std::size_t kLongest = 40;
    if (name.size() > kLongest) return 0;
    const std::string* best = nullptr;
    int best_distance = name.size() <= kShort ? 2 : 3;
    for (const std::string& candidate : names) {
        const int distance = edit_distance(name, candidate);
        if (distance >= best_distance) continue;
        best = &candidate;
        best_distance = distance;
    }
    if (best == nullptr) return 0;
    raise(L, "cairn has no " + quote_text(name) + "; did you mean \"" + *best + "\"?");
}

// ---- require

constexpr const char* kLoadedModules = "cairn.loaded";

std::string module_path(lua_State* L, std::string_view name) {
    std::string path(name);
    for (const char c : name) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (!is_plain && c != '_' && c != '-' && c != '.' && c != '/') {
            raise(L,
                  "require: the module name \"" + path + "\" may hold only letters, digits, _, -, . and /");
        }
    }
    std::replace(path.begin(), path.end(), '.', '/');
    if (('/' + path + '/').find("//") != std::string::npos) {
        raise(
            L,
            "require: the module name \"" + std::string(name) +
                "\" must be names with one . or / between them, from the game's folder on, such as src.aim");
    }
    return path + ".lua";
}

int require_module(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING)
        raise(L, "require: the module is " + describe_value(L, 1) + "; expected its name");
    const std::string path = module_path(L, lua_tostring(L, 1));
    lua_settop(L, 1);
    lua_getfield(L, LUA_REGISTRYINDEX, kLoadedModules);
    lua_getfield(L, 2, path.c_str());
    if (lua_islightuserdata(L, 3))
        raise(L, "require: " + path + " requires itself, directly or through others");
    if (!lua_isnil(L, 3)) return 1;
    const auto text = context_of(L).services.files.read_text(path);
    if (!text)
        raise(L, "require: no module \"" + std::string(lua_tostring(L, 1)) + "\": " + text.error().message);
    lua_pushlightuserdata(L, L);  // marks a module that is being loaded
    lua_setfield(L, 2, path.c_str());
    if (const auto error = load_text(L, *text, path)) {
        lua_pushnil(L);
        lua_setfield(L, 2, path.c_str());
        lua_pushstring(L, error->message.c_str());
        return lua_error(L);
    }
    State::of(L).keep_source(path, *text);
    lua_pushvalue(L, 1);
    lua_call(L, 1, 1);
    if (lua_isnil(L, -1)) {
        lua_pop(L, 1);
        lua_pushboolean(L, 1);
    }
    lua_pushvalue(L, -1);
    lua_setfield(L, 2, path.c_str());
    return 1;
}

/// __newindex of `cairn`, which each assignment of a callback reaches: one that is none is told where it is
/// given, because a call by the program has no place in a script.
int set_member(lua_State* L) {
    if (lua_type(L, 2) == LUA_TSTRING && is_callback(lua_tostring(L, 2))) {
        if (!lua_isnil(L, 3) && !lua_isfunction(L, 3))
            raise(L, std::string("cairn.") + lua_tostring(L, 2) + " is " + describe_value(L, 3) +
                         "; expected a function");
        push_callbacks(L);
        lua_replace(L, 1);
    }
    lua_rawset(L, 1);
    return 0;
}

void copy_fields(lua_State* L, int from, int to) {
    for (lua_pushnil(L); lua_next(L, from) != 0; lua_pop(L, 1)) {
        lua_pushvalue(L, -2);
        lua_pushvalue(L, -2);
        lua_rawset(L, to);
    }
}

int next_member(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_settop(L, 2);
    return lua_next(L, 1) != 0 ? 2 : 0;
}

/// __pairs of `cairn`: as if callbacks stood in it. Over a copy, so that a loop may replace them.
int list_members(lua_State* L) {
    lua_settop(L, 1);
    push_callbacks(L);
    lua_newtable(L);
    copy_fields(L, 1, 3);
    copy_fields(L, 2, 3);
    lua_pushcfunction(L, next_member);
    lua_insert(L, 3);
    lua_pushnil(L);
    return 3;
}

}  // namespace

void guard_members(lua_State* L) {
    clear_callbacks(L);
    lua_createtable(L, 0, 4);
    lua_pushcfunction(L, get_member);
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, set_member);
    lua_setfield(L, -2, "__newindex");
    lua_pushcfunction(L, list_members);
    lua_setfield(L, -2, "__pairs");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
}

void forget_modules(lua_State* L) {
    State::of(L).forget_sources();
    lua_newtable(L);
    lua_setfield(L, LUA_REGISTRYINDEX, kLoadedModules);
}

void install_require(lua_State* L) {
    forget_modules(L);
    lua_pushcfunction(L, require_module);
    lua_setglobal(L, "require");
}

const Module kCoreModule = {"cairn", "The table that holds everything; a game adds its callbacks to it.",
                            kFunctions};

}  // namespace cairn::scripting
