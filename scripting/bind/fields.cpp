// Reading described tables.
#include "bind/fields.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <cairn/engine/printable.h>

#include "bind/function.h"
#include "bind/object.h"
#include "data/nearest.h"
#include "data/table_writer.h"

namespace cairn::scripting {
namespace {

bool has_type(lua_State* L, FieldType type) {
    switch (type) {
        case FieldType::Number:
            return lua_type(L, -1) == LUA_TNUMBER;
        case FieldType::Integer:
            return is_integral(L, -1);
        case FieldType::Boolean:
            return lua_isboolean(L, -1);
        case FieldType::String:
            return lua_type(L, -1) == LUA_TSTRING;
        case FieldType::Table:
        case FieldType::Points:
            return lua_istable(L, -1);
        case FieldType::Function:
            return lua_isfunction(L, -1);
        case FieldType::Body:
            return is_object(L, -1, ObjectTag::Body);
        case FieldType::Joint:
            return is_object(L, -1, ObjectTag::Joint);
    }
    return false;
}

}  // namespace

std::string range_rule(const Field& field) {
    const std::string ends = to_text(field.range);
    if (field.range.has_high()) return "must be " + ends;
    if (ends.empty()) return field.range.is_finite() ? "must be finite" : "must be a number, not nan";
    return "must be " + ends + (field.range.is_finite() ? " and finite" : "");
}

bool is_in_range(const Field& field, double value) {
    return field.range.contains(value);
}

std::vector<std::string> words_of(std::string_view choices) {
    std::vector<std::string> words;
    while (!choices.empty()) {
        const std::size_t end = std::min(choices.find(' '), choices.size());
        words.emplace_back(choices.substr(0, end));
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
    return words;
}

const char* field_type_with_article(FieldType type) {
    switch (type) {
        case FieldType::Number:
            return "a number";
        case FieldType::Integer:
            return "an integer";
        case FieldType::Boolean:
            return "true or false";
        case FieldType::String:
            return "a string";
        case FieldType::Table:
            return "a table";
        case FieldType::Points:
            return "a list of points, { {x, y}, ... }";
        case FieldType::Function:
            return "a function";
        case FieldType::Body:
            return "a Body";
        case FieldType::Joint:
            return "a Joint";
    }
    return "";
}

const char* field_type_name(FieldType type) {
    switch (type) {
        case FieldType::Number:
            return "number";
        case FieldType::Integer:
            return "integer";
        case FieldType::Boolean:
            return "boolean";
        case FieldType::String:
            return "string";
        case FieldType::Table:
            return "table";
        case FieldType::Points:
            return "number[][]";
        case FieldType::Function:
            return "function";
        case FieldType::Body:
            return "Body";
        case FieldType::Joint:
            return "Joint";
    }
    return "";
}

std::vector<const Field*> all_fields(const FieldSet& set) {
    std::vector<const Field*> fields(set.own.begin(), set.own.end());
    for (const FieldSet* included : set.includes) {
        if (included == nullptr) continue;
        for (const Field* field : all_fields(*included)) fields.push_back(field);
    }
    return fields;
}

std::string describe_value(lua_State* L, int index) {
    index = lua_absindex(L, index);
    constexpr std::size_t kMaxText = 40;
    switch (lua_type(L, index)) {
        case LUA_TNONE:
        case LUA_TNIL:
            return "nil";
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) != 0 ? "true" : "false";
        case LUA_TNUMBER: {
            // The C library writes a sign before some, which means nothing to anybody.
            if (std::isnan(lua_tonumber(L, index))) return "nan";
            lua_pushvalue(L, index);  // lua_tostring would turn the argument itself into a string
            std::string text = lua_tostring(L, -1);
            lua_pop(L, 1);
            return text;
        }
        case LUA_TSTRING: {
            std::size_t length = 0;
            const char* text = lua_tolstring(L, index, &length);
            const std::string_view all(text, length);
            return quote_text(engine::beginning_of(all, kMaxText)) + (length > kMaxText ? "..." : "");
        }
        case LUA_TUSERDATA:
            return std::string("a ") + object_type_name(L, index);
        default:
            return std::string("a ") + luaL_typename(L, index);
    }
}

FieldReader::FieldReader(lua_State* L, int index, const FieldSet& set)
    : L_(L), index_(lua_absindex(L, index)) {
    const std::vector<const Field*> fields = all_fields(set);
    lua_pushnil(L);
    while (lua_next(L, index_) != 0) {
        lua_pop(L, 1);
        const bool is_name = lua_type(L, -1) == LUA_TSTRING;
        const std::string_view name = is_name ? lua_tostring(L, -1) : "";
        bool is_known = false;
        for (const Field* field : fields) is_known = is_known || name == field->name;
        if (is_known) continue;
        std::vector<std::string> names;
        for (const Field* field : fields) names.push_back(field->name);
        if (!is_name)
            call_error(L, "the key " + describe_value(L, -1) + " is not a field" + suggestion("", names));
        call_error(L, "unknown field " + quote_text(name) + suggestion(name, names));
    }
}

bool FieldReader::push(const Field& field) const {
    lua_getfield(L_, index_, field.name);
    if (lua_isnil(L_, -1)) {
        lua_pop(L_, 1);
        if (field.default_text == nullptr) {
            call_error(L_, std::string(field.name) + " is missing; it must be " +
                               field_type_with_article(field.type));
        }
        return false;
    }
    if (!has_type(L_, field.type)) fail(field, std::string("must be ") + field_type_with_article(field.type));
    return true;
}

void FieldReader::fail(const Field& field, const std::string& rule) const {
    lua_getfield(L_, index_, field.name);
    call_error(L_, std::string(field.name) + " = " + describe_value(L_, -1) + ": " + rule);
}

bool FieldReader::has(const Field& field) const {
    lua_getfield(L_, index_, field.name);
    const bool is_there = !lua_isnil(L_, -1);
    lua_pop(L_, 1);
    return is_there;
}

double FieldReader::take_number(const Field& field) const {
    const double value = lua_tonumber(L_, -1);
    lua_pop(L_, 1);
    if (!is_in_range(field, value)) fail(field, range_rule(field));
    if (is_beyond_float(value)) fail(field, std::string("must be ") + kWithinFloat);
    return value;
}

double FieldReader::number(const Field& field) const {
    return push(field) ? take_number(field) : field.default_number;
}

std::optional<double> FieldReader::optional_number(const Field& field) const {
    if (!push(field)) return std::nullopt;
    return take_number(field);
}

std::int64_t FieldReader::integer(const Field& field) const {
    if (!push(field)) return static_cast<std::int64_t>(field.default_number);
    const std::int64_t value = lua_tointeger(L_, -1);
    lua_pop(L_, 1);
    if (!is_in_range(field, static_cast<double>(value))) fail(field, range_rule(field));
    return value;
}

bool FieldReader::boolean(const Field& field) const {
    if (!push(field)) return field.default_number != 0;
    const bool value = lua_toboolean(L_, -1) != 0;
    lua_pop(L_, 1);
    return value;
}

std::string_view FieldReader::text(const Field& field) const {
    if (!push(field)) return field.default_text;
    std::size_t length = 0;
    const char* text = lua_tolstring(L_, -1, &length);
    lua_pop(L_, 1);
    return {text, length};
}

std::size_t FieldReader::choice(const Field& field) const {
    const std::string_view word = text(field);
    const std::vector<std::string> words = words_of(field.choices);
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) {
        std::string what = field.name;
        std::replace(what.begin(), what.end(), '_', ' ');
        fail(field, "no such " + what + suggestion(word, words));
    }
    return static_cast<std::size_t>(found - words.begin());
}

}  // namespace cairn::scripting
