// Owns values that are known outside by a typed handle.
// Invariant: a slot's generation grows whenever its value is erased, so an old handle never finds a new
// value.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <cairn/engine/handle.h>

namespace cairn::engine {

template <typename Id, typename T>
class HandleTable {
  public:
    Id insert(T value) {
        if (free_.empty()) {
            free_.push_back(static_cast<std::uint32_t>(slots_.size()));
            slots_.emplace_back();
        }
        const std::uint32_t index = free_.back();
        free_.pop_back();
        slots_[index].value = std::move(value);
        return {index, slots_[index].generation};
    }

    /// Null for a null or stale handle.
    T* find(Id id) {
        if (id.is_null() || id.index >= slots_.size()) return nullptr;
        Slot& slot = slots_[id.index];
        return slot.generation == id.generation && slot.value ? &*slot.value : nullptr;
    }
    const T* find(Id id) const { return const_cast<HandleTable*>(this)->find(id); }

    void erase(Id id) {
        if (!find(id)) return;
        Slot& slot = slots_[id.index];
        slot.value.reset();
        // A slot that has used up its generations is retired: one in four billion may leak, none may come
        // back.
        if (++slot.generation != 0) free_.push_back(id.index);
    }

    template <typename Visit>
    void for_each(Visit&& visit) {
        for (std::uint32_t i = 0; i < slots_.size(); ++i)
            if (slots_[i].value) visit(Id{i, slots_[i].generation}, *slots_[i].value);
    }

  private:
    struct Slot {
        std::optional<T> value;
        std::uint32_t generation = 1;
    };

    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
};

}  // namespace cairn::engine
