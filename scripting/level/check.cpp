// The same rules as FieldReader has, on data instead of Lua tables.
#include "level/check.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "data/nearest.h"
#include "data/table_writer.h"

namespace cairn::scripting {
namespace {

std::string with_place(const std::string& file, const Value& value) {
    if (value.line == 0) return file + ": ";
    if (value.column == 0) return file + ':' + std::to_string(value.line) + ": ";
    return file + ':' + std::to_string(value.line) + ':' + std::to_string(value.column) + ": ";
}

std::string joined_path(const std::string& path, const std::string& field) {
    if (path.empty() || field.empty() || field[0] == '[') return path + field;
    return path + '.' + field;
}

/// The rule of a range in the unit in which the value was written.
std::string range_rule_of(const Value& value, const Field& field) {
    if (value.origin == nullptr || value.origin->unit.empty()) return range_rule(field);
    const ValueOrigin& origin = *value.origin;
    const auto written = [&](double end) { return (end - origin.offset) / origin.per_unit; };
    Range range = field.range;
    if (range.has_low()) range.low = written(field.range.low);
    if (range.has_high()) range.high = written(field.range.high);
    if (origin.per_unit < 0) std::swap(range.low, range.high);
    return range_rule(within(field, range)) + ' ' + std::string(origin.unit);
}

bool has_type(const Value& value, FieldType type) {
    switch (type) {
        case FieldType::Number:
            return value.is_number();
        case FieldType::Integer:
            return value.kind() == Value::Kind::Integer;
        case FieldType::Boolean:
            return value.kind() == Value::Kind::Boolean;
        case FieldType::String:
        case FieldType::Body:
        case FieldType::Joint:
            return value.kind() == Value::Kind::String;
        case FieldType::Table:
            return value.kind() == Value::Kind::Table;
        case FieldType::Points:
            return value.is_list();
        case FieldType::Function:
            return false;
    }
    return false;
}

std::string expected(FieldType type) {
    if (type == FieldType::Body) return "the name of a body, in quotes";
    if (type == FieldType::Joint) return "the name of a joint, in quotes";
    return field_type_with_article(type);
}

}  // namespace

std::string as_written(const Value& value) {
    if (value.origin != nullptr) return value.origin->written;
    return value.kind() == Value::Kind::Table ? "" : to_short_text(value);
}

std::string told_name(const Layer& entry) {
    return entry.table->origin != nullptr ? entry.table->origin->thing : entry.path;
}

std::string place_of(const Layer& entry) {
    return place_of(entry, *entry.table, "");
}

std::string place_of(const Layer& entry, const Value& value, const std::string& field) {
    const std::string start = with_place(entry.file, value);
    if (value.origin != nullptr) {
        const ValueOrigin& origin = *value.origin;
        return start + origin.thing + (origin.member.empty() ? "" : ": ") + origin.member;
    }
    return start + joined_path(entry.path, field);
}

std::string item_path(const std::string& list, std::size_t index) {
    return list + '[' + std::to_string(index + 1) + ']';
}

const Value* find_in(std::span<const Layer> layers, std::string_view field, const Layer** found_in) {
    for (const Layer& layer : layers) {
        const Value* value = layer.table->find(field);
        if (value == nullptr) continue;
        if (found_in != nullptr) *found_in = &layer;
        return value;
    }
    return nullptr;
}

bool is_point(const Value& value) {
    return value.is_list() && value.entries().size() == 2 && value.entries()[0].value.is_number() &&
           value.entries()[1].value.is_number();
}

void LevelChecker::fault_of_file(const std::string& file, const std::string& message) {
    // Messages of the parser begin with the place, and those of maps name their file.
    const bool names_file = message.find(file) != std::string::npos;
    add(file, {}, names_file ? message : file + ": " + message);
}

void LevelChecker::fault_of_line(const std::string& file, int line, const std::string& message) {
    Value place;
    place.line = line;
    add(file, place, with_place(file, place) + message);
}

void LevelChecker::missing(const Layer& where, std::string_view field, const std::string& rest) {
    // Of what an object of Tiled has, all is there but its name and its properties.
    const bool is_property = where.table->origin != nullptr && field != "name";
    fault(where, (is_property ? "the property \"" : "\"") + std::string(field) + "\" is missing" + rest);
}

void LevelChecker::add(const std::string& file, const Value& place, std::string text) {
    ++told_;
    if (!known_.insert(text).second) return;
    const auto found = std::find(files_.begin(), files_.end(), file);
    const auto index = static_cast<std::size_t>(found - files_.begin());
    if (found == files_.end()) files_.push_back(file);
    faults_.push_back({index, place.line, place.column, std::move(text)});
}

std::vector<std::string> LevelChecker::faults() const {
    std::vector<Fault> sorted = faults_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) {
        return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
    });
    std::vector<std::string> texts;
    for (Fault& fault : sorted) texts.push_back(std::move(fault.text));
    return texts;
}

