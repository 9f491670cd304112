// Comparison of places with those of the step before.
#include "world/unmoved.h"

#include <algorithm>
#include <atomic>

#include "base/ample.h"
#include "base/standing.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kRowsPerChunk = 1024;

}  // namespace

void Unmoved::make_room(int rows) {
    const auto count = static_cast<std::size_t>(rows);
    reserve_amply(bodies_, count);
    reserve_amply(places_, count);
    reserve_amply(rows_, count);
}

void Unmoved::compare(std::span<const Place> places, std::span<const int> bodies, const Motions& motions,
                      const Surroundings& now, TaskPool& tasks) {
    const bool same = is_known_ && seen_ == now && std::ranges::equal(bodies_, bodies);
    const auto count = static_cast<std::size_t>(motions.size());
    if (!same) {
        resize_amply(bodies_, bodies.size());
        std::ranges::copy(bodies, bodies_.begin());
        resize_amply(places_, count);
        resize_amply(rows_, count);
    }
    rows_[kWorldRow] = 1;
    std::atomic<int> unmoved = 0;
    tasks.parallel_for(static_cast<int>(bodies.size()), kRowsPerChunk, [&](const Chunk& chunk) {
        int found = 0;
        for (int i = chunk.begin; i < chunk.end; ++i) {
            const Place& place = places[bodies[i]];
            const int row = i + 1;
            Seen& seen = places_[row];
            const bool keeps_boxes = (place.flags & place_flag::kBoxesMoved) == 0;
            const bool stands = same && keeps_boxes && seen.center == place.center &&
                                seen.rotation == place.rotation && is_still(motions, row);
            seen = {place.center, place.rotation};
            rows_[row] = stands ? 1 : 0;
            found += stands ? 1 : 0;
        }
        unmoved.fetch_add(found, std::memory_order_relaxed);
    });
    some_ = unmoved > 0;
    all_ = some_ && unmoved == static_cast<int>(bodies.size());
    is_known_ = true;
    seen_ = now;
}

}  // namespace cairn::physics
