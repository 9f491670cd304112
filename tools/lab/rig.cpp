#include "rig.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <type_traits>

namespace cairn::lab {
namespace {

// States that enter the digest: every 30th, so that a divergence shows though it may heal.
constexpr int kStepsPerSample = 30;
constexpr std::uint64_t kHashPrime = 0x100000001b3u;  // of FNV

double reach_of(const physics::Geometry& geometry) {
    return std::visit(
        [](const auto& shape) -> double {
            using Shape = std::decay_t<decltype(shape)>;
            if constexpr (std::is_same_v<Shape, physics::Circle>) {
                return length(shape.center_m) + shape.radius_m;
            } else if constexpr (std::is_same_v<Shape, physics::Box>) {
                return length(shape.center_m) + std::hypot(shape.half_width_m, shape.half_height_m) +
                       shape.radius_m;
            } else if constexpr (std::is_same_v<Shape, physics::Polygon>) {
                float far = 0;
                for (const Vec2 p : shape.points_m) far = std::max(far, length(p));
                return far + shape.radius_m;
            } else if constexpr (std::is_same_v<Shape, physics::Capsule>) {
                return std::max(length(shape.a_m), length(shape.b_m)) + shape.radius_m;
            } else {
                return std::max(length(shape.a_m), length(shape.b_m));
            }
        },
        geometry);
}

double inverse(double mass) {
    return mass > 0 ? 1 / mass : 0;
}

bool all_finite(const Motion& m) {
    return std::isfinite(m.center_m.x + m.center_m.y + m.c + m.s + m.vx_m_s + m.vy_m_s +
                         m.angular_velocity_rad_s);
}

}  // namespace

double cpu_time_s() {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Position world_point(const Motion& motion, Vec2 local_m) {
    const double x = local_m.x, y = local_m.y;
    return {motion.position_m.x + motion.c * x - motion.s * y,
            motion.position_m.y + motion.s * x + motion.c * y};
}

double distance(Position a, Position b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

double speed(const Motion& motion) {
    return std::hypot(motion.vx_m_s, motion.vy_m_s);
}

Rig::Rig(const EngineKind& kind, const WorldSetting& setting)
    : engine_(kind.make(setting)), gravity_m_s2_(setting.gravity_m_s2) {}

BodyRef Rig::add_body(const physics::BodyDef& def) {
    const BodyRef body = engine_->add_body(def);
    parts_.push_back({.body = body,
                      .gravity_scale = def.gravity_scale,
                      .start_m = def.position_m,
                      .dynamic = def.type == physics::BodyType::Dynamic});
    return body;
}

void Rig::add_shape(BodyRef body, const physics::Geometry& geometry, const physics::ShapeDef& def) {
    engine_->add_shape(body, geometry, def);
    Part& changed = part(body);
    changed.reach_m = std::max(changed.reach_m, reach_of(geometry));
    changed.mass = engine_->mass(body);
}

BodyRef Rig::add(const physics::BodyDef& def, const physics::Geometry& geometry,
                 const physics::ShapeDef& shape) {
    const BodyRef body = add_body(def);
    add_shape(body, geometry, shape);
    return body;
}

BodyRef Rig::add_ground(double top_m, const physics::ShapeDef& shape) {
    return add({.type = physics::BodyType::Static, .position_m = {0, top_m - 10}}, physics::Box{1000, 10},
               shape);
}

void Rig::pin(BodyRef a, BodyRef b, Position at_m) {
    const Pin pin{a, b, local(a, at_m), local(b, at_m)};
    engine_->add_revolute(a, b, {.local_anchor_a_m = pin.local_a_m, .local_anchor_b_m = pin.local_b_m});
    pins_.push_back(pin);
}

void Rig::weld(BodyRef a, BodyRef b, Position at_m, float frequency_hz, float damping_ratio) {
    const Pin pin{a, b, local(a, at_m), local(b, at_m)};
    const Motion ma = motion(a), mb = motion(b);
    // As the joint's angle is that of frame b against frame a, frame a is turned as b stands to a.
    const double angle = std::atan2(ma.c * mb.s - ma.s * mb.c, ma.c * mb.c + ma.s * mb.s);
    engine_->add_weld(a, b,
                      {.local_anchor_a_m = pin.local_a_m,
                       .local_anchor_b_m = pin.local_b_m,
                       .local_angle_a_rad = static_cast<float>(angle),
                       .angular_frequency_hz = frequency_hz,
                       .angular_damping_ratio = damping_ratio});
    pins_.push_back(pin);
}

void Rig::rod(BodyRef a, BodyRef b, Position on_a_m, Position on_b_m) {
    engine_->add_distance(a, b,
                          {.local_anchor_a_m = local(a, on_a_m),
                           .local_anchor_b_m = local(b, on_b_m),
                           .length_m = static_cast<float>(distance(on_a_m, on_b_m))});
}

void Rig::spring(BodyRef a, BodyRef b, Position on_a_m, Position on_b_m, double rest_m, float frequency_hz,
                 float damping_ratio) {
    Spring spring;
    spring.a = a;
    spring.b = b;
    spring.local_a_m = local(a, on_a_m);
    spring.local_b_m = local(b, on_b_m);
    spring.rest_m = rest_m;
    const double mass = 1 / (inverse(part(a).mass.mass_kg) + inverse(part(b).mass.mass_kg));
    const double omega = 2 * std::numbers::pi * frequency_hz;
    spring.stiffness_n_m = mass * omega * omega;
    springs_.push_back(spring);
    engine_->add_distance(a, b,
                          {.local_anchor_a_m = spring.local_a_m,
                           .local_anchor_b_m = spring.local_b_m,
                           .length_m = static_cast<float>(rest_m),
                           .enable_spring = true,
                           .frequency_hz = frequency_hz,
                           .damping_ratio = damping_ratio});
}

void Rig::remove(BodyRef body) {
    part(body).present = false;
    engine_->remove_body(body);
    const auto belongs = [&](const Pin& pin) { return pin.a.bits == body.bits || pin.b.bits == body.bits; };
    std::erase_if(pins_, belongs);
    std::erase_if(springs_, belongs);
}

void Rig::step(float dt_s) {
    if (!keeps_books_) {
        engine_->step(dt_s);
        return;
    }
    if (!books_open_) begin_books();
    const double before = cpu_time_s();
    engine_->step(dt_s);
    cpu_s_ += cpu_time_s() - before;
    ++steps_;
    keep_books();
}

void Rig::run(double duration_s, float dt_s, const std::function<void(double)>& after_each) {
    const auto steps = static_cast<std::int64_t>(std::lround(duration_s / static_cast<double>(dt_s)));
    for (std::int64_t i = 1; i <= steps; ++i) {
        step(dt_s);
        if (after_each) after_each(static_cast<double>(i) * dt_s);
    }
}

double Rig::max_speed_m_s() const {
    double fastest = 0;
    for (const Part& part : parts_) {
        if (part.present && part.dynamic) fastest = std::max(fastest, speed(motion(part.body)));
    }
    return fastest;
}

double Rig::joint_error_m() const {
    double worst = 0;
    for (const Pin& pin : pins_) {
        const double error =
            distance(world_point(motion(pin.a), pin.local_a_m), world_point(motion(pin.b), pin.local_b_m));
        if (!(error <= worst)) worst = error;  // NaN stays
    }
    return worst;
}

Rig::Energies Rig::energies() const {
    Energies sum;
    for (const Part& part : parts_) {
        if (!part.present) continue;
        const Motion m = motion(part.body);
        sum.finite = sum.finite && all_finite(m);
        if (!part.dynamic) continue;
        sum.kinetic_j += 0.5 * part.mass.mass_kg * (m.vx_m_s * m.vx_m_s + m.vy_m_s * m.vy_m_s) +
                         0.5 * part.mass.inertia_kg_m2 * m.angular_velocity_rad_s * m.angular_velocity_rad_s;
        sum.potential_j -= part.gravity_scale * part.mass.mass_kg *
                           (gravity_m_s2_.x * (m.center_m.x - part.start_m.x) +
                            gravity_m_s2_.y * (m.center_m.y - part.start_m.y));
    }
    for (const Spring& spring : springs_) {
        const double stretch = distance(world_point(motion(spring.a), spring.local_a_m),
                                        world_point(motion(spring.b), spring.local_b_m)) -
                               spring.rest_m;
        sum.potential_j += 0.5 * spring.stiffness_n_m * stretch * stretch;
    }
    return sum;
}

double Rig::energy_j() const {
    const Energies now = energies();
    return now.kinetic_j + now.potential_j;
}

Vec2 Rig::momentum_kg_m_s() const {
    double x = 0, y = 0;
    for (const Part& part : parts_) {
        if (!part.present || !part.dynamic) continue;
        const Motion m = motion(part.body);
        x += part.mass.mass_kg * m.vx_m_s;
        y += part.mass.mass_kg * m.vy_m_s;
    }
    return {static_cast<float>(x), static_cast<float>(y)};
}

double Rig::angular_momentum_kg_m2_s() const {
    double sum = 0;
    for (const Part& part : parts_) {
        if (!part.present || !part.dynamic) continue;
        const Motion m = motion(part.body);
        sum += part.mass.mass_kg * (m.center_m.x * m.vy_m_s - m.center_m.y * m.vx_m_s) +
               part.mass.inertia_kg_m2 * m.angular_velocity_rad_s;
    }
    return sum;
}

void Rig::begin_books() {
    books_open_ = true;
    double low = std::numeric_limits<double>::infinity(), high = -low, weight = 0;
    for (Part& part : parts_) {
        if (!part.present || !part.dynamic) continue;
        const Motion m = motion(part.body);
        part.start_m = m.center_m;
        low = std::min(low, m.position_m.y - part.reach_m);
        high = std::max(high, m.position_m.y + part.reach_m);
        weight += part.mass.mass_kg * static_cast<double>(length(gravity_m_s2_));
    }
    weight_times_height_j_ = weight > 0 ? weight * (high - low) : 0;
    allowed_work_j_ = 0;
    const Energies now = energies();
    energy_at_start_j_ = now.kinetic_j + now.potential_j;
    most_kinetic_j_ = now.kinetic_j;
}

void Rig::keep_books() {
    if (physics::World* const world = engine_->cairn_world();
        world != nullptr && steps_ % kStepsPerSample == 0) {
        digest_ = digest_ * kHashPrime ^ world->state_hash();
    }
    const Energies now = energies();
    finite_ = finite_ && now.finite;
    most_kinetic_j_ = std::max(most_kinetic_j_, now.kinetic_j);
    const double excess = now.kinetic_j + now.potential_j - energy_at_start_j_ - allowed_work_j_;
    const double scale = std::max(most_kinetic_j_, weight_times_height_j_);
    if (excess > 0 && scale > 0) energy_excess_ = std::max(energy_excess_, excess / scale);
}

std::uint64_t Rig::digest() const {
    physics::World* const world = engine_->cairn_world();
    return world == nullptr ? 0 : digest_ * kHashPrime ^ world->state_hash();
}

Rig::Part& Rig::part(BodyRef body) {
    // The last ones are asked for while a scene is built.
    return *std::find_if(parts_.rbegin(), parts_.rend(),
                         [&](const Part& part) { return part.body.bits == body.bits && part.present; });
}

Vec2 Rig::local(BodyRef body, Position world_m) const {
    const Motion m = motion(body);
    const double x = world_m.x - m.position_m.x, y = world_m.y - m.position_m.y;
    return {static_cast<float>(m.c * x + m.s * y), static_cast<float>(m.c * y - m.s * x)};
}

}  // namespace cairn::lab
