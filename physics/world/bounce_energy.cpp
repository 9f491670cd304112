// Limits what bounces give back. Glossary, with u the velocities of a group before its bounces, w those after
// them, and |x|^2 twice the kinetic energy at velocities x:
//     |u + s (w - u)|^2 = |u|^2 + 2 s u.(w - u) + s^2 |w - u|^2
// The s up to 1 is sought at which this is at most what the group came with. Where nothing rubs and all
// bounce alike, all that the impacts took was taken along normals, and e^2 of it is given back. Momentum is
// kept by any s. Source of the latter: W. J. Stronge, "Rigid Body Collisions with Friction" (1990), the
// energetic coefficient of restitution.
#include "world/bounce_energy.h"

#include <algorithm>
#include <cmath>

#include "base/ample.h"
#include "world/heaps.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// More are a heap, where each has many neighbours to lose energy to.
constexpr std::size_t kMostBodies = 512;

// Of the energy: what rounding may add.
constexpr double kRoundingShare = 1e-5;

// Of what bounces add.
constexpr double kMostShare = 2;

// Twice an energy, or a product of velocities in that measure. Scaled spins are energies as they are.
double product(const VelocityRow& x, const VelocityRow& y, float inverse_mass) {
    return static_cast<double>(dot(x.v, y.v)) / static_cast<double>(inverse_mass) +
           static_cast<double>(x.w) * static_cast<double>(y.w);
}

// Adds up the bodies of a group.
class Energies {
  public:
    void add(double had, const VelocityRow& before, const VelocityRow& after, float inverse_mass) {
        const VelocityRow change{after.v - before.v, after.w - before.w, 0};
        had_ += had;
        unbounced_ += product(before, before, inverse_mass);
        crossed_ += product(before, change, inverse_mass);
        added_ += product(change, change, inverse_mass);
    }

    /// Of the change, which wins no energy; 1 where all of it wins none.
    [[nodiscard]] float share() const {
        if (!(unbounced_ + 2 * crossed_ + added_ > (1 + kRoundingShare) * had_) || !(added_ > 0)) return 1;
        return std::min(share_at(had_), 1.0f);
    }

    /// Of the change, which gives back e^2 of what was lost before it.
    [[nodiscard]] float share_giving_back(float restitution) const {
        const double e = static_cast<double>(restitution);
        return added_ > 0 ? share_at(unbounced_ + e * e * (had_ - unbounced_)) : 1;
    }

  private:
    [[nodiscard]] float share_at(double energy) const {
        const double lacking = energy - unbounced_;
        if (!(lacking > 0)) return 0;
        const double share = (std::sqrt(crossed_ * crossed_ + added_ * lacking) - crossed_) / added_;
        // Beyond all measure: what became infinite is halted, and must not draw the others with it.
        if (!std::isfinite(share)) return 1;
        return static_cast<float>(std::clamp(share, 0.0, kMostShare));
    }

    double had_ = 0;
    double unbounced_ = 0;
    double crossed_ = 0;
    double added_ = 0;
};

void change_less(const VelocityRow& before, float share, VelocityRow& after) {
    after.v = before.v + share * (after.v - before.v);
    after.w = before.w + share * (after.w - before.w);
}

class Bouncing {
  public:
    Bouncing(Stores& stores, StepScratch& scratch)
        : stores_(stores),
          contacts_(scratch.contacts),
          motions_(scratch.motions),
          drives_(scratch.drives),
          work_(scratch_of(scratch)) {
        const auto make_room = [](auto& marks, std::size_t count) {
            if (marks.size() < count) {
                reserve_amply(marks, count);
                marks.resize(count);
            }
        };
        make_room(work_.marks, motions_.velocity.size());
        make_room(work_.pushes, static_cast<std::size_t>(stores.contacts.slots.end_index()));
        reserve_amply(work_.marked, motions_.velocity.size());
        reserve_amply(work_.before, motions_.velocity.size());
        work_.marked.clear();
        work_.before.clear();
        work_.group.reserve(kMostBodies);
        for (const ContactConstraint& c : contacts_) note_push(c);
    }

    ~Bouncing() {
        for (const int row : work_.marked) mark(row) = {};
        for (const ContactConstraint& c : contacts_) push(c.contact) = Push::Unknown;
    }

    Bouncing(const Bouncing&) = delete;
    Bouncing& operator=(const Bouncing&) = delete;

    void note(const ContactConstraint& c) {
        if (c.restitution == 0) return;  // its impact has gone on already
        note(c.a);
        note(c.b);
    }

