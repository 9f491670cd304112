// Which contacts touch, for the events of contacts and for whoever counts.
#include <algorithm>

#include <cairn/physics/tuning.h>

#include "world/contact_events.h"
#include "world/contact_lists.h"

namespace cairn::physics {

bool touches(int count, const std::array<float, 2>& impulse, const std::array<float, 2>& separation,
             bool touched) {
    const float gap = (touched ? 2 : 1) * tuning::kLinearSlop_m;
    for (int i = 0; i < count; ++i) {
        if (impulse[i] > 0 || separation[i] < gap) return true;
    }
    return false;
}

bool is_touching(const ContactStore& contacts, int contact) {
    const ContactRecord& c = contacts.slots[contact];
    if (c.reports_touch) return c.touching;
    if (!c.has_points) return false;
    const ContactMemory memory = memory_of(contacts, contact);
    if (memory.impulse[0] > 0 || memory.impulse[1] > 0) return true;
    if (!is_colored(c.bucket)) return false;
    const ContactBlock& block = contacts.lanes.block(c.lane / kLanes);
    const auto gap = [&](int i) { return block.points[i].separation[c.lane % kLanes]; };
    return std::min(gap(0), gap(1)) < tuning::kLinearSlop_m;
}

}  // namespace cairn::physics
