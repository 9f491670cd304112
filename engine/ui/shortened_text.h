// Texts that must fit a place. Invariant: what is given is the text itself if it fits, and else no wider than
// the place: as much of it as there is room for, and an ellipsis where something is missing.
#pragma once

#include <string>

#include <cairn/engine/renderer.h>

namespace cairn::engine {

/// Which end of a text that is too long is seen.
enum class KeptEnd { Front, Back };

/// One line. Without room for the ellipsis it is empty.
std::string shortened_text(const Renderer& renderer, FontId font, const std::string& text, float width,
                           KeptEnd kept = KeptEnd::Front);

}  // namespace cairn::engine