    void find_heaps(std::size_t impacts) {
        const ContactLanes& lanes = stores_.contacts.lanes;
        if (!pays_to_find_heaps(impacts, lanes)) return;
        heaps_are_known_ = true;
        const std::size_t rows = motions_.velocity.size();
        work_.heaps.reset(static_cast<int>(rows));
        for (const int block : lanes.blocks_in_memory()) {
            const PairBlock& pairs = lanes.pairs(block);
            const ContactBlock& contacts = lanes.block(block);
            for (int lane = 0; lane < lanes.link(block).used; ++lane) {
                if (push(pairs.contact[lane]) != Push::None) join(contacts.a[lane], contacts.b[lane]);
            }
        }
        for (const ContactConstraint& c : contacts_) {
            if (push(c.contact) != Push::None && stores_.contacts.slots[c.contact].has_points) join(c.a, c.b);
        }
        assign_amply(work_.bodies, rows, 0);
        for (std::size_t row = 0; row < rows; ++row)
            ++work_.bodies[static_cast<std::size_t>(work_.heaps.find(static_cast<int>(row)))];
    }

    void limit() {
        const std::size_t bouncing = work_.before.size();
        for (std::size_t i = 0; i < bouncing; ++i) {
            if (mark(work_.marked[i]).group != kNone || is_in_heap(work_.marked[i])) continue;
            ++group_;
            work_.group.clear();
            if (grow(work_.marked[i])) limit_energy();
        }
    }

  private:
    using Push = BounceScratch::Push;

    static BounceScratch& scratch_of(StepScratch& scratch) {
        if (!scratch.bouncing) scratch.bouncing = std::make_unique<BounceScratch>();
        return *scratch.bouncing;
    }

    BounceScratch::Mark& mark(int row) { return work_.marks[static_cast<std::size_t>(row)]; }
    Push& push(int contact) { return work_.pushes[static_cast<std::size_t>(contact)]; }
    VelocityRow& velocity(int row) { return motions_.velocity[static_cast<std::size_t>(row)]; }

    void note_push(const ContactConstraint& c) {
        const bool pushes = std::any_of(c.points.begin(), c.points.begin() + c.count,
                                        [](const auto& p) { return p.total_normal_impulse > 0; });
        if (push(c.contact) != Push::Some) push(c.contact) = pushes ? Push::Some : Push::None;
    }

    void note(int row) {
        if (velocity(row).inverse_mass == 0 || mark(row).before != kNone) return;
        mark(row).before = static_cast<int>(work_.before.size());
        work_.marked.push_back(row);
        work_.before.push_back(velocity(row));
    }

    [[nodiscard]] const VelocityRow& unbounced(int row) {
        const int at = mark(row).before;
        return at == kNone ? velocity(row) : work_.before[static_cast<std::size_t>(at)];
    }

    void join(int a, int b) {
        if (velocity(a).inverse_mass != 0 && velocity(b).inverse_mass != 0) work_.heaps.unite(a, b);
    }

    [[nodiscard]] bool is_in_heap(int row) {
        return heaps_are_known_ &&
               work_.bodies[static_cast<std::size_t>(work_.heaps.find(row))] > static_cast<int>(kMostBodies);
    }

    // Takes up all that pushes it; false when energy may come from elsewhere, or when there is too much.
    bool grow(int first) {
        take(first);
        ends_ = 0;
        are_alike_ = true;
        bool closed = true;
        for (std::size_t next = 0; next < work_.group.size() && closed; ++next) {
            const int row = work_.group[next];
            const BodyRecord& body = stores_.bodies.slots[stores_.bodies.rows(RowSet::Awake).body[row - 1]];
            if (body.first_joint != kNone || motions_.mover[row] == MovedBy::Direct) return false;
            for_each_edge(stores_.contacts.slots, body.first_contact, [&](int contact, int) {
                const ContactRecord& c = stores_.contacts.slots[contact];
                if (!closed || !c.has_points || push(contact) == Push::None) return;
                closed = !special::has(c, special::kSurface) && reach(c.body_a) && reach(c.body_b);
                const bool is_seen_twice = moves(c.body_a) && moves(c.body_b);
                are_alike_ = are_alike_ && c.friction == 0 && (ends_ == 0 || c.restitution == restitution_);
                restitution_ = c.restitution;
                ends_ += is_seen_twice ? 1 : 2;
            });
        }
        return closed;
    }

    [[nodiscard]] bool moves(int body) const {
        return stores_.bodies.is_awake(body) && stores_.bodies.slots[body].inverse_mass > 0;
    }

    bool reach(int body) {
        if (stores_.bodies.slots[body].type == BodyType::Static) return true;
        if (!moves(body)) return false;
        const int row = stores_.bodies.places[body].row;
        if (mark(row).group == group_) return true;
        return mark(row).group == kNone && work_.group.size() < kMostBodies && take(row);
    }

