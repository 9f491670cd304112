// Lists that the chunks of a loop fill. What one of them once needed, any of them may need later.
#pragma once

#include <algorithm>
#include <vector>

#include "base/task_pool.h"

namespace cairn::physics {

/// Empties the lists for a loop, and gives all of them the room of the largest: each would grow to it in its
/// own time otherwise, and steps would go on allocating long after the first.
template <class T>
void start_lists(PerChunk<std::vector<T>>& lists, int count, int grain) {
    lists.fit(count, grain);
    std::size_t most = 0;
    for (int chunk = 0; chunk < lists.size(); ++chunk) most = std::max(most, lists[chunk].capacity());
    for (int chunk = 0; chunk < lists.size(); ++chunk) {
        lists[chunk].clear();
        lists[chunk].reserve(most);
    }
}

}  // namespace cairn::physics
