// What a world is like at the moment: how well its constraints hold, what it has of energy and momentum, and
// how much there is of everything. Asked for between steps (`World::report`); a step does nothing for it.
#pragma once

#include <cairn/physics/profile.h>

namespace cairn::physics {

/// What the world holds at the moment.
struct Counts {
    int bodies = 0;
    int awake_bodies = 0;  ///< dynamic and kinematic
    int shapes = 0;
    int joints = 0;
    int contacts = 0;  ///< pairs of shapes that are near each other, those refused by the host too
    int touching = 0;  ///< of those, the pairs that touch
};

struct WorldReport {
    Counts counts{};
    int awake_touching = 0;  ///< of the pairs that touch, those of which a body is awake
    int awake_joints = 0;    ///< that act, and of which a body is awake
    int islands = 0;         ///< groups of awake dynamic bodies that hang together and sleep together

    // Errors, over bodies asleep too; each the largest there is.
    float max_penetration_m = 0;  ///< overlap of two touching shapes
    /// How far joints are from what they hold rigid, and beyond their limits. A gear counts as its first
    /// joint.
    float max_joint_error_m = 0;
    float max_joint_error_rad = 0;
    // The residual of the velocities: how fast the same errors grow. At points where shapes overlap, the
    // speed along the normal at which they approach; of what joints hold rigid, how fast it changes, either
    // way; at limits that are reached, how fast they are overrun. 0 is solved exactly.
    float residual_m_s = 0;
    float residual_rad_s = 0;

    // Of dynamic bodies. Gravity is the only force that has potential energy; its height counts from y = 0,
    // or from where else its direction makes it 0 at the origin.
    double kinetic_energy_j = 0;
    double potential_energy_j = 0;
    double elastic_energy_j = 0;  ///< of the springs of joints, caps of their forces apart
    double momentum_x_kg_m_s = 0;
    double momentum_y_kg_m_s = 0;
    double angular_momentum_kg_m2_s = 0;  ///< about the origin of the world

    Profile stages{};  ///< as `World::profile`: zeros unless steps are told to measure

    [[nodiscard]] double energy_j() const { return kinetic_energy_j + potential_energy_j + elastic_energy_j; }
};

}  // namespace cairn::physics