    bool take(int row) {
        if (mark(row).before == kNone) work_.marked.push_back(row);
        mark(row).group = group_;
        work_.group.push_back(row);
        return true;
    }

    // Twice the energy that a body had when the step began, and what forces did to it since.
    [[nodiscard]] double came_with(int row) const {
        const BodyRows& awake = stores_.bodies.rows(RowSet::Awake);
        const VelocityRow& now = motions_.velocity[static_cast<std::size_t>(row)];
        const PoseRow& pose = motions_.pose[static_cast<std::size_t>(row)];
        const Drive& drive = drives_[static_cast<std::size_t>(row)];
        const float k = pose.k;
        const VelocityRow began{awake.velocity[row - 1], k > 0 ? awake.spin[row - 1] / k : 0, 0};
        const VelocityRow forces{drive.acceleration, k > 0 ? drive.angular_acceleration / k : 0, 0};
        const VelocityRow way{pose.d, pose.theta, 0};
        return product(began, began, now.inverse_mass) + 2 * product(forces, way, now.inverse_mass);
    }

    void limit_energy() {
        Energies energies;
        for (const int row : work_.group)
            energies.add(came_with(row), unbounced(row), velocity(row), velocity(row).inverse_mass);
        // One impact by itself is given back what it lost already.
        const bool are_many = ends_ > 2;
        const float share =
            are_many && are_alike_ ? energies.share_giving_back(restitution_) : energies.share();
        if (share == 1) return;
        for (const int row : work_.group) change_less(unbounced(row), share, velocity(row));
    }

    Stores& stores_;
    const std::vector<ContactConstraint>& contacts_;
    Motions& motions_;
    const std::vector<Drive>& drives_;
    BounceScratch& work_;
    bool heaps_are_known_ = false;
    int group_ = kNone;
    // Of the present group:
    int ends_ = 0;            // of its contacts, both of each
    bool are_alike_ = false;  // without friction, and of one restitution
    float restitution_ = 0;
};

}  // namespace

void give_back_speed(ContactConstraint& c, const std::array<VelocityRow, 2>& came_with, StepScratch& scratch,
                     const ContactRules& rules) {
    if (c.restitution == 0) return;
    Motions& motions = scratch.motions;
    const std::array<int, 2> rows{c.a, c.b};
    std::array<VelocityRow, 2> stopped;
    for (std::size_t i = 0; i < 2; ++i) stopped[i] = motions.velocity[static_cast<std::size_t>(rows[i])];
    apply_restitution({&c, 1}, motions, scratch.drives, rules);
    Energies energies;
    for (std::size_t i = 0; i < 2; ++i) {
        const VelocityRow& after = motions.velocity[static_cast<std::size_t>(rows[i])];
        if (after.inverse_mass == 0) {
            if (!(came_with[i].v == Vec2{}) || came_with[i].w != 0) return;  // it is moved from outside
            continue;
        }
        energies.add(product(came_with[i], came_with[i], after.inverse_mass), stopped[i], after,
                     after.inverse_mass);
    }
    const float share = energies.share();
    if (share == 1) return;
    for (std::size_t i = 0; i < 2; ++i) {
        VelocityRow& after = motions.velocity[static_cast<std::size_t>(rows[i])];
        if (after.inverse_mass != 0) change_less(stopped[i], share, after);
    }
}

void give_back_speed(Stores& stores, StepScratch& scratch, const ContactRules& rules) {
    const std::vector<int>& met = scratch.impacts.met;
    if (met.empty()) return;
    const bool some_may_win = std::ranges::any_of(met, [&](int i) {
        return !gives_back_little(scratch.contacts[static_cast<std::size_t>(i)].restitution);
    });
    if (some_may_win) {
        Bouncing bouncing(stores, scratch);
        for (const int i : met) bouncing.note(scratch.contacts[static_cast<std::size_t>(i)]);
        apply_restitution(scratch.contacts, scratch.motions, scratch.drives, rules);
        bouncing.find_heaps(met.size());
        bouncing.limit();
    } else {
        apply_restitution(scratch.contacts, scratch.motions, scratch.drives, rules);
    }
    for (const int i : met) {
        ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(i)];
        for (ContactPointConstraint& p : c.points) p.normal_impulse = 0;
        c.friction_impulse = 0;
    }
}

void forget_lane_impulses(ContactStore& contacts, int contact) {
    const ContactRecord& c = contacts.slots[contact];
    if (!is_colored(c.bucket)) return;
    ContactMemory memory = contacts.lanes.memory(c.lane);
    memory.impulse = {};
    memory.friction_impulse = 0;
    contacts.lanes.set_memory(c.lane, memory);
}

}  // namespace cairn::physics
