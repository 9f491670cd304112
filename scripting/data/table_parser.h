// Reads Lua table text as data: `return { ... }` or `{ ... }` with numbers, strings, booleans, nested tables
// and comments. Invariant: nothing is ever executed; whatever is not plain data (names, calls, operators) is
// an error with its place. Source: Lua 5.4 Reference Manual, 3.1 (lexical conventions) and 3.4.9 (table
// constructors).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/result.h>

#include "data/value.h"

namespace cairn::scripting {

/// How deep tables may be nested: more is an accident or an attack on the stack.
inline constexpr int kMaxTableDepth = 64;

/// Errors read "NAME:LINE:COLUMN: what is wrong".
engine::Result<Value> parse_table_text(std::string_view text, std::string_view name);

/// The same for whoever looks for all faults: names, sums and calls where data should be do not end the
/// reading. They are added to `faults`, and an unreadable value stands for each.
engine::Result<Value> parse_faulty_table_text(std::string_view text, std::string_view name,
                                              std::vector<std::string>& faults);

}  // namespace cairn::scripting
