// Finds what somebody probably meant to type.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <cairn/scripting/suggest.h>

namespace cairn::scripting {

/// The number of letters to insert, remove, replace or swap with their neighbour that turns one word into the
/// other. Source: Damerau 1964, restricted to one edit per place ("optimal string alignment").
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, or an empty text when none is near: more than a third of its letters
/// differ.
std::string_view nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace cairn::scripting
