// cairn.data: data files checked by schemas that are Lua tables.
#include <algorithm>
#include <cmath>

#include "bind/context.h"
#include "bind/data_values.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "data/nearest.h"
#include "data/schema.h"
#include "data/table_parser.h"
#include "lua/sandbox.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// Reads a schema from the table at an index. Its own faults are errors too, named by their path in the
/// schema.
class SchemaReader {
  public:
    explicit SchemaReader(lua_State* L) : L_(L) {}

    Schema read(int index, const std::string& path, int depth = 1) {
        if (depth > kMaxTableDepth) call_error(L_, path + " is nested too deep");
        luaL_checkstack(L_, 10, "nested schema");
        if (!lua_istable(L_, index))
            call_error(L_, path + " is " + describe_value(L_, index) + "; expected a table");
        check_names(index, path);
        Schema schema;
        schema.type = read_type(index, path);
        schema.required = read_boolean(index, path, "required");
        schema.min = read_number(index, path, "min", schema.min);
        schema.max = read_number(index, path, "max", schema.max);
        schema.above = read_number(index, path, "above", schema.above);
        schema.min_length = read_length(index, path, "min_length", schema.min_length);
        schema.max_length = read_length(index, path, "max_length", schema.max_length);
        if (push(index, "what")) schema.what = text(path + ".what");
        lua_pop(L_, 1);
        if (push(index, "default")) schema.default_value = value_or_raise(L_, to_value(L_, -1));
        lua_pop(L_, 1);
        if (push(index, "one_of")) schema.one_of = read_choices(path + ".one_of");
        lua_pop(L_, 1);
        if (push(index, "items"))
            schema.items = std::make_unique<Schema>(read(lua_gettop(L_), path + ".items", depth + 1));
        lua_pop(L_, 1);
        if (push(index, "fields")) read_fields(schema, path + ".fields", depth);
        lua_pop(L_, 1);
        if (push(index, "check")) read_check(schema, path + ".check");
        lua_pop(L_, 1);
        return schema;
    }

  private:
    bool push(int table, const char* name) { return lua_getfield(L_, table, name) != LUA_TNIL; }

    void check_names(int index, const std::string& path) {
        static const std::vector<std::string> names = {
            "above", "check",      "default", "fields",   "items", "max", "max_length",
            "min",   "min_length", "one_of",  "required", "type",  "what"};
        lua_pushnil(L_);
        while (lua_next(L_, index) != 0) {
            lua_pop(L_, 1);
            const std::string name = lua_type(L_, -1) == LUA_TSTRING ? lua_tostring(L_, -1) : "";
            if (std::find(names.begin(), names.end(), name) != names.end()) continue;
            call_error(L_,
                       path + " has the unknown field " + describe_value(L_, -1) + suggestion(name, names));
        }
    }

    std::string text(const std::string& path) {
        if (lua_type(L_, -1) != LUA_TSTRING)
            call_error(L_, path + " is " + describe_value(L_, -1) + "; expected a string");
        return lua_tostring(L_, -1);
    }

    SchemaType read_type(int index, const std::string& path) {
        if (!push(index, "type")) call_error(L_, path + " has no type" + suggestion("", schema_type_names()));
        const std::string name = text(path + ".type");
        const auto type = schema_type_from_name(name);
        if (!type) {
            call_error(
                L_, path + ".type = \"" + name + "\": no such type" + suggestion(name, schema_type_names()));
        }
        lua_pop(L_, 1);
        return *type;
    }

    bool read_boolean(int index, const std::string& path, const char* name) {
        if (push(index, name) && !lua_isboolean(L_, -1)) {
            call_error(L_, path + '.' + name + " is " + describe_value(L_, -1) + "; expected true or false");
        }
        const bool value = lua_toboolean(L_, -1) != 0;
        lua_pop(L_, 1);
        return value;
    }

    double read_number(int index, const std::string& path, const char* name, double fallback) {
        const bool is_given = push(index, name);
        if (is_given && lua_type(L_, -1) != LUA_TNUMBER) {
            call_error(L_, path + '.' + name + " is " + describe_value(L_, -1) + "; expected a number");
        }
        const double value = is_given ? lua_tonumber(L_, -1) : fallback;
        lua_pop(L_, 1);
        return value;
    }

    std::size_t read_length(int index, const std::string& path, const char* name, std::size_t fallback) {
        const double value = read_number(index, path, name, -1);
        return value < 0 ? fallback : static_cast<std::size_t>(std::min(value, 1e9));
    }

