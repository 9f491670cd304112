// Sorts 64-bit keys by counting digits, in time proportional to their number. Invariant: the result is that
// of any correct sort, since equal keys cannot be told apart. Source: Knuth, vol. 3, 5.2.5.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/ample.h"

namespace cairn::physics {

class RadixSort {
  public:
    void sort(std::vector<std::uint64_t>& keys) {
        if (keys.size() < kFewKeys) {
            std::sort(keys.begin(), keys.end());
            return;
        }
        // Digits in which all keys agree are passed over; in keys made of small numbers, most are.
        std::uint64_t varying = 0;
        for (const std::uint64_t key : keys) varying |= key ^ keys.front();
        resize_amply(other_, keys.size());
        starts_.resize(kDigits);
        for (int shift = 0; shift < 64 && varying >> shift != 0; shift += kDigitBits) {
            if ((varying >> shift & (kDigits - 1)) == 0) continue;
            std::fill(starts_.begin(), starts_.end(), 0);
            for (const std::uint64_t key : keys) ++starts_[key >> shift & (kDigits - 1)];
            std::uint32_t start = 0;
            for (std::uint32_t& s : starts_) start += std::exchange(s, start);
            for (const std::uint64_t key : keys) other_[starts_[key >> shift & (kDigits - 1)]++] = key;
            keys.swap(other_);
        }
    }

  private:
    static constexpr int kDigitBits = 11;  // counters then just fit the first-level cache with the keys
    static constexpr std::uint64_t kDigits = std::uint64_t{1} << kDigitBits;
    // Below this many keys a comparing sort is faster than clearing the counters.
    static constexpr std::size_t kFewKeys = 256;

    std::vector<std::uint64_t> other_;  // the keys go to and fro
    std::vector<std::uint32_t> starts_;
};

}  // namespace cairn::physics
