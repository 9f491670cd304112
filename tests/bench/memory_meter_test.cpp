// What is allocated is counted, and what is freed is taken off again.
#include "memory_meter.h"

#include <catch2/catch.hpp>
#include <memory>
#include <vector>

namespace cairn::measure {

TEST_CASE("live bytes follow what is allocated and freed, and the peak stays") {
    const std::int64_t calls = allocations();
    const std::int64_t before = live_bytes();
    restart_peak();
    auto block = std::make_unique<std::vector<double>>(1000);
    const std::int64_t with_block = live_bytes() - before;
    const std::int64_t made = allocations() - calls;
    block.reset();
    const std::int64_t after = live_bytes() - before;
    const std::int64_t peak = peak_bytes() - before;
    CHECK(made == 2);
    CHECK(with_block >= 8000);
    CHECK(with_block < 8200);  // the C library rounds up
    CHECK(after == 0);
    CHECK(peak == with_block);
}

TEST_CASE("memory of a wider alignment is counted too") {
    struct alignas(64) Line {
        char bytes[64];
    };
    const std::int64_t before = live_bytes();
    auto lines = std::make_unique<std::vector<Line>>(10);
    const std::int64_t with_lines = live_bytes() - before;
    lines.reset();
    const std::int64_t after = live_bytes() - before;
    CHECK(with_lines >= 640);
    CHECK(after == 0);
}

}  // namespace cairn::measure
