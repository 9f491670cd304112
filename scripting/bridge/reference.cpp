// Writes the reference and the editor annotations from the descriptions of the bindings.
#include <algorithm>
#include <string_view>

#include <cairn/scripting/reference.h>

#include "bind/callbacks.h"
#include "bind/fields.h"
#include "bind/module.h"
#include "bridge/conf.h"
#include "bridge/field_table.h"
#include "bridge/reference_parts.h"

namespace cairn::scripting {
namespace {

/// How descriptions call a parameter that is a table with described fields.
constexpr std::string_view kFieldsParameter = "fields";

constexpr const char* kPreamble = R"(# The Lua API

One global table, `cairn`, holds everything; a game puts its callbacks into it. How a game's folder looks
and how games are run stands in [Games](games.md); the format of recordings in [Replays](replays.md).

- Getters are nouns and return plain values (`local x, y = body:position()`), setters begin with `set_`, creators with
  `new_` or `add_`.
- **World**: metres, y up, radians (anticlockwise), seconds, kilograms. **Screen**: logical pixels, y down, (0, 0) at the
  top left. Only a camera converts between the two.
- Colors are 0..1, and what lies beyond is drawn as the nearest of these. `name = value` shows a default: the argument
  may be left out. Numbers are finite unless something else is said.
- A wrong argument, or one too many, raises an error that names the function, the argument, the value and the rule, at
  the caller's `file:line`. A misspelt name of a module, a function or a method is an error that tells the nearest one.

This page is written by `cairn help --reference` from the descriptions that also check the arguments.
)";

constexpr const char* kStandardLibrary = R"(
## Lua's own library

Lua 5.4 with `table`, `string`, `math`, `utf8` and `coroutine`. Left out: `io`, `os`, `package`, `debug`, `dofile`,
`loadfile`, `string.dump`, `warn`, finalizers (`__gc`) and `collectgarbage` except `collectgarbage("count")`. `load` takes
text only. `require "src.aim"` runs the game's `src/aim.lua` once and returns what it returned; only the game's own files
are found. `print` writes to standard output. `tostring` and `string.format` show no addresses.

`math.sin cos tan asin acos atan exp log` and the added `math.pow(x, y)` give the same bits on every machine; `math.random`
draws from the gameplay stream (see cairn.random). The operator `^` is the C library's `pow`, whose last bit may differ
between machines for exponents other than 2: gameplay takes `math.pow` or products.
)";

/// "(x, y, angle = 0)"; a table with described fields is "{...}".
std::string parameter_list(const Function& function) {
    std::string text;
    for (const Parameter& parameter : parse_parameters(function.parameters)) {
        if (!text.empty()) text += ", ";
        if (function.fields != nullptr && parameter.name == kFieldsParameter) {
            text += "{...}";
            continue;
        }
        text += parameter.name;
        // Further arguments are left out by themselves.
        if (!parameter.default_value.empty() && parameter.name != "...")
            text += " = " + std::string(parameter.default_value);
    }
    return text == "{...}" ? text : '(' + text + ')';
}

std::string result_list(const Function& function) {
    std::string text;
    for (const Parameter& result : parse_parameters(function.results)) {
        text += (text.empty() ? "" : ", ") + std::string(result.name);
    }
    return text;
}

/// "x, y in m; dt in s".
std::string units(const Function& function) {
    std::vector<std::pair<std::string_view, std::string>> groups;
    const auto add = [&](const char* list) {
        for (const Parameter& parameter : parse_parameters(list)) {
            if (parameter.unit.empty()) continue;
            auto group = groups.begin();
            while (group != groups.end() && group->first != parameter.unit) ++group;
            if (group == groups.end()) group = groups.insert(groups.end(), {parameter.unit, ""});
            if ((", " + group->second + ",").find(", " + std::string(parameter.name) + ",") !=
                std::string::npos)
                continue;
            group->second += (group->second.empty() ? "" : ", ") + std::string(parameter.name);
        }
    };
    add(function.parameters);
    add(function.results);
    std::string text;
    for (const auto& [unit, names] : groups)
        text += (text.empty() ? "" : "; ") + names + " in " + std::string(unit);
    return text;
}

/// "probability from 0 to 1; voices from 1 to 32".
std::string ranges(const Function& function, const Module& module) {
    std::string text;
    std::size_t place = module.is_type ? 1 : 0;
    for (const Parameter& parameter : parse_parameters(function.parameters)) {
        const Range* range = function.parameter_ranges[place++];
        if (range == nullptr) continue;
        text += (text.empty() ? "" : "; ") + std::string(parameter.name) + ' ' + to_text(*range);
    }
    return text;
}

}  // namespace

std::string call_text(const Function& function, const Module& module) {
    std::string text(module.is_type ? "" : module.name);
    if (module.is_type) {
        text = module.name;
        text[0] = static_cast<char>(text[0] + ('a' - 'A'));
    }
    return text + (module.is_type ? ':' : '.') + function.name;
}

std::string signature(const Function& function, const Module& module) {
    const std::string results = result_list(function);
    return call_text(function, module) + parameter_list(function) + (results.empty() ? "" : " -> " + results);
}

