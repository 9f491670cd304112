// JSON from files that anybody may have written. Invariant: no exception leaves, and nothing is nested so
// deep that walking it takes more stack than there is.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include <cairn/engine/result.h>

namespace cairn::engine {

/// Objects and lists in each other, or elements of XML. Tiled's groups take two levels each, and nobody nests
/// 100.
inline constexpr int kMaxNesting = 200;

/// The error begins with "is": "is not JSON: ...".
Result<nlohmann::ordered_json> json_from_text(std::string_view text);

/// The member in which the objects of `json_with_lines` keep the line on which they begin, from 1.
inline constexpr const char* kLineMember = "#line";

/// The same of a file whose faults are told with their lines. A member that the text calls so is lost. What
/// is no JSON is told without its line, which `fault_line` gets.
Result<nlohmann::ordered_json> json_with_lines(std::string_view text, int& fault_line);

/// The first 40 bytes of a value, or what kind of thing it is, for messages.
std::string excerpt(const nlohmann::ordered_json& value);

}  // namespace cairn::engine
