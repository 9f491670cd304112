// Pair finding by a query of both trees for each moved box.
#include "broad/broad_phase.h"

#include <algorithm>

namespace cairn::physics {

int BroadPhase::add(Layer layer, const Aabb& box, int item) {
    const int proxy = trees_[index(layer)].insert(box, item);
    touch(layer, proxy);
    return proxy;
}

void BroadPhase::remove(Layer layer, int proxy) {
    trees_[index(layer)].remove(proxy);
    is_moved_[index(layer)][proxy] = 0;
}

void BroadPhase::move(Layer layer, int proxy, const Aabb& box) {
    trees_[index(layer)].move(proxy, box);
    touch(layer, proxy);
}

void BroadPhase::touch(Layer layer, int proxy) {
    auto& flags = is_moved_[index(layer)];
    if (flags.size() <= static_cast<std::size_t>(proxy)) flags.resize(proxy + 1, 0);
    if (flags[proxy]) return;
    flags[proxy] = 1;
    moved_.push_back({layer, proxy});
}

const std::vector<std::pair<int, int>>& BroadPhase::find_new_pairs() {
    pairs_.clear();
    for (const Moved& m : moved_) {
        // A proxy removed since, or removed and given out again (then it stands further down the list too).
        auto& flag = is_moved_[index(m.layer)][m.proxy];
        if (!flag) continue;
        flag = 0;
        const AabbTree& own = trees_[index(m.layer)];
        const int item = own.item(m.proxy);
        const auto report = [&](int other) {
            if (other != item) pairs_.emplace_back(std::min(item, other), std::max(item, other));
        };
        trees_[index(Layer::Moving)].query(own.box(m.proxy), report);
        if (m.layer == Layer::Moving) trees_[index(Layer::Fixed)].query(own.box(m.proxy), report);
    }
    moved_.clear();
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return pairs_;
}

}  // namespace cairn::physics
