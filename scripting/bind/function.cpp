// Messages of wrong calls.
#include "bind/function.h"

#include <charconv>

#include "bind/fields.h"
#include "bind/module.h"

namespace cairn::scripting {
namespace {

// Every binding is a closure over its own description and its module.
const Function& running_function(lua_State* L) {
    return *static_cast<const Function*>(lua_touserdata(L, lua_upvalueindex(1)));
}
const Module& running_module(lua_State* L) {
    return *static_cast<const Module*>(lua_touserdata(L, lua_upvalueindex(2)));
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

/// "box.radius_m" becomes "radius", and what is no name of a field stays: "0.005", "step".
std::string_view author_name(std::string_view word) {
    if (word.empty() || (word[0] >= '0' && word[0] <= '9')) return word;
    // The longest first.
    for (const std::string_view unit :
         {"_kg_m2", "_rad_s", "_m_s2", "_m_s", "_1_s", "_rad", "_nm", "_hz", "_m", "_n", "_s"}) {
        if (!word.ends_with(unit)) continue;
        word.remove_suffix(unit.size());
        break;
    }
    return word.substr(word.rfind('.') + 1);  // all of it without a dot
}

/// "revolute_joint", as the physics calls a kind, becomes "revolute joint".
std::string author_kind(std::string_view word) {
    constexpr std::string_view kJoint = "_joint";
    if (!word.ends_with(kJoint)) return std::string(word);
    return std::string(word.substr(0, word.size() - kJoint.size())) + " joint";
}

/// The physics counts from 0, and Lua from 1: "[2]" at the beginning of a text becomes "[3]". Takes it out of
/// the text; what is no such index is left there.
std::string take_index(std::string_view& text) {
    if (text.empty() || text[0] != '[') return "";
    std::size_t index = 0;
    const auto end = std::from_chars(text.data() + 1, text.data() + text.size(), index);
    if (end.ec != std::errc() || end.ptr == text.data() + text.size() || *end.ptr != ']') return "";
    text.remove_prefix(static_cast<std::size_t>(end.ptr + 1 - text.data()));
    return '[' + std::to_string(index + 1) + ']';
}

}  // namespace

std::string author_words(std::string_view physics_message) {
    std::string words;
    while (!physics_message.empty()) {
        std::size_t length = 0;
        while (length < physics_message.size() && is_name_character(physics_message[length])) ++length;
        const std::string_view name = author_name(physics_message.substr(0, length));
        if (name == "nan" && words.ends_with('-')) words.pop_back();
        physics_message.remove_prefix(length);
        if (physics_message.starts_with("::")) {  // the type of a member
            physics_message.remove_prefix(2);
            continue;
        }
        words += author_kind(name);
        const std::string index = length > 0 ? take_index(physics_message) : "";
        words += index;
        if (index.empty() && !physics_message.empty()) {
            words += physics_message[0];
            physics_message.remove_prefix(1);
        }
    }
    return words;
}

std::vector<Parameter> parse_parameters(std::string_view text) {
    std::vector<Parameter> parameters;
    while (!trim(text).empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        std::string_view part = trim(text.substr(0, comma));
        text.remove_prefix(std::min(comma + 1, text.size()));
        Parameter parameter;
        if (const std::size_t equals = part.find('='); equals != std::string_view::npos) {
            parameter.default_value = trim(part.substr(equals + 1));
            part = trim(part.substr(0, equals));
        }
        if (const std::size_t bracket = part.find('['); bracket != std::string_view::npos) {
            parameter.unit = part.substr(bracket + 1, part.find(']') - bracket - 1);
            part = trim(part.substr(0, bracket));
        }
        parameter.name = part;
        parameters.push_back(parameter);
    }
    return parameters;
}

std::string running_name(lua_State* L) {
    const Module& module = running_module(L);
    return std::string(module.name) + (module.is_type ? ':' : '.') + running_function(L).name;
}

bool is_method(lua_State* L) {
    return running_module(L).is_type;
}

void argument_error(lua_State* L, int index, const std::string& expected) {
    const Module& module = running_module(L);
    const Function& function = running_function(L);
    if (module.is_type && index == 1) {
        call_error(L, "the receiver is " + describe_value(L, 1) + "; call it as object:" + function.name +
                          "(...) of a " + module.name);
    }
    const std::vector<Parameter> parameters = parse_parameters(function.parameters);
    const auto place = static_cast<std::size_t>(index - (module.is_type ? 2 : 1));
    const std::string name = place < parameters.size() ? std::string(parameters[place].name)
                                                       : "argument " + std::to_string(place + 1);
    call_error(L, name + " is " + describe_value(L, index) + "; expected " + expected);
}

void range_error(lua_State* L, int index, const Range& range) {
    const double value = lua_tonumber(L, index);
    if (range.contains(value)) argument_error(L, index, std::string("a number ") + kWithinFloat);
    const bool is_integer = running_function(L).parameter_types[static_cast<std::size_t>(index - 1)] ==
                            Argument<std::int64_t>::kType;
    const std::string ends = to_text(range);
    if (ends.empty() || !std::isfinite(value)) argument_error(L, index, "a finite number");
    const auto place = static_cast<std::size_t>(index - (is_method(L) ? 2 : 1));
    const std::string_view unit = parse_parameters(running_function(L).parameters)[place].unit;
    argument_error(L, index,
                   std::string(is_integer ? "an integer" : "a number") +
                       (ends.starts_with("at ") ? ", " : " ") + ends + (unit.empty() ? "" : " ") +
                       std::string(unit));
}

void count_error(lua_State* L, int most) {
    const int receivers = is_method(L) ? 1 : 0;
    const int takes = most - receivers;
    const int given = lua_gettop(L) - receivers;
    const std::vector<Parameter> parameters = parse_parameters(running_function(L).parameters);
    const bool is_flexible = !parameters.empty() && !parameters.back().default_value.empty();
    raise(L, running_name(L) + " takes " + (is_flexible ? "at most " : "") +
                 (takes == 0 ? "no" : std::to_string(takes)) + " argument" + (takes == 1 ? "" : "s") + ", " +
                 std::to_string(given) + " given");
}

void call_error(lua_State* L, const std::string& message) {
    raise(L, running_name(L) + ": " + message);
}

}  // namespace cairn::scripting
