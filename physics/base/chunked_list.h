// A list that the chunks of a loop append to on several threads, and that is read in the order of the chunks.
// Invariant: what stands in it, and in which order, does not depend on who ran which chunk: each thread has a
// list of its own, and each chunk knows its part of one. So there are as many lists as threads, and not one
// for each chunk that grows in its own time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/ample.h"
#include "base/task_pool.h"

namespace cairn::physics {

template <class T>
class ChunkedList {
    struct Part {
        int worker = 0;
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    struct alignas(64) List {  // threads do not share cache lines
        std::vector<T> items;
    };

  public:
    /// Empties the list for a loop of the pool. Who takes how many chunks differs from loop to loop, so each
    /// thread has room for twice its share of the most that ever stood here: on two threads it is enough for
    /// as much again, whoever appends it.
    void start(int count, int grain, const TaskPool& tasks) {
        keep_room(tasks);
        for (List& list : lists_) list.items.clear();
        // Mostly as many as before, and few.
        const auto chunks = static_cast<std::size_t>(chunk_count(count, grain));
        if (parts_.size() != chunks) resize_amply(parts_, chunks);
        for (Part& part : parts_) part = {};
    }

    /// Empties it without a loop that would fill it.
    void clear(const TaskPool& tasks) {
        keep_room(tasks);
        parts_.clear();
    }

    /// What a chunk appends to; nothing else does meanwhile.
    class Appender {
      public:
        Appender(ChunkedList& list, const Chunk& chunk)
            : items_(list.lists_[chunk.worker].items), part_(list.parts_[chunk.index]) {
            part_.worker = chunk.worker;
            part_.begin = items_.size();
        }
        ~Appender() { part_.end = items_.size(); }
        Appender(const Appender&) = delete;
        Appender& operator=(const Appender&) = delete;

        [[nodiscard]] std::vector<T>& items() { return items_; }

      private:
        std::vector<T>& items_;
        Part& part_;
    };

    /// Calls visit(item) for all, in the order of the chunks.
    template <class Visit>
    void for_each(Visit&& visit) const {
        for (int p = 0; p < parts(); ++p) {
            for (const T& item : part(p)) visit(item);
        }
    }

    /// How many chunks it has parts of, for loops over them on several threads.
    [[nodiscard]] int parts() const { return static_cast<int>(parts_.size()); }
    [[nodiscard]] std::span<const T> part(int p) const {
        const Part& part = parts_[static_cast<std::size_t>(p)];
        return std::span(lists_[part.worker].items).subspan(part.begin, part.end - part.begin);
    }

    /// How many stand in it.
    [[nodiscard]] std::size_t size() const {
        std::size_t sum = 0;
        for (const Part& part : parts_) sum += part.end - part.begin;
        return sum;
    }

    void copy_to(std::vector<T>& all) const {
        all.clear();
        reserve_amply(all, size());
        for_each([&](const T& item) { all.push_back(item); });
    }

  private:
    void keep_room(const TaskPool& tasks) {
        const auto threads = static_cast<std::size_t>(tasks.threads());
        const std::size_t stood = size();
        if (stood <= most_ && lists_.size() >= threads) return;
        if (lists_.size() < threads) lists_.resize(threads);
        most_ = std::max(most_, stood);
        for (List& list : lists_) reserve_amply(list.items, std::min(most_, 2 * most_ / threads));
    }

    std::vector<List> lists_;  // by thread
    std::vector<Part> parts_;  // by chunk
    std::size_t most_ = 0;
};

}  // namespace cairn::physics
