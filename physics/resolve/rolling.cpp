// Rolling resistance: a torque that resists turning against each other, bounded by the normal force.
#include <algorithm>

#include "resolve/contact_points.h"

namespace cairn::physics {

void solve_rolling(ContactConstraint& c, Motion& a, Motion& b) {
    if (c.rolling_m == 0) return;
    const float limit = c.rolling_m * total_normal(c);
    const float impulse = std::clamp(c.rolling_impulse - c.rolling_mass * (b.w - a.w), -limit, limit);
    const float change = impulse - c.rolling_impulse;
    c.rolling_impulse = impulse;
    a.w -= a.inverse_inertia * change;
    b.w += b.inverse_inertia * change;
}

}  // namespace cairn::physics
