// What is pressed deep.
#include "world/pressed_bodies.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "world/fast_bodies.h"

namespace cairn::physics {
namespace {

// A centre is at least as far from the surface as what is solid about the shape, less the depth; what goes no
// farther than kFastShare of that is not looked at otherwise.
bool is_pressed(const Stores& stores, int body, float depth_m) {
    return depth_m > (1 - kFastShare) * stores.bodies.slots[body].inner_radius_m;
}

// m. Less is not looked at: half of what is solid about the smallest body that is not tiny.
constexpr float kLeastDepth_m = 0.5f * tuning::kLinearSlop_m;

}  // namespace

bool note_pressed(const Stores& stores, int block, std::vector<int>& pressed) {
    const ContactLanes& lanes = stores.contacts.lanes;
    if (kind_of(lanes.link(block).bucket) == BlockKind::TwoBodies) return false;
    const auto& points = lanes.block(block).points;
    Lanes<float> depth{};
    for (const ContactBlockPoint& point : points) {
        for (int lane = 0; lane < kLanes; ++lane)
            depth[lane] = std::max(depth[lane], point.mass[lane] > 0 ? -point.start_separation[lane] : 0.0f);
    }
    float most = 0;
    for (const float d : depth) most = std::max(most, d);
    if (most < kLeastDepth_m) return false;
    bool some = false;
    for (int lane = 0; lane < lanes.link(block).used; ++lane) {
        const int body = lanes.pairs(block).body_b[lane];
        if (depth[lane] < kLeastDepth_m || !is_pressed(stores, body, depth[lane])) continue;
        push_amply(pressed, body);
        some = true;
    }
    return some;
}

void note_pressed(const Stores& stores, const ContactInput& input, std::vector<int>& pressed) {
    const ContactRecord& c = stores.contacts.slots[input.contact];
    if (stores.bodies.slots[c.body_a].type == BodyType::Dynamic) return;
    float depth = 0;
    for (int i = 0; i < input.count; ++i) depth = std::max(depth, -input.points[i].separation);
    if (is_pressed(stores, c.body_b, depth)) push_amply(pressed, c.body_b);
}

}  // namespace cairn::physics
