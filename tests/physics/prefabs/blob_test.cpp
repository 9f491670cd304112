// Soft bodies: together, soft and at rest.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/blob.h>

#include "physics/support/resting.h"

namespace cairn::physics {
namespace {

using namespace test;

double height(World& world, const Blob& blob) {
    double low = 1e9;
    double high = -1e9;
    for (const BodyId piece : blob.bodies) {
        low = std::min(low, world.body(piece)->position().y);
        high = std::max(high, world.body(piece)->position().y);
    }
    return high - low;
}

TEST_CASE("a blob has the pieces and welds of a honeycomb") {
    World world;
    const Blob blob = create_blob(world, {.rings = 3}).value();
    // 1 + 3 n (n + 1) pieces; each of n rings of a honeycomb adds 18 k - 6 edges up to ring k.
    CHECK(blob.bodies.size() == 37);
    CHECK(blob.joints.size() == 90);
    for (const JointId weld : blob.joints) CHECK(world.joint(weld)->current_length() < 1e-5f);
}

TEST_CASE("a blob that falls stays in one piece, is pressed flat at first, and rests in its shape") {
    World world;
    add_ground(world);
    const Blob blob = create_blob(world, {.position_m = {0, 4}}).value();
    const double whole = height(world, blob);
    double flattest = whole;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        flattest = std::min(flattest, height(world, blob));
    }
    CHECK(flattest < 0.97 * whole);
    CHECK(sleeps_within(world, 10));
    CHECK(height(world, blob) == Approx(whole).epsilon(0.05));
    CHECK(world.counts().joints == static_cast<int>(blob.joints.size()));
}

TEST_CASE("a softer blob is pressed flatter") {
    double flat[2] = {};
    for (int i = 0; i < 2; ++i) {
        World world;
        add_ground(world);
        const Blob blob =
            create_blob(world, {.position_m = {0, 1}, .stiffness_hz = i == 0 ? 6.0f : 20.0f}).value();
        run_for(world, 5);
        flat[i] = height(world, blob);
    }
    CHECK(flat[0] < flat[1]);
}

}  // namespace
}  // namespace cairn::physics
