// A ball falls for one second from 10 m and prints its height. The formula says 10 - 10 / 2 * 1^2 = 5.
#include <cstdio>

#include <cairn/physics/world.h>

int main() {
    cairn::physics::World world({.gravity_m_s2 = {0, -10}});
    const cairn::physics::BodyId ball = world.create_body({.position_m = {0, 10}}).value();
    if (!world.create_shape(ball, cairn::physics::Circle{.radius_m = 0.5f})) return 1;
    for (int step = 0; step < 60; ++step) {
        if (!world.step(1.0f / 60)) return 1;
    }
    std::printf("height_m: %.4f\n", world.body(ball)->position().y);
}