void write_function(const Function& function, const Module& module, std::string& out) {
    out += "\n### `" + signature(function, module) + "`\n";
    std::string text = function.doc;
    if (const std::string unit_text = units(function); !unit_text.empty()) {
        text += (text.empty() ? "" : " ") + std::string("Units: ") + unit_text + '.';
    }
    if (const std::string range_text = ranges(function, module); !range_text.empty())
        text += (text.empty() ? "" : " ") + std::string("Range: ") + range_text + '.';
    if (!text.empty()) out += '\n' + text + '\n';
    if (function.fields != nullptr) out += field_table(all_fields(*function.fields));
}

// ---- What a game gives: its callbacks and conf.lua

std::string signature(const Callback& callback) {
    return std::string("cairn.") + callback.name + '(' + callback.parameters + ')';
}

void write_callbacks(std::string& out) {
    out +=
        "## Callbacks\n\nFunctions that the game puts into `cairn`; all may be left out. The scene on top of "
        "the "
        "stack of `cairn.scene` gets the same, but `load`, as methods.\n\n| callback | called |\n|---|---|\n";
    for (const Callback& callback : callbacks())
        out += "| `" + signature(callback) + "` | " + callback.doc + " |\n";
}

void write_conf(std::string& out) {
    out += "## conf.lua\n\n`return { title = \"Slingshot\", width = 1280 }`: read as data and never run.\n" +
           field_table(conf_fields());
}

namespace {

// ---- Annotations

std::string annotated_type(std::string_view type, bool is_optional) {
    return std::string(type) + (is_optional && type.back() != '?' ? "?" : "");
}

/// The class of a table with described fields: "World.add_box.Fields".
std::string fields_class(const Function& function, const Module& module) {
    return std::string(module.name) + '.' + function.name + ".Fields";
}

void annotate_fields(const Function& function, const Module& module, std::string& out) {
    out += "\n---@class " + fields_class(function, module) + '\n';
    for (const Field* field : all_fields(*function.fields)) {
        const bool is_optional = field->default_text != nullptr;
        out += std::string("---@field ") + field->name + (is_optional ? "? " : " ") +
               field_type_name(field->type);
        if (const std::string range = to_text(field->range); !range.empty()) out += ' ' + range + ';';
        if (*field->doc != '\0') out += std::string(" ") + field->doc;
        out += '\n';
    }
}

void annotate(const Function& function, const Module& module, std::string& out) {
    if (function.fields != nullptr) annotate_fields(function, module, out);
    out += '\n';
    if (*function.doc != '\0') out += std::string("---") + function.doc + '\n';
    std::size_t type = module.is_type ? 1 : 0;
    std::string names;
    for (const Parameter& parameter : parse_parameters(function.parameters)) {
        const bool has_fields = function.fields != nullptr && parameter.name == kFieldsParameter;
        const std::string class_name = has_fields ? fields_class(function, module) : "";
        const std::string type_name = annotated_type(has_fields ? class_name : function.parameter_types[type],
                                                     !parameter.default_value.empty());
        const Range* range = function.parameter_ranges[type++];
        out += "---@param " + std::string(parameter.name) + ' ' + type_name;
        if (!parameter.unit.empty()) out += " [" + std::string(parameter.unit) + ']';
        if (range != nullptr) out += ' ' + to_text(*range);
        out += '\n';
        names += (names.empty() ? "" : ", ") + std::string(parameter.name);
    }
    std::size_t result_type = 0;
    for (const Parameter& result : parse_parameters(function.results)) {
        const std::string_view type_name =
            function.result_types[std::min(result_type++, function.result_types.size() - 1)];
        out += "---@return " + std::string(type_name) + ' ' + std::string(result.name);
        if (!result.unit.empty()) out += " [" + std::string(result.unit) + ']';
        out += '\n';
    }
    out += "function " + std::string(module.name) + (module.is_type ? ':' : '.') + function.name + '(' +
           names + ") end\n";
}

}  // namespace

std::string reference_markdown() {
    std::string out = std::string(kPreamble) + '\n';
    write_callbacks(out);
    out += '\n';
    write_conf(out);
    for (const Module* module : all_modules()) {
        out += std::string("\n## ") + module->name + "\n\n" + module->doc + '\n';
        for (const Function& function : module->functions) write_function(function, *module, out);
    }
    return out + kStandardLibrary;
}

std::string editor_annotations() {
    std::string out =
        "---@meta\n-- Written by `cairn help --types`: annotations for the Lua language server. Never run.\n";
    for (const Module* module : all_modules()) {
        out += '\n';
        if (module->is_type) {
            out += std::string("---@class ") + module->name + '\n';
            for (const std::string_view owner : {"Body", "Shape", "Chain", "Joint"}) {
                if (module->name == owner) out += "---@field data table\n";
            }
            out += std::string("local ") + module->name + " = {}\n";
        } else {
            out += std::string(module->name) + " = {}\n";
        }
        for (const Function& function : module->functions) annotate(function, *module, out);
    }
    out += "\n---@type Random\ncairn.random.visual = nil\n---@type string\ncairn.version = nil\n";
    return out;
}

}  // namespace cairn::scripting
