// Makes the parts of a prefab. Invariant: all or nothing. After an error nothing more is made, and
// `finish` destroys what there is and gives that error.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

#include "base/check.h"

namespace cairn::physics {

class Builder {
  public:
    explicit Builder(World& world) : world_(world) {}

    /// Rules for a definition. All that are broken are told, in one call or several: what makes sense only
    /// where others hold is asked for when those are `good`.
    void require(std::initializer_list<check::Fault> faults);

    BodyId body(const BodyDef& def);
    void shape(BodyId body, const Geometry& geometry, const ShapeDef& def);
    JointId joint(const JointDef& def);
    /// The body of a held end: a new static one at the point when it is the world.
    BodyId holder(const PrefabEnd& end, Position point_m);

    [[nodiscard]] bool good() const { return !fault_; }
    [[nodiscard]] Vec2 local(BodyId body, Position point_m) const;
    /// Where the anchors and axes of a joint go: both at a point of the world.
    template <class Def>
    void place(Def& def, BodyId a, BodyId b, Position point_m) const {
        def.body_a = a;
        def.body_b = b;
        def.local_anchor_a_m = local(a, point_m);
        def.local_anchor_b_m = local(b, point_m);
    }
    /// A pin with friction: a motor of speed 0.
    JointId pin(BodyId a, BodyId b, Position point_m, float friction_torque_nm, JointStrength strength = {});

    template <class T>
    Result<T> finish(T prefab) {
        if (fault_) {
            destroy_prefab(world_, made_);
            return *fault_;
        }
        static_cast<Prefab&>(prefab) = std::move(made_);
        return prefab;
    }

  private:
    /// The value of a call that made something, or nothing and the error kept.
    template <class T>
    T keep(Result<T> result) {
        if (result) return *result;
        fault_ = result.error();
        return {};
    }

    World& world_;
    Prefab made_{};
    check::Fault fault_{};
};

/// As `check::within` for counts.
check::Fault check_count(const char* field, int value, int low, int high);
inline double as_double(float x) {
    return static_cast<double>(x);
}

}  // namespace cairn::physics
