// Items in groups: added in any order of the groups, then sorted by group, each group in the order of adding.
// Kept from step to step for its memory. Source: counting sort.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/ample.h"

namespace cairn::physics {

template <class T>
class Grouped {
  public:
    void clear() {
        added_.clear();
        groups_.clear();
        first_.clear();
    }
    void add(int group, const T& item) {
        push_amply(added_, item);
        push_amply(groups_, group);
    }
    /// Into groups 0 up to, and without, `groups`.
    void sort(int groups) {
        assign_amply(first_, static_cast<std::size_t>(groups) + 1, 0);
        for (const int group : groups_) ++first_[static_cast<std::size_t>(group) + 1];
        for (std::size_t group = 1; group < first_.size(); ++group) first_[group] += first_[group - 1];
        next_.assign(first_.begin(), first_.end());
        resize_amply(sorted_, added_.size());
        for (std::size_t i = 0; i < added_.size(); ++i) {
            const int at = next_[static_cast<std::size_t>(groups_[i])]++;
            sorted_[static_cast<std::size_t>(at)] = added_[i];
        }
    }
    /// As of the last `sort`; the places of the group among all.
    [[nodiscard]] int first(int group) const { return first_[static_cast<std::size_t>(group)]; }
    [[nodiscard]] int last(int group) const { return first_[static_cast<std::size_t>(group) + 1]; }
    [[nodiscard]] std::span<const T> of(int group) const {
        return std::span(sorted_).subspan(static_cast<std::size_t>(first(group)),
                                          static_cast<std::size_t>(last(group) - first(group)));
    }
    [[nodiscard]] std::span<const T> sorted() const { return sorted_; }

  private:
    std::vector<T> added_;
    std::vector<int> groups_;  // beside them
    std::vector<T> sorted_;
    std::vector<int> first_;
    std::vector<int> next_;
};

}  // namespace cairn::physics
