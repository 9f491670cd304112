// Which domain bodies are in. What domains are for: world/domains.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/colored_runs.h"

namespace cairn::physics {

/// By what bodies are told apart: strips of space, or the order in which they were made.
enum class DividedBy : std::uint8_t { Slots, X, Y };

/// Each holds about as many bodies. Which one a body is in is settled when it gets its first contact or joint
/// in a colour, and again now and then (world/domains.h), so that a body may have left it.
struct Domains {
    int count = 0;  // 0: none, all contacts and joints are of the interface
    DividedBy by = DividedBy::Slots;
    std::array<double, kMostDomains - 1> cuts{};  // between them, ascending; slots or m
    std::vector<std::uint8_t> of_body;            // by slot, from 1 on; of bodies that are moved in a colour
};

}  // namespace cairn::physics
