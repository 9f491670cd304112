// A set of unordered pairs of indices: open addressing with linear probing. It is only ever asked, never
// iterated, so its order cannot reach the simulation.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace cairn::physics {

class PairSet {
  public:
    /// False when the pair was there already.
    bool insert(int a, int b) {
        if ((size_ + 1) * 2 > slots_.size()) grow();
        const std::uint64_t key = make_key(a, b);
        for (std::size_t i = home(key);; i = (i + 1) & (slots_.size() - 1)) {
            if (slots_[i] == key) return false;
            if (slots_[i] == kEmpty) {
                slots_[i] = key;
                ++size_;
                return true;
            }
        }
    }

    [[nodiscard]] bool contains(int a, int b) const {
        if (slots_.empty()) return false;
        const std::uint64_t key = make_key(a, b);
        for (std::size_t i = home(key);; i = (i + 1) & (slots_.size() - 1)) {
            if (slots_[i] == key) return true;
            if (slots_[i] == kEmpty) return false;
        }
    }

    void erase(int a, int b) {
        if (slots_.empty()) return;
        const std::uint64_t key = make_key(a, b);
        const std::size_t mask = slots_.size() - 1;
        std::size_t hole = home(key);
        while (slots_[hole] != key) {
            if (slots_[hole] == kEmpty) return;
            hole = (hole + 1) & mask;
        }
        // Close the gap: what probed past the hole moves back into it, so no tombstones pile up.
        for (std::size_t i = (hole + 1) & mask; slots_[i] != kEmpty; i = (i + 1) & mask) {
            if (((i - home(slots_[i])) & mask) >= ((i - hole) & mask)) {
                slots_[hole] = slots_[i];
                hole = i;
            }
        }
        slots_[hole] = kEmpty;
        --size_;
    }

  private:
    static constexpr std::uint64_t kEmpty = 0;  // both indices 0 would be a pair of one thing with itself

    static std::uint64_t make_key(int a, int b) {
        if (a > b) std::swap(a, b);
        return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
    }
    [[nodiscard]] std::size_t home(std::uint64_t key) const {
        key *= 0x9e3779b97f4a7c15u;
        return (key ^ key >> 32) & (slots_.size() - 1);
    }
    void grow() {
        std::vector<std::uint64_t> old(slots_.empty() ? 64 : slots_.size() * 2, kEmpty);
        old.swap(slots_);
        for (const std::uint64_t key : old) {
            if (key == kEmpty) continue;
            std::size_t i = home(key);
            while (slots_[i] != kEmpty) i = (i + 1) & (slots_.size() - 1);
            slots_[i] = key;
        }
    }

    std::vector<std::uint64_t> slots_;
    std::size_t size_ = 0;
};

}  // namespace cairn::physics
