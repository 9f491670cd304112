// Comparison of what acts with what acted in the step before.
#include "world/resting.h"

#include <algorithm>

#include "base/ample.h"

namespace cairn::physics {

Resting::Acting Resting::acting_on(const Motions& motions, int row) {
    const VelocityRow& kick = motions.kick[row];
    const VelocityRow kept = motions.kept.empty() ? VelocityRow{{1, 1}, 1, 1} : motions.kept[row];
    return {kick.v,
            kick.w,
            kept.v.x,
            kept.w,
            motions.velocity[row].inverse_mass,
            motions.pose[row].k,
            motions.rounding_m_s[row]};
}

void Resting::begin(int rows, const Common& now) {
    const auto count = static_cast<std::size_t>(rows);
    same_ = rests_.size() == count && seen_ == now;
    seen_ = now;
    resize_amply(rests_, count);
    resize_amply(acting_, count);
    resize_amply(candidates_, count);
    resize_amply(known_, count);
}

int Resting::compare(const Motions& motions, const Unmoved& unmoved, int first, int last) {
    int known = 0;
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] == MovedBy::Flight) {  // as the world's row is
            candidates_[i] = 0;
            known_[i] = 1;
            ++known;
            continue;
        }
        const VelocityRow& velocity = motions.velocity[i];
        const bool is_candidate = unmoved.some() && unmoved.is(i) && motions.mover[i] == MovedBy::Substeps &&
                                  velocity.v == Vec2{} && velocity.w == 0;
        const Acting acting = acting_on(motions, i);
        const bool is_known = same_ && is_candidate && rests_[i] != 0 && acting_[i] == acting;
        acting_[i] = acting;
        candidates_[i] = is_candidate ? 1 : 0;
        known_[i] = is_known ? 1 : 0;
        known += is_known ? 1 : 0;
    }
    return known;
}

void Resting::note(const Motions& motions) {
    for (std::size_t i = 0; i < rests_.size(); ++i)
        rests_[i] = motions.standing[i] == kRests ? candidates_[i] : std::uint8_t{0};
}

bool Resting::all_of(std::span<const RowRange> ranges) const {
    return same_ && std::ranges::all_of(ranges, [&](const RowRange& rows) {
               unsigned all = 1;
               for (int i = rows.first; i < rows.last; ++i) all &= known_[i];
               return all != 0;
           });
}

}  // namespace cairn::physics
