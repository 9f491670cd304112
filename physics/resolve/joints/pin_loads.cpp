#include "resolve/joints/pin_loads.h"

#include <algorithm>

namespace cairn::physics {

void take_off_load(JointConstraint& pin, Vec2 load_n, const PinLoads& loads, const Motions& motions) {
    const Vec2 load = loads.h_s * load_n;
    const Vec2 last{pin.impulse[impulse_index(0, Role::HoldOrSpring)],
                    pin.impulse[impulse_index(1, Role::HoldOrSpring)]};
    const float square = length_squared(load);
    const float along = dot(load, last);
    if (!(square > 0) || !(along > 0)) return;
    const float scale = loads.give * std::min(kMostOfLastLoad * along / square, 1.0f);
    const auto response = [&](int row, Vec2 arm) {
        const Motion body = motions.get(row);
        return velocity_change(body, load) + body.inverse_inertia * cross(arm, load) * left_perp(arm);
    };
    pin.anchors.center_offset -=
        scale * (response(pin.anchors.a, pin.anchors.r_a) + response(pin.anchors.b, pin.anchors.r_b));
}

}  // namespace cairn::physics
