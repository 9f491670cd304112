// What a data value can answer about itself, for validators and messages.
#include "data/value.h"

#include <cstdio>

#include <cairn/engine/printable.h>

#include "data/table_writer.h"

namespace cairn::scripting {

double Value::number() const {
    if (kind() == Kind::Integer) return static_cast<double>(std::get<std::int64_t>(content));
    return std::get<double>(content);
}

const Value* Value::find(std::string_view key) const {
    if (kind() != Kind::Table) return nullptr;
    for (const Entry& entry : entries()) {
        const auto* name = std::get_if<std::string>(&entry.key);
        if (name != nullptr && *name == key) return &entry.value;
    }
    return nullptr;
}

bool Value::is_list() const {
    if (kind() != Kind::Table) return false;
    std::vector<bool> seen(entries().size(), false);
    for (const Entry& entry : entries()) {
        const auto* index = std::get_if<std::int64_t>(&entry.key);
        if (index == nullptr || *index < 1 || *index > static_cast<std::int64_t>(seen.size())) return false;
        seen[static_cast<std::size_t>(*index - 1)] = true;
    }
    return true;  // as many distinct keys as there are places, all inside
}

// Assigned, not constructed in place: g++ 12 warns of the variant of keys otherwise.
void add_entry(Value& table, std::string_view key, Value value) {
    Entry& entry = std::get<Entries>(table.content).emplace_back();
    entry.key = std::string(key);
    entry.value = std::move(value);
}

void add_item(Value& list, Value value) {
    auto& entries = std::get<Entries>(list.content);
    Entry& entry = entries.emplace_back();
    entry.key = static_cast<std::int64_t>(entries.size());
    entry.value = std::move(value);
}

std::string_view kind_with_article(Value::Kind kind) {
    switch (kind) {
        case Value::Kind::Boolean:
            return "a boolean";
        case Value::Kind::Integer:
            return "an integer";
        case Value::Kind::Number:
            return "a number";
        case Value::Kind::String:
            return "a string";
        case Value::Kind::Table:
            return "a table";
    }
    return "";
}

std::string to_short_text(const Value& value) {
    constexpr std::size_t kMaxLength = 40;  // beyond it, a message gets hard to read on one line
    if (value.kind() == Value::Kind::Table) return value.entries().empty() ? "{}" : "{...}";
    if (value.kind() != Value::Kind::String) return to_table_text(value);
    if (value.text().size() <= kMaxLength) return quote_text(value.text());
    return quote_text(engine::beginning_of(value.text(), kMaxLength)) + "...";
}

}  // namespace cairn::scripting
