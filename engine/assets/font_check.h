// Whether a font's file is whole: readers of fonts miss a table only where a character needs it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace cairn::engine {

/// What is wrong with the directory of a TrueType or OpenType file; empty: nothing, or another format.
/// Source: OpenType specification 1.9, "Organization of an OpenType Font".
std::string font_fault(std::span<const std::byte> file);

}  // namespace cairn::engine
