// Compiled without counts of its own: a file that has them may not speak of these symbols, which the compiler
// makes.
#include "fuzz/branch_counts.h"

#include <algorithm>

// The ends of all counts of the program, by the linker.
extern std::uint8_t first_count __asm__("__start___sancov_cntrs");
extern std::uint8_t behind_last_count __asm__("__stop___sancov_cntrs");

namespace cairn::physics::fuzz {

std::vector<std::uint8_t> branch_counts() {
    return {&first_count, &behind_last_count};
}

void set_branch_counts(const std::vector<std::uint8_t>& counts) {
    std::ranges::copy(counts, &first_count);
}

}  // namespace cairn::physics::fuzz
