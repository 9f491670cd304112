// Stands for snapshots and recordings in a build without them: nothing is written, and nothing goes back.
#include <cairn/physics/recording.h>
#include <cairn/physics/world.h>

#include "world/features.h"
#include "world/world_state.h"

namespace cairn::physics {

Result<void> World::snapshot(Snapshot&) const {
    return absence(Feature::Snapshots);
}
Result<Snapshot> World::snapshot() const {
    return absence(Feature::Snapshots);
}
Result<void> World::restore(std::span<const std::byte>) {
    return absence(Feature::Snapshots);
}
std::uint16_t World::tag() const {
    return state_->stores.bodies.slots.world_tag();
}

Result<void> make_delta(std::span<const std::byte>, std::span<const std::byte>, Snapshot&) {
    return absence(Feature::Snapshots);
}
Result<void> apply_delta(std::span<const std::byte>, std::span<const std::byte>, Snapshot&) {
    return absence(Feature::Snapshots);
}

Recording::Recording(int states_between_whole_ones) : between_(states_between_whole_ones) {}
Result<void> Recording::record(const World&) {
    return absence(Feature::Snapshots);
}
Result<void> Recording::seek(World&, int) {
    return absence(Feature::Snapshots);
}
Result<void> Recording::cut(int) {
    return absence(Feature::Snapshots);
}
Result<void> Recording::save(Snapshot&) const {
    return absence(Feature::Snapshots);
}
Result<void> Recording::load(std::span<const std::byte>) {
    return absence(Feature::Snapshots);
}

}  // namespace cairn::physics
