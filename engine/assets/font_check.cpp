#include "assets/font_check.h"

#include <algorithm>
#include <cstdint>

namespace cairn::engine {
namespace {

// Numbers have their highest byte first.
std::uint64_t number_at(std::span<const std::byte> file, std::size_t at, std::size_t bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | std::to_integer<std::uint64_t>(file[at + i]);
    return value;
}

}  // namespace

std::string font_fault(std::span<const std::byte> file) {
    constexpr std::size_t kHeader = 12, kRecord = 16, kTables = 4, kOffset = 8, kLength = 12;
    constexpr std::uint64_t kTrueType = 0x00010000, kOpenType = 0x4f54544f, kAppleTrueType = 0x74727565;
    if (file.size() < kHeader) return "";
    const std::uint64_t format = number_at(file, 0, 4);
    if (format != kTrueType && format != kOpenType && format != kAppleTrueType) return "";
    const std::size_t directory_end = kHeader + kRecord * number_at(file, kTables, 2);
    std::uint64_t end = directory_end;
    for (std::size_t record = kHeader; record + kRecord <= std::min(directory_end, file.size());
         record += kRecord) {
        end = std::max(end, number_at(file, record + kOffset, 4) + number_at(file, record + kLength, 4));
    }
    if (end <= file.size()) return "";
    return "is cut off: its tables should end at byte " + std::to_string(end) + ", and it has " +
           std::to_string(file.size());
}

}  // namespace cairn::engine
