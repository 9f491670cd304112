// Writes data values as Lua table text that table_parser.h reads back unchanged.
#pragma once

#include <string>
#include <string_view>

#include "data/value.h"

namespace cairn::scripting {

/// One value as text; tables are indented by four spaces, lists of plain values stay on one line.
std::string to_table_text(const Value& value);

/// A whole file: `return { ... }` and a newline.
std::string to_table_file(const Value& value);

/// The text in double quotes, with escapes.
std::string quote_text(std::string_view text);

/// A name in a path of fields: as it is, or in quotes where some of it cannot be shown.
std::string shown_name(std::string_view name);

}  // namespace cairn::scripting
