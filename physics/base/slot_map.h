// Objects in slots that never move, found by generational handle.
// Invariant: a slot's generation grows each time its object goes; a slot whose generation is used up is never
// used again, so a stale handle can never name a newer object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/ample.h"
#include "base/assert.h"
#include "base/prefetch.h"

namespace cairn::physics {

inline constexpr int kNone = -1;  ///< "no such index", everywhere in the module

/// How often a slot was used, and whether it is in use. A single word, as bit fields are not: a slot that
/// goes is read right after it was written, which must not be in another size
/// (docs/adr/023-stores-before-loads.md).
struct SlotUse {
    static constexpr std::uint32_t kAlive = 0x80000000u;

    std::uint32_t word = 0;

    [[nodiscard]] constexpr bool alive() const { return (word & kAlive) != 0; }
    [[nodiscard]] constexpr std::uint32_t generation() const { return word & ~kAlive; }
};

template <class T, class Id>
class SlotMap {
  public:
    static constexpr std::uint32_t kMaxGeneration = 0xffffff;
    static constexpr int kMaxSlots = 0xfffffe;

    explicit SlotMap(std::uint16_t world_tag) : world_tag_(world_tag) {}

    [[nodiscard]] std::uint16_t world_tag() const { return world_tag_; }
    /// How many more objects it can hold.
    [[nodiscard]] std::size_t room() const { return kMaxSlots - slots_.size() + free_.size(); }
    [[nodiscard]] bool full() const { return free_.empty() && slots_.size() >= kMaxSlots; }

    /// The index of the new object's slot.
    int insert(T value) {
        const int index = insert();
        slots_[index].value = std::move(value);
        return index;
    }

    /// The same, for an object that is filled where it stands: put together elsewhere and copied it would
    /// wait for its own parts.
    int insert() {
        CAIRN_ASSERT(!full(), "a world holds too many objects of one kind");
        ++size_;
        if (free_.empty()) {
            push_amply(slots_, Slot{{SlotUse::kAlive}, T{}});
            free_.reserve(slots_.capacity());  // so that nothing that goes asks for memory
            return static_cast<int>(slots_.size()) - 1;
        }
        const int index = free_.back();
        free_.pop_back();
        // Where many are made at once, each would wait for a slot that was freed long ago.
        if (free_.size() >= kSlotsAhead) ask_for(free_[free_.size() - kSlotsAhead]);
        Slot& slot = slots_[index];
        slot.use.word |= SlotUse::kAlive;
        // Made where it stands: made elsewhere and copied it would wait for its own parts.
        std::destroy_at(&slot.value);
        std::construct_at(&slot.value);
        return index;
    }

    void erase(int index) {
        erase_as_is(index);
        slots_[index].value = T{};
    }

    /// Leaves the object as it is until its slot is used again: emptying it would wait for all that was
    /// written just before.
    void erase_as_is(int index) {
        Slot& slot = slots_[index];
        CAIRN_ASSERT(slot.use.alive(), "an object was erased twice");
        const std::uint32_t generation = slot.use.generation();
        const bool retires = generation == kMaxGeneration;
        slot.use.word = retires ? generation : generation + 1;
        --size_;
        if (!retires) free_.push_back(index);
    }

    [[nodiscard]] Id id(int index) const {
        return Id::make(static_cast<std::uint64_t>(index) + 1, slots_[index].use.generation(), world_tag_);
    }

    /// The slot that the handle names, or kNone for a null, stale or foreign one.
    [[nodiscard]] int find(Id id) const {
        const std::size_t index = id.index1 - std::size_t{1};  // of the null handle beyond all slots
        if (id.world != world_tag_ || index >= slots_.size()) return kNone;
        const Slot& slot = slots_[index];
        return slot.use.alive() && slot.use.generation() == id.generation ? static_cast<int>(index) : kNone;
    }

    T& operator[](int index) { return slots_[index].value; }
    const T& operator[](int index) const { return slots_[index].value; }
    /// Asks for the memory of an object that will be looked at soon; `size` bytes of it, if not all.
    void ask_for(int index, std::size_t size = sizeof(T)) const {
        prefetch(&slots_[index], sizeof(Slot) - sizeof(T) + size);
    }
    [[nodiscard]] bool alive(int index) const { return slots_[index].use.alive(); }
    /// One past the last slot in use; walk the slots with `alive`.
    [[nodiscard]] int end_index() const { return static_cast<int>(slots_.size()); }
    [[nodiscard]] int size() const { return size_; }

  private:
    friend struct StateAccess;
    template <class Map>
    friend class Lookup;

    struct Slot {
        SlotUse use;  // ahead of the value: both are looked at together
        T value;
    };

    // Free ones ahead of which memory is asked for.
    static constexpr std::size_t kSlotsAhead = 4;

    std::vector<Slot> slots_;
    std::vector<int> free_;  // the last one is used first
    int size_ = 0;
    std::uint16_t world_tag_;
};

}  // namespace cairn::physics
