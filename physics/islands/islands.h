// Groups awake bodies joined by contacts or joints, to find the groups that may sleep.
// Invariant: each awake body is in exactly one island; an island sleeps only as a whole. Source: Tarjan 1975.
#pragma once

#include <span>
#include <vector>

#include "base/union_find.h"

namespace cairn::physics {

class Islands {
  public:
    /// Starts over with `count` bodies, each alone.
    void reset(int count);
    void link(int a, int b) { sets_.unite(a, b); }
    [[nodiscard]] bool together(int a, int b) { return sets_.find(a) == sets_.find(b); }

    /// Calls sleep(members) for each island whose every body has been at rest for at least `time_s`, in the
    /// order of their smallest members. `rest_times_s` is negative for bodies that may not sleep.
    template <class Sleep>
    void for_each_resting(std::span<const float> rest_times_s, float time_s, Sleep&& sleep) {
        collect(rest_times_s);
        for (int root = 0; root < count_; ++root) {
            if (first_[root] < 0 || shortest_rest_[root] < time_s) continue;
            members_.clear();
            for (int i = first_[root]; i >= 0; i = next_[i]) members_.push_back(i);
            sleep(std::span<const int>(members_));
        }
    }

  private:
    void collect(std::span<const float> rest_times_s);

    int count_ = 0;
    UnionFind sets_;
    std::vector<float> shortest_rest_;  // by root
    std::vector<int> first_;            // first member, by root; -1 for what is not a root
    std::vector<int> last_;
    std::vector<int> next_;  // next member of the same island
    std::vector<int> members_;
};

}  // namespace cairn::physics
