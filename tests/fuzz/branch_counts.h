// How often each branch was taken since the input began, as the compiler has it counted. libFuzzer keeps the
// inputs that reach new counts.
#pragma once

#include <cstdint>
#include <vector>

namespace cairn::physics::fuzz {

std::vector<std::uint8_t> branch_counts();
void set_branch_counts(const std::vector<std::uint8_t>& counts);

}  // namespace cairn::physics::fuzz
