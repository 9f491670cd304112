// The validator: walks data and schema together and collects every fault.
#include "data/schema.h"

#include <algorithm>
#include <charconv>

#include "data/nearest.h"
#include "data/table_writer.h"

namespace cairn::scripting {
namespace {

std::string number_to_text(double number) {
    char buffer[40];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr};
}

std::string type_with_article(SchemaType type) {
    switch (type) {
        case SchemaType::Any:
            return "any value";
        case SchemaType::Number:
            return "a number";
        case SchemaType::Integer:
            return "an integer";
        case SchemaType::String:
            return "a string";
        case SchemaType::Boolean:
            return "a boolean (true or false)";
        case SchemaType::Table:
            return "a table";
        case SchemaType::List:
            return "a list";
    }
    return "";
}

bool has_type(const Value& value, SchemaType type) {
    switch (type) {
        case SchemaType::Any:
            return true;
        case SchemaType::Number:
            return value.is_number();
        case SchemaType::Integer:
            return value.kind() == Value::Kind::Integer;
        case SchemaType::String:
            return value.kind() == Value::Kind::String;
        case SchemaType::Boolean:
            return value.kind() == Value::Kind::Boolean;
        case SchemaType::Table:
            return value.kind() == Value::Kind::Table;
        case SchemaType::List:
            return value.is_list();
    }
    return false;
}

std::string key_text(const Key& key) {
    if (const auto* name = std::get_if<std::string>(&key)) return *name;
    return '[' + std::to_string(std::get<std::int64_t>(key)) + ']';
}

class Checker {
  public:
    explicit Checker(const std::string& name) : name_(name) {}

    void check(const Value& value, const Schema& schema, const std::string& path) {
        if (!has_type(value, schema.type)) {
            const bool is_mixed = schema.type == SchemaType::List && value.kind() == Value::Kind::Table;
            fault(value, path, true,
                  is_mixed ? "must be a list: its keys must be 1, 2, 3, ..."
                           : "must be " + type_with_article(schema.type) + ", is " +
                                 std::string(kind_with_article(value.kind())));
            return;
        }
        const std::size_t faults_before = faults_.size();
        if (value.is_number()) check_range(value, schema, path);
        if (value.kind() == Value::Kind::String)
            check_length(value, schema, path, value.text().size(), "byte");
        if (schema.type == SchemaType::List)
            check_length(value, schema, path, value.entries().size(), "member");
        if (!schema.one_of.empty()) check_one_of(value, schema, path);
        if (value.kind() == Value::Kind::Table && schema.has_fields) check_fields(value, schema, path);
        if (value.kind() == Value::Kind::Table && schema.items) check_items(value, schema, path);
        // A rule of the game's own may take for granted that the others hold.
        if (schema.check && faults_.size() == faults_before) {
            if (const auto wrong = schema.check(value)) fault(value, path, true, *wrong);
        }
    }

    std::vector<std::string> take() { return std::move(faults_); }

  private:
    void fault(const Value& value, const std::string& path, bool show_value, const std::string& what) {
        if (value.is_unreadable) return;
        std::string text = name_;
        if (value.line > 0) text += ':' + std::to_string(value.line);
        text += ": " + (path.empty() ? std::string("the table") : path);
        if (show_value && value.kind() != Value::Kind::Table) text += " = " + to_short_text(value);
        faults_.push_back(text + ": " + what);
    }

    void check_range(const Value& value, const Schema& schema, const std::string& path) {
        const double number = value.number();
        if (number < schema.min) fault(value, path, true, "must be at least " + number_to_text(schema.min));
        if (number > schema.max) fault(value, path, true, "must be at most " + number_to_text(schema.max));
        if (number <= schema.above) fault(value, path, true, "must be above " + number_to_text(schema.above));
    }

