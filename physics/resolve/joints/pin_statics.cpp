#include "resolve/joints/pin_statics.h"

namespace cairn::physics {
namespace {

// Bounds the time of one structure, whatever its size. A grid of 24 x 24 takes 326 for a tolerance of 1e-3;
// one of 100 x 100 has 2 % left after so many, and opens no further than with 0.1 % after 800.
constexpr int kMostRounds = 400;

}  // namespace

void PinStatics::clear() {
    bodies_.assign(1, {});
    pins_.clear();
    forces_.clear();
}

int PinStatics::add_body(float inverse_mass, float inverse_inertia, Vec2 acceleration_m_s2) {
    bodies_.push_back({static_cast<double>(inverse_mass),
                       static_cast<double>(inverse_inertia),
                       {static_cast<double>(acceleration_m_s2.x), static_cast<double>(acceleration_m_s2.y)}});
    return static_cast<int>(bodies_.size()) - 1;
}

void PinStatics::add_pin(int a, int b, Vec2 arm_a, Vec2 arm_b, Vec2 force) {
    const auto wide = [](Vec2 v) { return Pair{static_cast<double>(v.x), static_cast<double>(v.y)}; };
    Pin pin{.a = a, .b = b, .arm_a = wide(arm_a), .arm_b = wide(arm_b)};
    double xx = 0, xy = 0, yy = 0;
    const auto add = [&](const Body& body, const Pair& arm) {
        xx += body.inverse_mass + body.inverse_inertia * arm.y * arm.y;
        xy -= body.inverse_inertia * arm.x * arm.y;
        yy += body.inverse_mass + body.inverse_inertia * arm.x * arm.x;
    };
    add(bodies_[static_cast<std::size_t>(a)], pin.arm_a);
    add(bodies_[static_cast<std::size_t>(b)], pin.arm_b);
    const double determinant = xx * yy - xy * xy;
    if (determinant > 0) {
        pin.k00 = yy / determinant;
        pin.k01 = -xy / determinant;
        pin.k11 = xx / determinant;
    }
    pins_.push_back(pin);
    forces_.push_back(wide(force));
}

Vec2 PinStatics::force(int pin) const {
    const Pair& f = forces_[static_cast<std::size_t>(pin)];
    return {static_cast<float>(f.x), static_cast<float>(f.y)};
}

void PinStatics::respond(const std::vector<Pair>& force) {
    speeds_.assign(bodies_.size(), {});
    for (std::size_t i = 0; i < pins_.size(); ++i) {
        const Pin& pin = pins_[i];
        const Pair f = force[i];
        Speed& a = speeds_[static_cast<std::size_t>(pin.a)];
        Speed& b = speeds_[static_cast<std::size_t>(pin.b)];
        a.x -= f.x;
        a.y -= f.y;
        a.w -= pin.arm_a.x * f.y - pin.arm_a.y * f.x;
        b.x += f.x;
        b.y += f.y;
        b.w += pin.arm_b.x * f.y - pin.arm_b.y * f.x;
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        speeds_[i].x *= bodies_[i].inverse_mass;
        speeds_[i].y *= bodies_[i].inverse_mass;
        speeds_[i].w *= bodies_[i].inverse_inertia;
    }
}

PinStatics::Pair PinStatics::opening(const Pin& pin) const {
    const Speed& a = speeds_[static_cast<std::size_t>(pin.a)];
    const Speed& b = speeds_[static_cast<std::size_t>(pin.b)];
    return {(b.x - b.w * pin.arm_b.y) - (a.x - a.w * pin.arm_a.y),
            (b.y + b.w * pin.arm_b.x) - (a.y + a.w * pin.arm_a.x)};
}

PinStatics::Pair PinStatics::precondition(const Pin& pin, Pair residual) {
    return {pin.k00 * residual.x + pin.k01 * residual.y, pin.k01 * residual.x + pin.k11 * residual.y};
}

int PinStatics::solve(double tolerance) {
    const std::size_t count = pins_.size();
    residual_.resize(count);
    along_.resize(count);
    image_.resize(count);
    respond(forces_);
    double size = 0;       // of the residual, r^T K^-1 r
    double reference = 0;  // the same without forces
    for (std::size_t i = 0; i < count; ++i) {
        const Pin& pin = pins_[i];
        const Pair& a = bodies_[static_cast<std::size_t>(pin.a)].acceleration;
        const Pair& b = bodies_[static_cast<std::size_t>(pin.b)].acceleration;
        const Pair free{a.x - b.x, a.y - b.y};
        const Pair done = opening(pin);
        residual_[i] = {free.x - done.x, free.y - done.y};
        along_[i] = precondition(pin, residual_[i]);
        size += residual_[i].x * along_[i].x + residual_[i].y * along_[i].y;
        const Pair start = precondition(pin, free);
        reference += free.x * start.x + free.y * start.y;
    }
    int round = 0;
    for (; round < kMostRounds && size > tolerance * tolerance * reference; ++round) {
        respond(along_);
        double stiffness = 0;
        for (std::size_t i = 0; i < count; ++i) {
            image_[i] = opening(pins_[i]);
            stiffness += along_[i].x * image_[i].x + along_[i].y * image_[i].y;
        }
        if (!(stiffness > 0)) break;
        const double step = size / stiffness;
        double next = 0;
        for (std::size_t i = 0; i < count; ++i) {
            forces_[i].x += step * along_[i].x;
            forces_[i].y += step * along_[i].y;
            residual_[i].x -= step * image_[i].x;
            residual_[i].y -= step * image_[i].y;
            image_[i] = precondition(pins_[i], residual_[i]);
            next += residual_[i].x * image_[i].x + residual_[i].y * image_[i].y;
        }
        const double keep = next / size;
        for (std::size_t i = 0; i < count; ++i) {
            along_[i].x = image_[i].x + keep * along_[i].x;
            along_[i].y = image_[i].y + keep * along_[i].y;
        }
        size = next;
    }
    return round;
}

}  // namespace cairn::physics
