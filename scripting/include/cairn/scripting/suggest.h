// Suggestions for names that do not exist, in the words of all of Cairn's messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cairn::scripting {

/// `; did you mean "NEAREST"?` or nothing, then ` (all, of, them)`.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace cairn::scripting
