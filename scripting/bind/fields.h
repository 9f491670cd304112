// Tables with described fields: `world:add_box{ width = 1, height = 2 }`. The description gives the checks,
// the defaults and the reference. Invariant: a table with a field that is not described is refused, with the
// nearest name that is.
#pragma once

#include <array>
#include <lua.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bind/range.h"

namespace cairn::scripting {

enum class FieldType {
    Number,
    Integer,
    Boolean,
    String,
    Table,
    Points,  ///< { {x, y}, ... }
    Function,
    Body,
    Joint
};

struct Field {
    const char* name;
    FieldType type;
    /// As text: "0.6", "true", "dynamic"; null: the field is required; empty: absent unless given.
    const char* default_text;
    const char* doc;
    double default_number = 0;
    /// Of numbers given by the author.
    Range range = {};
    /// Of a string: the words that it may be, with blanks between them; empty: any.
    std::string_view choices = {};
};

/// Fields that belong together; those of `includes` belong to it too.
struct FieldSet {
    std::span<const Field* const> own;
    std::array<const FieldSet*, 3> includes{};
};

/// Every field of a set, included ones last.
std::vector<const Field*> all_fields(const FieldSet& set);

constexpr Field number_field(const char* name, double default_value, const char* default_text,
                             const char* doc) {
    return {name, FieldType::Number, default_text, doc, default_value};
}
constexpr Field integer_field(const char* name, double default_value, const char* default_text,
                              const char* doc) {
    return {name, FieldType::Integer, default_text, doc, default_value};
}
constexpr Field boolean_field(const char* name, bool default_value, const char* doc) {
    return {name, FieldType::Boolean, default_value ? "true" : "false", doc, default_value ? 1.0 : 0.0};
}
constexpr Field required_field(const char* name, FieldType type, const char* doc) {
    return {name, type, nullptr, doc};
}
constexpr Field optional_field(const char* name, FieldType type, const char* doc) {
    return {name, type, "", doc};
}

/// The same field for the numbers of a range.
constexpr Field within(Field field, const Range& range) {
    field.range = range;
    return field;
}
constexpr Field within(Field field, double low, double high) {
    return within(field, Range{low, high});
}
constexpr Field at_least(Field field, double low) {
    return within(field, low, field.range.high);
}
/// The same field for numbers greater than `low`.
constexpr Field above(Field field, double low, double high = std::numeric_limits<double>::max()) {
    return within(field, Range{low, high, true});
}

/// A string that is one of some words; the default is one of them.
constexpr Field choice_field(const char* name, const char* default_text, std::string_view choices,
                             const char* doc) {
    Field field{name, FieldType::String, default_text, doc};
    field.choices = choices;
    return field;
}
/// The words of `choices`.
std::vector<std::string> words_of(std::string_view choices);
/// "must be above 0 and at most 2000000".
std::string range_rule(const Field& field);
/// Whether a number lies in the field's range.
bool is_in_range(const Field& field, double value);

/// "a number", "a body", ...: for messages.
const char* field_type_with_article(FieldType type);
/// "number", "Body", ...: for annotations.
const char* field_type_name(FieldType type);

/// Reads the table at an index. Every error names the binding, the field, the value and the rule.
class FieldReader {
  public:
    /// Raises for a field that the set does not describe.
    FieldReader(lua_State* L, int index, const FieldSet& set);

    [[nodiscard]] lua_State* lua() const { return L_; }
    [[nodiscard]] double number(const Field& field) const;
    [[nodiscard]] float real(const Field& field) const { return static_cast<float>(number(field)); }
    [[nodiscard]] std::int64_t integer(const Field& field) const;
    [[nodiscard]] bool boolean(const Field& field) const;
    /// Of an optional field: nothing when it is absent.
    [[nodiscard]] std::optional<double> optional_number(const Field& field) const;
    /// Valid as long as the table holds it.
    [[nodiscard]] std::string_view text(const Field& field) const;
    /// Which of the field's choices it is, from 0.
    [[nodiscard]] std::size_t choice(const Field& field) const;
    [[nodiscard]] bool has(const Field& field) const;

    /// Pushes the value after checking its type; false, with nothing pushed, when the field is absent.
    bool push(const Field& field) const;

    /// Raises "NAME: field = VALUE: rule".
    [[noreturn]] void fail(const Field& field, const std::string& rule) const;

  private:
    /// Pops a number, after checking that it lies in the field's range.
    double take_number(const Field& field) const;

    lua_State* L_;
    int index_;
};

/// The value at an index as a message shows it: 12, "text", nil, a table, a Body.
std::string describe_value(lua_State* L, int index);

}  // namespace cairn::scripting
