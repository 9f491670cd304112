// Making values, and properties of the editor as fields.
#include "level/tiled_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <utility>

namespace cairn::scripting {
namespace {

Value to_value(const engine::TileProperty& property) {
    return std::visit([](const auto& content) { return scripting::to_value(content); }, property);
}

}  // namespace

bool TiledThing::lacks(std::string_view what) const {
    return unreadable != nullptr && unreadable->contains(what);
}
bool TiledThing::lacks_any(std::initializer_list<std::string_view> what) const {
    return std::any_of(what.begin(), what.end(), [&](std::string_view w) { return lacks(w); });
}

Value to_value(double number) {
    Value value;
    if (std::abs(number) < 1e15 && number == std::floor(number)) {
        value.content = static_cast<std::int64_t>(number);
    } else {
        value.content = number;
    }
    return value;
}
Value to_value(const std::string& text) {
    Value value;
    value.content = text;
    return value;
}
Value to_value(bool is_true) {
    Value value;
    value.content = is_true;
    return value;
}
Value new_table() {
    Value value;
    value.content = Entries{};
    return value;
}
Value unreadable_value() {
    Value value = to_value(false);
    value.is_unreadable = true;
    return value;
}

Value value_of(const TiledThing& thing, Value value, ValueOrigin origin) {
    origin.thing = thing.name;
    value.line = thing.line;
    value.origin = std::make_shared<ValueOrigin>(std::move(origin));
    return value;
}
Value table_of(const TiledThing& thing) {
    return value_of(thing, new_table());
}
Value property_value(const TiledThing& thing, const std::string& name, const engine::TileProperty& property) {
    const Value value = to_value(property);
    return value_of(thing, value, {.member = "property \"" + name + '"', .written = to_short_text(value)});
}

std::string written_number(float number, std::string_view unit) {
    char buffer[40];
    const std::string digits(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
    return digits + ' ' + std::string(unit);
}

bool is_field(const std::vector<const Field*>& fields, std::string_view name) {
    return std::any_of(fields.begin(), fields.end(), [&](const Field* field) { return name == field->name; });
}

void set_properties(Value& table, const TiledThing& thing, const engine::TileProperties& properties,
                    const std::vector<const Field*>& fields) {
    Value data = new_table();
    for (const auto& [name, property] : properties) {
        const bool is_known = is_field(fields, name) && name != "data";
        if (table.find(name) == nullptr)
            add_entry(is_known ? table : data, name, property_value(thing, name, property));
    }
    if (!data.entries().empty() && is_field(fields, "data"))
        add_entry(table, "data", value_of(thing, std::move(data)));
}

void set_unreadable(Value& table, const TiledThing& thing, const std::vector<const Field*>& fields) {
    for (const Field* field : fields) {
        const bool is_lost = thing.lacks("property " + std::string(field->name));
        if (is_lost && table.find(field->name) == nullptr) add_entry(table, field->name, unreadable_value());
    }
}

}  // namespace cairn::scripting
