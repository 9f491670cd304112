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

/// The candidate nearest to `word`; when more than a third of the letters of each differ, the one that has
/// most of its words in common with it ("circle" for "fill_circle", "position" for "getPosition"), or an
/// empty text.
std::string_view nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace cairn::scripting
