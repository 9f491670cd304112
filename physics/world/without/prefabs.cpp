// Stands for the prefabs in a build without them: none can be made, so none can be driven. What destroys them
// is there (prefabs/builder.cpp), since a prefab is plain data that anyone may fill.
#include <cairn/physics/prefabs/all.h>

#include "world/features.h"

namespace cairn::physics {

Result<Blob> create_blob(World&, const BlobDef&) {
    return absence(Feature::Prefabs);
}
Result<BrickWall> create_brick_wall(World&, const BrickWallDef&) {
    return absence(Feature::Prefabs);
}
Result<Bridge> create_bridge(World&, const BridgeDef&) {
    return absence(Feature::Prefabs);
}
Result<Elevator> create_elevator(World&, const ElevatorDef&) {
    return absence(Feature::Prefabs);
}
Result<GearTrain> create_gear_train(World&, const GearTrainDef&) {
    return absence(Feature::Prefabs);
}
Result<LinkChain> create_link_chain(World&, const LinkChainDef&) {
    return absence(Feature::Prefabs);
}
Result<Pendulum> create_pendulum(World&, const PendulumDef&) {
    return absence(Feature::Prefabs);
}
Result<PulleyLift> create_pulley_lift(World&, const PulleyLiftDef&) {
    return absence(Feature::Prefabs);
}
Result<Ragdoll> create_ragdoll(World&, const RagdollDef&) {
    return absence(Feature::Prefabs);
}
Result<Rope> create_rope(World&, const RopeDef&) {
    return absence(Feature::Prefabs);
}
Result<Vehicle> create_vehicle(World&, const VehicleDef&) {
    return absence(Feature::Prefabs);
}
Result<Windmill> create_windmill(World&, const WindmillDef&) {
    return absence(Feature::Prefabs);
}

Result<void> send_elevator(World&, const Elevator&, int) {
    return absence(Feature::Prefabs);
}
Result<bool> is_elevator_at(const World&, const Elevator&, int) {
    return absence(Feature::Prefabs);
}
Result<void> drive_vehicle(World&, const Vehicle&, float) {
    return absence(Feature::Prefabs);
}
Result<void> brake_vehicle(World&, const Vehicle&) {
    return absence(Feature::Prefabs);
}
Result<void> coast_vehicle(World&, const Vehicle&) {
    return absence(Feature::Prefabs);
}
Result<void> blow_windmill(World&, const Windmill&, const WindDef&, float) {
    return absence(Feature::Prefabs);
}

}  // namespace cairn::physics