    void check_length(const Value& value, const Schema& schema, const std::string& path, std::size_t length,
                      const std::string& unit) {
        const std::string has = ", has " + std::to_string(length);
        const auto count = [&](std::size_t n) {
            return std::to_string(n) + ' ' + unit + (n == 1 ? "" : "s");
        };
        if (length < schema.min_length) {
            fault(value, path, true, "must have at least " + count(schema.min_length) + has);
        } else if (length > schema.max_length) {
            fault(value, path, true, "must have at most " + count(schema.max_length) + has);
        }
    }

    void check_one_of(const Value& value, const Schema& schema, const std::string& path) {
        const std::string text = value.kind() == Value::Kind::String ? value.text() : to_short_text(value);
        if (std::find(schema.one_of.begin(), schema.one_of.end(), text) != schema.one_of.end()) return;
        const std::string what = schema.what.empty() ? "value" : schema.what;
        fault(value, path, true, "no such " + what + suggestion(text, schema.one_of));
    }

    void check_fields(const Value& value, const Schema& schema, const std::string& path) {
        for (const Entry& entry : value.entries()) {
            const std::string field_path = join(path, entry.key);
            const auto field = std::find_if(schema.fields.begin(), schema.fields.end(),
                                            [&](const SchemaField& f) { return Key(f.name) == entry.key; });
            if (field != schema.fields.end()) {
                check(entry.value, field->schema, field_path);
                continue;
            }
            std::vector<std::string> names;
            for (const SchemaField& f : schema.fields) names.push_back(f.name);
            fault(entry.value, field_path, false, "unknown field" + suggestion(key_text(entry.key), names));
        }
        for (const SchemaField& field : schema.fields) {
            if (!field.schema.required || value.find(field.name) != nullptr) continue;
            const std::string what = field.schema.what.empty() ? "" : ", the " + field.schema.what;
            fault(value, path, false,
                  '"' + field.name + "\" is missing; it must be " + type_with_article(field.schema.type) +
                      what);
        }
    }

    void check_items(const Value& value, const Schema& schema, const std::string& path) {
        for (const Entry& entry : value.entries()) check(entry.value, *schema.items, join(path, entry.key));
    }

    static std::string join(const std::string& path, const Key& key) {
        const bool needs_dot = !path.empty() && std::holds_alternative<std::string>(key);
        return path + (needs_dot ? "." : "") + shown_name(key_text(key));
    }

    const std::string& name_;
    std::vector<std::string> faults_;
};

}  // namespace

const std::vector<std::string>& schema_type_names() {
    static const std::vector<std::string> names = {"any",    "boolean", "integer", "list",
                                                   "number", "string",  "table"};
    return names;
}

std::optional<SchemaType> schema_type_from_name(std::string_view name) {
    static constexpr std::pair<std::string_view, SchemaType> kTypes[] = {
        {"any", SchemaType::Any},     {"boolean", SchemaType::Boolean}, {"integer", SchemaType::Integer},
        {"list", SchemaType::List},   {"number", SchemaType::Number},   {"string", SchemaType::String},
        {"table", SchemaType::Table},
    };
    for (const auto& [type_name, type] : kTypes) {
        if (type_name == name) return type;
    }
    return std::nullopt;
}

std::vector<std::string> check_data(const Value& value, const Schema& schema, const std::string& name) {
    Checker checker(name);
    checker.check(value, schema, "");
    return checker.take();
}

void fill_defaults(Value& value, const Schema& schema) {
    if (value.kind() != Value::Kind::Table) return;
    auto& entries = std::get<Entries>(value.content);
    for (const SchemaField& field : schema.fields) {
        if (field.schema.default_value && value.find(field.name) == nullptr) {
            entries.push_back({field.name, *field.schema.default_value});
        }
    }
    for (Entry& entry : entries) {
        if (schema.items) fill_defaults(entry.value, *schema.items);
        for (const SchemaField& field : schema.fields) {
            if (Key(field.name) == entry.key) fill_defaults(entry.value, field.schema);
        }
    }
}

}  // namespace cairn::scripting
