// The slots of objects as bytes: which are alive, how often each was used, as runs of slots that are alike,
// and in which order the free ones will be used again. The objects themselves are written by their own parts,
// in the order of the slots.
#pragma once

#include "state/access.h"
#include "state/bytes.h"

namespace cairn::physics {

/// m. No geometry is larger, with room to spare; numbers beyond it would make boxes infinite.
inline constexpr float kMostExtent_m = 1e7f;

inline bool is_within_reach(Vec2 point) {
    return std::fabs(point.x) <= kMostExtent_m && std::fabs(point.y) <= kMostExtent_m;
}

template <class Map>
void save_slots(const Map& map, Writer& out) {
    StateAccess::slots(map, [&](const auto& slots, const std::vector<int>& free, int) {
        std::byte* at = out.room(sizeof(std::uint32_t) * (2 + 2 * slots.size() + free.size()));
        at = put(at, static_cast<std::uint32_t>(slots.size()));
        const auto word = [&](std::size_t i) { return slots[i].use.word; };
        for (std::size_t first = 0; first < slots.size();) {
            std::size_t end = first + 1;
            while (end < slots.size() && word(end) == word(first)) ++end;
            at = put(put(at, static_cast<std::uint32_t>(end - first)), word(first));
            first = end;
        }
        at = put(at, static_cast<std::uint32_t>(free.size()));
        for (auto slot = free.rbegin(); slot != free.rend(); ++slot) at = put(at, *slot);
        out.end(at);
    });
}

/// Slots that are alive keep whatever they held: the caller writes all of it anew.
template <class Map>
void load_slots(Reader& in, Map& map) {
    StateAccess::slots(map, [&](auto& slots, std::vector<int>& free, int& size) {
        // Of each slot more follows: what it holds, or its place among the free ones. So few bytes cannot ask
        // for much memory.
        const std::size_t count = in.count(1);
        if (!in.require(count <= static_cast<std::size_t>(Map::kMaxSlots), "there are too many slots"))
            return;
        slots.resize(count);
        size = 0;
        const decltype(slots.front().value) gone{};
        for (auto slot = slots.begin(); slot != slots.end();) {
            std::uint32_t length = 0;
            SlotUse use;
            in.value(length);
            in.value(use.word);
            const bool alive = use.alive();
            const bool fits = length > 0 && length <= static_cast<std::size_t>(slots.end() - slot);
            if (!in.require(fits && use.generation() <= Map::kMaxGeneration,
                            "slots are more than there are, or were used more often than slots are"))
                return;
            const auto end = slot + length;
            for (; slot != end; ++slot) {
                slot->use = use;
                if (!alive) slot->value = gone;
            }
            size += alive ? static_cast<int>(length) : 0;
        }
        free.resize(in.count(sizeof(int)));
        free.reserve(slots.capacity());
        // Each is taken for alive until all are read, so that none is listed twice.
        auto next = free.rbegin();
        for (; next != free.rend(); ++next) {
            in.value(*next);
            const auto at = static_cast<std::size_t>(*next);  // negative ones are beyond all
            if (at >= count || slots[at].use.alive()) break;
            slots[at].use.word |= SlotUse::kAlive;
        }
        const bool all_free = next == free.rend();
        while (next != free.rbegin()) slots[static_cast<std::size_t>(*--next)].use.word &= ~SlotUse::kAlive;
        in.require(all_free, "the list of free slots names one that is not free");
    });
}

/// The objects of a map, to look many up by indices that may be nonsense. Valid until the map grows.
template <class Map>
class Lookup {
  public:
    explicit Lookup(Map& map) {
        StateAccess::slots(map, [&](auto& slots, auto&, auto&) {
            slots_ = slots.data();
            count_ = slots.size();
        });
    }

    /// Null when there is no such object.
    [[nodiscard]] auto find(int index) const {
        const auto at = static_cast<std::size_t>(index);  // negative ones are beyond all
        return at < count_ && slots_[at].use.alive() ? &slots_[at].value : nullptr;
    }

  private:
    typename Map::Slot* slots_ = nullptr;
    std::size_t count_ = 0;
};

/// Whether an index names an object.
template <class Map>
bool names(const Map& map, int index) {
    return index >= 0 && index < map.end_index() && map.alive(index);
}

}  // namespace cairn::physics
