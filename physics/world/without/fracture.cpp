// Stands for fracture in a build without it: the world refuses to divide bodies and to make them breakable.
#include "world/breakables.h"
#include "world/features.h"
#include "world/fracture_plan.h"

namespace cairn::physics {

Result<std::vector<BodyId>> World::cut_body(BodyId, Position, Position) {
    return absence(Feature::Fracture);
}
Result<std::vector<BodyId>> World::break_body(BodyId, Position, const FractureDef&) {
    return absence(Feature::Fracture);
}
Result<std::vector<BodyId>> World::break_body(const BodyBreak&) {
    return absence(Feature::Fracture);
}
Result<void> World::set_breakable(BodyId, const BreakableDef&) {
    return absence(Feature::Fracture);
}
Result<void> World::clear_breakable(BodyId) {
    return absence(Feature::Fracture);
}
Result<std::optional<BreakableDef>> World::breakable(BodyId) const {
    return absence(Feature::Fracture);
}
std::span<const BodyBreak> World::body_breaks() const {
    return {};
}
Result<std::vector<CutHit>> World::cuts_along(Position, Position, QueryFilter) const {
    return absence(Feature::Fracture);
}

check::Fault validate(const BreakableDef&) {
    return absence(Feature::Fracture);
}
void forget_breakable(Stores&, int) {}
void find_overloads(const Stores&, const StepScratch&, Events&) {}
void break_overloaded(WorldState&) {}

}  // namespace cairn::physics
