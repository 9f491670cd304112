// Data as it stands in a file of Lua table text: numbers, strings, booleans and tables, each with its place
// in the file. Invariant: a table's entries keep the order of the file; keys are strings or integers and each
// appears once.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cairn::scripting {

struct Entry;
using Entries = std::vector<Entry>;

/// Of a value that was made out of another file than one of table text: what its author sees, for messages.
struct ValueOrigin {
    std::string thing;    ///< `object 3 "crate" in layer "things"`
    std::string member;   ///< "width", `property "radius"`; empty: the thing itself
    std::string written;  ///< "-16 pixels"; empty: nothing that could be shown
    /// Of a number in another unit: value = offset + per_unit * what is written.
    std::string_view unit = {};
    double offset = 0;
    double per_unit = 1;
};

struct Value {
    /// In the order of the variant's alternatives.
    enum class Kind { Boolean, Integer, Number, String, Table };

    std::variant<bool, std::int64_t, double, std::string, Entries> content;
    int line = 0;  ///< from 1; 0: not from a file
    int column = 0;
    bool is_unreadable =
        false;  ///< stands for what was no data, which is told already; only for finding more faults
    std::shared_ptr<const ValueOrigin> origin = {};  ///< null: it was written as it is

    [[nodiscard]] Kind kind() const { return static_cast<Kind>(content.index()); }
    [[nodiscard]] bool is_number() const { return kind() == Kind::Integer || kind() == Kind::Number; }
    [[nodiscard]] double number() const;  ///< of an Integer or a Number
    [[nodiscard]] const std::string& text() const { return std::get<std::string>(content); }
    [[nodiscard]] const Entries& entries() const { return std::get<Entries>(content); }

    /// Of a table: the value at a key, or null.
    [[nodiscard]] const Value* find(std::string_view key) const;
    /// True for a table whose keys are exactly 1..n (also for the empty one).
    [[nodiscard]] bool is_list() const;
};

using Key = std::variant<std::int64_t, std::string>;

struct Entry {
    Key key;
    Value value;
};

/// Adds an entry to a table, which does not have it yet.
void add_entry(Value& table, std::string_view key, Value value);
/// Adds the next member to a list.
void add_item(Value& list, Value value);

/// "a number", "a string", "a table", ...: for messages.
std::string_view kind_with_article(Value::Kind kind);

/// The value as it would be written, shortened when it is long: for messages.
std::string to_short_text(const Value& value);

}  // namespace cairn::scripting