void LevelChecker::fault(const Layer& where, const Value& value, const std::string& field,
                         const std::string& rule) {
    faulty_.insert(where.table);
    faulty_.insert(&value);
    if (value.is_unreadable) {
        ++told_;  // when the file was read
        return;
    }
    const std::string written = as_written(value);
    add(where.file, value,
        place_of(where, value, field) + (written.empty() ? "" : " = ") + written + ": " + rule);
}

void LevelChecker::fault(const Layer& where, const std::string& rule) {
    fault(where, *where.table, "", rule);
}

void LevelChecker::check_fields(const Layer& layer, std::span<const Field* const> fields) {
    for (const Entry& entry : layer.table->entries()) {
        const auto* name = std::get_if<std::string>(&entry.key);
        if (name == nullptr) {
            fault(layer, entry.value, '[' + std::to_string(std::get<std::int64_t>(entry.key)) + ']',
                  "a value without a name; expected name = value");
            continue;
        }
        const auto field =
            std::find_if(fields.begin(), fields.end(), [&](const Field* f) { return *name == f->name; });
        if (field != fields.end()) {
            check_value(layer, entry.value, **field);
            continue;
        }
        std::vector<std::string> names;
        for (const Field* f : fields) names.emplace_back(f->name);
        fault(layer, entry.value, shown_name(*name), "unknown field" + suggestion(*name, names));
    }
}

void LevelChecker::check_known_fields(const Layer& layer, std::span<const Field* const> fields) {
    for (const Field* field : fields) {
        if (const Value* value = layer.table->find(field->name)) check_value(layer, *value, *field);
    }
}

void LevelChecker::check_value(const Layer& layer, const Value& value, const Field& field) {
    if (value.is_unreadable || !has_type(value, field.type)) {
        fault(layer, value, field.name,
              "must be " + expected(field.type) + ", is " + std::string(kind_with_article(value.kind())));
        return;
    }
    if (field.type == FieldType::Number || field.type == FieldType::Integer) {
        if (!is_in_range(field, value.number())) {
            fault(layer, value, field.name, range_rule_of(value, field));
        } else if (field.type == FieldType::Number && is_beyond_float(value.number())) {
            fault(layer, value, field.name, std::string("must be ") + kWithinFloat);
        }
    }
    if (!field.choices.empty()) {
        std::string what = field.name;
        std::replace(what.begin(), what.end(), '_', ' ');
        check_one_of(layer, value, field.name, what, words_of(field.choices));
    }
    if (field.type == FieldType::Points) check_points(layer, value, field.name);
}

void LevelChecker::check_points(const Layer& layer, const Value& value, const std::string& field) {
    for (std::size_t i = 0; i < value.entries().size(); ++i) {
        const Value& point = value.entries()[i].value;
        if (is_point(point)) continue;
        faulty_.insert(&value);
        const Value* unreadable = nullptr;
        if (point.kind() == Value::Kind::Table) {
            for (const Entry& entry : point.entries()) {
                if (entry.value.is_unreadable) unreadable = &entry.value;
            }
        }
        fault(layer, unreadable == nullptr ? point : *unreadable, field + '[' + std::to_string(i + 1) + ']',
              "must be { x, y }, two numbers");
    }
}

void LevelChecker::check_missing(std::span<const Layer> layers, std::span<const Field* const> fields,
                                 std::string_view exempt) {
    for (const Field* field : fields) {
        if (field->default_text != nullptr || field->name == exempt) continue;
        if (find_in(layers, field->name) != nullptr) continue;
        const std::string unit = *field->doc == '\0' ? "" : " (" + std::string(field->doc) + ')';
        missing(layers.front(), field->name, "; it must be " + expected(field->type) + unit);
    }
}

void LevelChecker::check_one_of(const Layer& layer, const Value& value, const std::string& field,
                                const std::string& what, std::span<const std::string> names) {
    if (value.kind() != Value::Kind::String) return;  // said already
    if (std::find(names.begin(), names.end(), value.text()) != names.end()) return;
    fault(layer, value, field, "no such " + what + suggestion(value.text(), names));
}

}  // namespace cairn::scripting
