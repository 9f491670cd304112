// What the program asks of operator new, which this replaces for the whole program. Counts every thread.
// Invariant: `live_bytes` is what was allocated and not yet freed, as large as the C library made it.
#pragma once

#include <cstdint>

namespace cairn::measure {

std::int64_t allocations();  ///< calls of operator new so far
std::int64_t live_bytes();
/// The most that lived at once since the last `restart_peak`.
std::int64_t peak_bytes();
void restart_peak();

}  // namespace cairn::measure