    /// A list of values, or a table whose keys are the values. On top of the stack.
    std::vector<std::string> read_choices(const std::string& path) {
        if (!lua_istable(L_, -1))
            call_error(L_, path + " is " + describe_value(L_, -1) + "; expected a table");
        const bool is_list = lua_rawlen(L_, -1) > 0;
        std::vector<std::string> choices;
        lua_pushnil(L_);
        while (lua_next(L_, -2) != 0) {
            lua_pushvalue(L_, is_list ? -1 : -2);
            push_text(L_, -1);
            choices.emplace_back(lua_tostring(L_, -1));
            lua_pop(L_, 3);
        }
        std::sort(choices.begin(), choices.end());
        return choices;
    }

    void read_fields(Schema& schema, const std::string& path, int depth) {
        if (!lua_istable(L_, -1))
            call_error(L_, path + " is " + describe_value(L_, -1) + "; expected a table");
        schema.has_fields = true;
        const int table = lua_gettop(L_);
        lua_pushnil(L_);
        while (lua_next(L_, table) != 0) {
            if (lua_type(L_, -2) != LUA_TSTRING) {
                call_error(L_,
                           path + " has the key " + describe_value(L_, -2) + "; names of fields are strings");
            }
            const std::string name = lua_tostring(L_, -2);
            schema.fields.push_back({name, read(lua_gettop(L_), path + '.' + name, depth + 1)});
            lua_pop(L_, 1);
        }
        std::sort(schema.fields.begin(), schema.fields.end(),
                  [](const SchemaField& a, const SchemaField& b) { return a.name < b.name; });
    }

    /// The function stays on the stack while the check runs, because the schema does.
    void read_check(Schema& schema, const std::string& path) {
        if (!lua_isfunction(L_, -1))
            call_error(L_, path + " is " + describe_value(L_, -1) + "; expected a function");
        const auto reference = std::shared_ptr<int>(new int(0), [L = L_](int* r) {
            luaL_unref(L, LUA_REGISTRYINDEX, *r);
            delete r;
        });
        lua_pushvalue(L_, -1);
        *reference = luaL_ref(L_, LUA_REGISTRYINDEX);
        schema.check = [L = L_, reference](const Value& value) -> std::optional<std::string> {
            lua_rawgeti(L, LUA_REGISTRYINDEX, *reference);
            push_value(L, value);
            lua_call(L, 1, 1);
            std::optional<std::string> wrong;
            if (lua_type(L, -1) == LUA_TSTRING) wrong = lua_tostring(L, -1);
            lua_pop(L, 1);
            return wrong;
        };
    }

    lua_State* L_;
};

/// All faults are one error, a line for each.
Pushed check_and_push(lua_State* L, Value value, const Schema& schema, const std::string& name) {
    std::string message;
    for (const std::string& fault : check_data(value, schema, name))
        message += (message.empty() ? "" : "\n") + fault;
    if (!message.empty()) {
        // The place is that in the data file, which helps more than that of the call.
        lua_pushlstring(L, message.data(), message.size());
        lua_error(L);
    }
    fill_defaults(value, schema);
    push_value(L, value);
    return {1};
}

Pushed load(lua_State* L, std::string_view path, TableArgument schema_table) {
    const Schema schema = SchemaReader(L).read(schema_table.index, "schema");
    const std::string text = value_or_raise(L, context_of(L).services.files.read_text(path));
    auto value = parse_table_text(text, path);
    if (!value) {
        lua_pushstring(L, value.error().message.c_str());
        lua_error(L);
    }
    return check_and_push(L, *std::move(value), schema, std::string(path));
}

Pushed check(lua_State* L, TableArgument data, TableArgument schema_table) {
    const Schema schema = SchemaReader(L).read(schema_table.index, "schema");
    return check_and_push(L, value_or_raise(L, to_value(L, data.index)), schema, "data");
}

constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};

constexpr Function kFunctions[] = {
    function_pushing<&load>(
        "load", "path, schema", "data", kReturnsTable,
        "Reads Lua table text as data, never running it, checks it by the schema and fills in defaults. A "
        "fault is an error such as `levels/level-01.lua:14: pieces[3].material = \"wod\": no such "
        "material; did you mean \"wood\"? (ice, stone, wood)`."),
    function_pushing<&check>("check", "data, schema", "checked", kReturnsTable,
                             "Checks a table of any origin and returns a copy with the defaults filled in."),
};

}  // namespace

const Module kDataModule = {
    "cairn.data",
    "Data files of a game's own, with rules; for levels see cairn.level. A schema is a table: `type` "
    "(\"number\", \"integer\", \"string\", \"boolean\", "
    "\"table\", \"list\", \"any\"), `required = false`, `default`, `min`, `max`, "
    "`above` (greater than), `one_of` (a list of "
    "allowed values, or a table whose keys are allowed), `what` (what a value is "
    "called in messages, such as \"material\"), "
    "`min_length`, `max_length` (of strings and lists), `fields` (name -> schema; "
    "other fields are faults), `items` (the schema "
    "of each member), `check` (a function that is given the value and returns nil, "
    "or a sentence saying what is wrong).",
    kFunctions};

}  // namespace cairn::scripting
