// Threads the members of each island into a list, in ascending order.
#include "islands/islands.h"

#include <algorithm>

#include "base/ample.h"

namespace cairn::physics {

void Islands::reset(int count) {
    count_ = count;
    sets_.reset(count);
}

void Islands::collect(std::span<const float> rest_times_s) {
    const auto count = static_cast<std::size_t>(count_);
    assign_amply(first_, count, -1);
    assign_amply(last_, count, -1);
    assign_amply(next_, count, -1);
    resize_amply(shortest_rest_, count);
    for (int i = 0; i < count_; ++i) {
        const int root = sets_.find(i);
        if (first_[root] < 0) {
            first_[root] = i;
            shortest_rest_[root] = rest_times_s[i];
        } else {
            next_[last_[root]] = i;
            shortest_rest_[root] = std::min(shortest_rest_[root], rest_times_s[i]);
        }
        last_[root] = i;
    }
}

}  // namespace cairn::physics
