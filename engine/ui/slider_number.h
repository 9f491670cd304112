// The number beside a slider's track. Invariant: its place is as wide as the widest that it can show, so that
// the text beside it stays where it is.
#pragma once

#include <string>

#include <cairn/engine/renderer.h>
#include <cairn/engine/ui.h>

namespace cairn::engine {

/// Logical pixels between a text and what stands beside it.
inline constexpr float kTextGap = 16;

/// As few digits as the steps of a slider need.
std::string number_text(double value, double step);

/// Logical pixels that the number takes.
float number_width(const Renderer& renderer, FontId font, const Widget& slider);

}  // namespace cairn::engine
