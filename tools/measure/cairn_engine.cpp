// Cairn behind the interface of engines.
#include "engine.h"

namespace cairn::measure {
namespace {

using physics::BodyId;
using physics::Vec2;

class CairnEngine final : public Engine {
  public:
    explicit CairnEngine(const WorldSetting& setting)
        : world_({.gravity_m_s2 = setting.gravity_m_s2,
                  .substeps = setting.effort > 0 ? setting.effort : physics::WorldDef{}.substeps,
                  .enable_sleep = setting.enable_sleep,
                  .threads = setting.threads}) {}

    BodyRef add_body(const physics::BodyDef& def) override {
        return {world_.create_body(def).value().bits()};
    }
    void add_shape(BodyRef body, const physics::Geometry& geometry, const physics::ShapeDef& def) override {
        world_.create_shape(id(body), geometry, def).value();
    }
    void add_closed_chain(BodyRef body, std::span<const Vec2> points_m, physics::Material material) override {
        world_
            .create_chain(id(body),
                          {.points_m = points_m, .closed = true, .materials = std::span(&material, 1)})
            .value();
    }
    void add_revolute(BodyRef a, BodyRef b, const physics::RevoluteJointDef& def) override {
        add_joint(a, b, def);
    }
    void add_wheel(BodyRef a, BodyRef b, const physics::WheelJointDef& def) override { add_joint(a, b, def); }
    void add_distance(BodyRef a, BodyRef b, const physics::DistanceJointDef& def) override {
        add_joint(a, b, def);
    }
    void add_weld(BodyRef a, BodyRef b, const physics::WeldJointDef& def) override { add_joint(a, b, def); }
    void remove_body(BodyRef body) override { world_.destroy_body(id(body)).value(); }
    void set_transform(BodyRef body, physics::Position position_m, double angle_rad) override {
        world_.body(id(body))->set_transform(position_m, angle_rad).value();
    }
    void set_linear_velocity(BodyRef body, Vec2 velocity_m_s) override {
        world_.body(id(body))->set_linear_velocity(velocity_m_s).value();
    }
    void set_angular_velocity(BodyRef body, float velocity_rad_s) override {
        world_.body(id(body))->set_angular_velocity(velocity_rad_s).value();
    }
    void apply_force(BodyRef body, Vec2 force_n) override {
        world_.body(id(body))->apply_force_to_center(force_n).value();
    }
    [[nodiscard]] physics::Position position(BodyRef body) const override {
        return world_.body(id(body))->position();
    }
    [[nodiscard]] Motion motion(BodyRef body) const override {
        const auto view = world_.body(id(body));
        const physics::Transform pose = view->transform();
        const Vec2 v = view->linear_velocity();
        return {.position_m = pose.p,
                .center_m = view->world_center(),
                .c = static_cast<double>(pose.q.c),
                .s = static_cast<double>(pose.q.s),
                .vx_m_s = static_cast<double>(v.x),
                .vy_m_s = static_cast<double>(v.y),
                .angular_velocity_rad_s = static_cast<double>(view->angular_velocity()),
                .awake = view->is_awake()};
    }
    [[nodiscard]] Mass mass(BodyRef body) const override {
        const physics::MassData data = world_.body(id(body))->mass_data();
        return {static_cast<double>(data.mass_kg), static_cast<double>(data.inertia_kg_m2)};
    }

    void step(float dt_s) override { world_.step(dt_s).value(); }

    [[nodiscard]] int awake_bodies() const override { return world_.awake_body_count(); }
    [[nodiscard]] Tally tally() const override {
        const physics::Counts counts = world_.counts();
        return {counts.bodies, counts.shapes, counts.joints, counts.contacts, counts.touching};
    }
    [[nodiscard]] float max_penetration_m() const override { return world_.max_penetration_m(); }
    [[nodiscard]] std::vector<Vec2> velocities_m_s() const override {
        std::vector<Vec2> velocities;
        for (const BodyId body : world_.bodies()) {
            const auto view = world_.body(body);
            if (view->type() != physics::BodyType::Static) velocities.push_back(view->linear_velocity());
        }
        return velocities;
    }
    [[nodiscard]] physics::World* cairn_world() override { return &world_; }

  private:
    template <class Def>
    void add_joint(BodyRef a, BodyRef b, Def def) {
        def.body_a = id(a);
        def.body_b = id(b);
        world_.create_joint(def).value();
    }

    static BodyId id(BodyRef body) { return BodyId::from_bits(body.bits); }

    physics::World world_;
};

}  // namespace

std::unique_ptr<Engine> make_cairn(const WorldSetting& setting) {
    return std::make_unique<CairnEngine>(setting);
}

EngineKind cairn() {
    return {"cairn", make_cairn, physics::WorldDef{}.substeps};
}

}  // namespace cairn::measure
