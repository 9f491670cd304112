// What authors who come from other frameworks call what Cairn has.
#pragma once

#include <span>
#include <string_view>

namespace cairn::scripting {

struct OtherWord {
    std::string_view words;  ///< in small letters with underscores: "hinge pin_joint"
    std::string_view names;  ///< as `cairn help` finds them: "world:add_revolute_joint sensor"
    std::string_view note;   ///< empty: none
};

/// From LÖVE, Box2D, Unity and Godot.
std::span<const OtherWord> other_words();
/// The entry that has the word, or nothing.
const OtherWord* other_word(std::string_view word);

}  // namespace cairn::scripting
