// What the torture cases found, as lines of JSON and as a table.
#pragma once

#include <string>
#include <string_view>

#include "torture/runner.h"

namespace cairn::lab {

/// {"case", "name", "passed", "figures": {...}, "limits": {...}, "cpu_ms", "engine"}, and "ended_by" when the
/// run did not come to its end.
std::string torture_line(const Case& test, std::string_view engine, const Outcome& outcome);
std::string torture_head();
/// A line for the case, and below it each figure with its limit; "!" stands before those that do not hold.
std::string torture_row(const Case& test, std::string_view engine, const Outcome& outcome);

}  // namespace cairn::lab
