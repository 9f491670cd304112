// Bodies: a cold record and a place in a slot that never moves, and a hot row among those of the same state.
// Invariant: each body has exactly one row, in the set that its record names, and that row names the body
// back; its place names the row of its motion.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include <cairn/physics/body.h>

#include "base/motion.h"
#include "base/place.h"
#include "base/slot_map.h"

namespace cairn::physics {

enum class RowSet : std::uint8_t { Static, Awake, Asleep };

/// What a step reads of each awake body comes first, so that it is one cache line.
struct BodyRecord {
    BodyType type = BodyType::Static;
    RowSet set = RowSet::Static;
    bool allow_sleep = true;
    AxisLocks locks;
    int row = kNone;
    float inverse_mass = 0;
    float inverse_inertia = 0;
    float extent_m = 0;        // of the shapes, from the centre of mass
    float turn_arm_m = 0;      // of the farthest point that turning moves: the rims of discs do not count
    float center_arm_m = 0;    // of the farthest centre of a shape
    float inner_radius_m = 0;  // of the thinnest shape: half of what is solid about it
    float linear_damping_1_s = 0;
    float angular_damping_1_s = 0;
    float gravity_scale = 1;
    float sleep_speed_m_s = 0;
    int first_shape = kNone;
    int first_contact = kNone;  // keys of edge lists
    int first_joint = kNone;
    MassData mass;
    int last_shape = kNone;
    int first_sensor = kNone;
    int breakable = kNone;     // place among the breakable bodies
    float joint_inertia = 0;   // kg m^2, which a direct solution gave it last (resolve/direct); 0: none did
    int next_sleeper = kNone;  // ring of the bodies that fell asleep together
    std::uint64_t user_data = 0;
};

/// Bits of base/motion.h: the axes along which nothing moves the body.
inline std::uint8_t locked_axes(const BodyRecord& body) {
    if (body.type != BodyType::Dynamic) return 0;
    return static_cast<std::uint8_t>((body.locks.x ? kLockedX : 0) | (body.locks.y ? kLockedY : 0));
}

inline bool turning_is_locked(const BodyRecord& body) {
    return body.type == BodyType::Dynamic && body.locks.rotation;
}

/// Rows of bodies, one column per quantity.
struct BodyRows {
    std::vector<Vec2> moved;                // by the last step, m
    std::vector<Rotation> rotation_before;  // the last step
    std::vector<Vec2> velocity;
    std::vector<float> spin;  // angular velocity, rad/s
    std::vector<Vec2> force;  // for the next step
    std::vector<float> torque;
    std::vector<float> rest_time;  // s since the body last moved
    std::vector<float> box_slack;  // m that the body may yet move before one of its boxes must be made anew
    std::vector<int> body;

    [[nodiscard]] int size() const { return static_cast<int>(body.size()); }
    auto columns() {
        return std::tie(moved, rotation_before, velocity, spin, force, torque, rest_time, box_slack, body);
    }
};

class BodyStore {
  public:
    explicit BodyStore(std::uint16_t world_tag) : slots(world_tag) {}

    SlotMap<BodyRecord, BodyId> slots;
    std::vector<Place> places;  // by slot

    [[nodiscard]] BodyRows& rows(RowSet set) { return rows_[static_cast<std::size_t>(set)]; }
    [[nodiscard]] const BodyRows& rows(RowSet set) const { return rows_[static_cast<std::size_t>(set)]; }
    [[nodiscard]] BodyRows& rows_of(int body) { return rows(slots[body].set); }
    [[nodiscard]] const BodyRows& rows_of(int body) const { return rows(slots[body].set); }
    [[nodiscard]] bool is_awake(int body) const { return slots[body].set == RowSet::Awake; }

    /// A new, empty row for a body that has none.
    void add_row(int body, RowSet set);
    void remove_row(int body);
    /// Takes the body's row to another set.
    void move_row(int body, RowSet set);

    /// Puts the rows of awake bodies in another order: row i becomes what row from[i] was. What `from` holds
    /// afterwards means nothing.
    void order_awake_rows(std::span<int> from);

    /// Asks for what moving the body will read, besides its row.
    void ask_for(int body) const {
        slots.ask_for(body);
        prefetch(&places[static_cast<std::size_t>(body)], sizeof(Place));
    }

    /// Of the body's origin.
    [[nodiscard]] Position origin(int body) const {
        const Place& place = places[static_cast<std::size_t>(body)];
        return place.center + -rotate(place.rotation, slots[body].mass.center_m);
    }
    [[nodiscard]] Transform transform(int body) const {
        return {origin(body), places[static_cast<std::size_t>(body)].rotation};
    }
    /// The centre of b minus that of a.
    [[nodiscard]] Vec2 center_offset(int a, int b) const;

  private:
    void drop_row(RowSet set, int row);
    void set_row(int body, RowSet set, int row);

    std::array<BodyRows, 3> rows_;
};

}  // namespace cairn::physics
