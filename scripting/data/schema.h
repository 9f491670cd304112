// Rules for data: what a level file or another table may hold. A schema is itself described by a table (see
// cairn.data in the Lua reference). Invariant: check_data never changes the data; defaults are filled in by a
// separate walk.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cairn/engine/result.h>

#include "data/value.h"

namespace cairn::scripting {

enum class SchemaType { Any, Number, Integer, String, Boolean, Table, List };

/// "number", "list", ...; the names that a schema may use.
const std::vector<std::string>& schema_type_names();
std::optional<SchemaType> schema_type_from_name(std::string_view name);

struct SchemaField;

struct Schema {
    SchemaType type = SchemaType::Any;
    bool required = false;
    std::optional<Value> default_value;
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    double above = -std::numeric_limits<double>::infinity();  ///< the value is greater than this
    std::size_t min_length = 0;                               ///< of a string (bytes) or a list
    std::size_t max_length = std::numeric_limits<std::size_t>::max();
    std::string what;                 ///< what a value is called in messages: "material"
    std::vector<std::string> one_of;  ///< sorted; empty: any
    std::vector<SchemaField> fields;  ///< of a table, sorted by name; others are faults
    bool has_fields = false;          ///< a table without `fields` may hold anything
    std::unique_ptr<Schema> items;    ///< of a list's members
    /// A rule of the game's own: gives a sentence saying what is wrong, or nothing.
    std::function<std::optional<std::string>(const Value&)> check;
};

struct SchemaField {
    std::string name;
    Schema schema;
};

/// One thing that is wrong, as "FILE:LINE: pieces[3].width = -1: must be above 0".
/// `name` is the file's name; values without a line leave the place out.
std::vector<std::string> check_data(const Value& value, const Schema& schema, const std::string& name);

/// Adds the defaults of fields that are absent.
void fill_defaults(Value& value, const Schema& schema);

}  // namespace cairn::scripting
