// A world, and calls to it that are made up from the fuzzer's bytes.
// Invariant: the session keeps books of its own about what it made and what the events told, and compares the
// world's with them; the same bytes make the same calls.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <cairn/physics/mover.h>
#include <cairn/physics/world.h>

#include "fuzz/input.h"

namespace cairn::physics::fuzz {

/// Handles that were given out, and whether what they name should still be there.
template <class Id>
class Handles {
  public:
    void add(Id id) { made_.push_back({id, true}); }
    void gone(Id id) {
        for (Made& m : made_) {
            if (m.id == id) m.alive = false;
        }
    }
    template <class Rule>
    void gone_if(Rule&& rule) {
        for (Made& m : made_) {
            if (m.alive && rule(m.id)) m.alive = false;
        }
    }
    [[nodiscard]] bool is_there(Id id) const {
        return std::any_of(made_.begin(), made_.end(), [&](const Made& m) { return m.alive && m.id == id; });
    }
    [[nodiscard]] int alive() const {
        return static_cast<int>(
            std::count_if(made_.begin(), made_.end(), [](const Made& m) { return m.alive; }));
    }
    /// Mostly one that was given out, gone or not; at times any bits.
    Id any(Input& in) const {
        const int choice = in.below(16);
        if (choice == 15) return Id::from_bits(in.bits());
        if (choice == 14 || made_.empty()) return Id{};
        return made_[static_cast<std::size_t>(in.byte()) % made_.size()].id;
    }

  private:
    struct Made {
        Id id;
        bool alive;
    };
    std::vector<Made> made_;
};

class Session {
  public:
    Session(Input in, int threads);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Makes calls until the bytes are used up, and gives the hash of what came of them.
    std::uint64_t run();

  private:
    using ShapePair = std::pair<std::uint64_t, std::uint64_t>;

    void call();

    // objects.cpp: what makes and destroys.
    BodyDef body_def();
    Material material();
    void make_body();
    void make_bodies();
    void make_shape();
    void make_joint();
    void make_chain();
    void divide_body();
    void destroy();
    void destroy_body();
    void destroy_bodies();
    void destroy_shape();
    void destroy_chain();
    void destroy_joint();
    void body_is_gone(BodyId id);
    void joint_is_gone(JointId id);
    void note_segments(ChainId id);

    // changes.cpp: what changes things that are there.
    void push();
    void place();
    void change_body();
    void change_shape();
    void change_chain();
    void change_joint();
    void change_world();
    void blow();

    // questions.cpp: what asks, and what only asks and moves a character.
    void ask();
    void walk();

    // session.cpp: what must hold after a step.
    void step();
    void check_bodies();
    void check_counts();
    void check_contact_events();
    void check_sensors();
    void check_joint_breaks();

    BodyId any_body() { return in_.below(32) == 31 ? foreign_ : bodies_.any(in_); }
    ShapeId any_shape() { return in_.below(32) == 31 ? foreign_shape_ : shapes_.any(in_); }
    std::optional<Body> body();
    static bool may_collide(void* session, ShapeId a, ShapeId b);

    struct ChainParts {
        ChainId chain;
        BodyId body;
        std::vector<ShapeId> segments;
    };
    struct GearParts {
        JointId gear;
        JointId joint_1;
        JointId joint_2;
    };

    Input in_;
    World world_;
    World other_;
    BodyId foreign_;
    ShapeId foreign_shape_;
    Handles<BodyId> bodies_;
    Handles<ShapeId> shapes_;
    Handles<JointId> joints_;
    Handles<ChainId> chains_;
    std::vector<ChainParts> chain_parts_;
    std::vector<GearParts> gears_;
    std::set<std::uint64_t> segments_;  // shapes that are parts of chains
    std::set<ShapePair> touching_;      // as the events told
    std::set<ShapePair> seen_;          // sensor, visitor
    std::optional<Mover> mover_;
};

}  // namespace cairn::physics::fuzz
