// What a world went through, state by state: to be played back, and to be gone back into at any step.
//
// Each state is kept as its difference from the one before, and now and then whole; so every state that was
// recorded can be had again, bit for bit, whatever was done to the world between the steps, and also when the
// recording was written to a file and is read on another machine (docs/adr/013-snapshots.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <cairn/physics/result.h>
#include <cairn/physics/state.h>

namespace cairn::physics {

class World;

/// What turns one snapshot into another. Small when little differs: blocks that are equal take a bit each.
/// `base` must be at hand to apply it, the very bytes: an error otherwise.
Result<void> make_delta(std::span<const std::byte> base, std::span<const std::byte> target, Snapshot& delta);
Result<void> apply_delta(std::span<const std::byte> base, std::span<const std::byte> delta, Snapshot& target);

class Recording {
  public:
    /// Every so many states one is kept whole, >= 1: seeking applies at most so many differences.
    explicit Recording(int states_between_whole_ones = 60);

    /// Appends the state of the world as it is now. Call it after each step, and once before the first.
    Result<void> record(const World& world);
    /// How many states there are.
    [[nodiscard]] int size() const { return static_cast<int>(states_.size()); }
    /// In memory, and about as much in a file.
    [[nodiscard]] std::size_t byte_count() const { return bytes_.size(); }
    /// Puts the world into state `index`, 0 <= index < size().
    Result<void> seek(World& world, int index);
    /// Forgets the states from `index` on: to record another future from there.
    Result<void> cut(int index);

    /// Bytes for a file, with version and checksum.
    Result<void> save(Snapshot& into) const;
    /// An error for bytes that are damaged, of another version or no recording; then nothing has changed.
    Result<void> load(std::span<const std::byte> bytes);

  private:
    struct State {
        std::uint64_t first_byte = 0;
        bool is_whole = false;
    };

    [[nodiscard]] std::span<const std::byte> bytes_of(int index) const;
    Result<std::span<const std::byte>> snapshot_of(int index);

    int between_;
    std::vector<State> states_;
    std::vector<std::byte> bytes_;
    // The snapshot that was put together last, of state `current_`; the other is for putting together.
    Snapshot snapshot_;
    Snapshot other_;
    Snapshot delta_;
    int current_ = -1;
};

}  // namespace cairn::physics
