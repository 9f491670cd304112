// Groups of bodies that touch, grown over contacts from each impact. A group is let go as it is, for
// apply_restitution to deal with, where anything else pushes on it: a joint, a contact that does not bounce,
// a surface that runs; for what the solver did to its bodies would be lost.
#include "world/impact_groups.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "resolve/contact_points.h"
#include "world/bounce_energy.h"
#include "world/heaps.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// More are a heap, which rests on itself. The time that a group takes may grow with the square.
constexpr std::size_t kMostContacts = 64;
constexpr std::size_t kMostBodies = kMostContacts + 1;

class Groups {
  public:
    Groups(Stores& stores, StepScratch& scratch, const StepTime& time, const ContactRules& rules)
        : stores_(stores), scratch_(scratch), work_(scratch.impacts), time_(time), rules_(rules) {
        const auto rows = static_cast<std::size_t>(scratch.motions.size());
        reserve_amply(work_.all_rows, rows);
        if (work_.group_of.size() < rows) {
            reserve_amply(work_.group_of, rows);
            work_.group_of.resize(rows, kNone);
        }
        work_.all_rows.clear();
        work_.rows.reserve(kMostBodies);
        work_.solved.reserve(kMostBodies);
        work_.contacts.reserve(kMostContacts);
        work_.hits.reserve(kMostContacts);
        const auto contacts = static_cast<std::size_t>(stores.contacts.slots.end_index());
        if (work_.marks.size() < contacts) {
            reserve_amply(work_.marks, contacts);
            work_.marks.resize(contacts);
            reserve_amply(work_.marked, contacts);
        }
        work_.marked.clear();
    }

    ~Groups() {
        for (const int row : work_.all_rows) group_of(row) = kNone;
        for (const int contact : work_.marked) mark(contact).group = kNone;
        if (!plain_is_listed_) return;
        for (const ContactConstraint& c : scratch_.contacts) mark(c.contact).plain = kNone;
    }

    Groups(const Groups&) = delete;
    Groups& operator=(const Groups&) = delete;

    void find_heaps() {
        const ContactLanes& lanes = stores_.contacts.lanes;
        if (!pays_to_find_heaps(work_.met.size(), lanes)) return;
        heaps_are_known_ = true;
        list_plain_forms();
        const auto rows = static_cast<std::size_t>(scratch_.motions.size());
        work_.heaps.reset(static_cast<int>(rows));
        assign_amply(work_.touching, rows, 0);
        for (const int block : lanes.blocks_in_memory()) {
            for (int lane = 0; lane < lanes.link(block).used; ++lane) {
                if (mark(lanes.pairs(block).contact[lane]).plain != kNone) continue;
                if (touches(lanes.block(block), lane))
                    join(lanes.block(block).a[lane], lanes.block(block).b[lane]);
            }
        }
        for (const ContactConstraint& c : scratch_.contacts) {
            if (stores_.contacts.slots[c.contact].has_points &&
                std::any_of(c.points.begin(), c.points.begin() + c.count, is_closed_up))
                join(c.a, c.b);
        }
        for (std::size_t row = 0; row < rows; ++row) {
            const auto root = static_cast<std::size_t>(work_.heaps.find(static_cast<int>(row)));
            if (root != row) work_.touching[root] += work_.touching[row];
        }
    }

    void from(const ContactConstraint& impact) {
        if (heaps_are_known_ && (is_in_heap(impact.a) || is_in_heap(impact.b))) return;
        work_.rows.clear();
        work_.hits.clear();
        work_.contacts.clear();
        met_ = 0;
        is_alone_ = true;
        const ContactRecord& c = stores_.contacts.slots[impact.contact];
        if (!touches_more(c.body_a, impact.contact) && !touches_more(c.body_b, impact.contact)) return;
        list_plain_forms();
        ++group_;
        if (!reach(c.body_a) || !reach(c.body_b) || !is_closed() || work_.hits.size() < 2) return let_go();
        fly_freely();
        if (let_happen(work_.hits, work_.rows, scratch_.motions)) {
            place(impact);
            note_impulses();
        } else {
            take_back();
        }
    }

  private:
    void list_plain_forms() {
        if (plain_is_listed_) return;
        plain_is_listed_ = true;
        for (std::size_t i = 0; i < scratch_.contacts.size(); ++i) {
            ImpactScratch::Mark& m = mark(scratch_.contacts[i].contact);
            if (m.plain == kNone) m.plain = static_cast<int>(i);
        }
    }

    static bool is_closed_up(const ContactPointConstraint& p) {
        return p.end_separation <= tuning::kLinearSlop_m;
    }
    static bool is_closed_up_in_lane(const ContactBlockPoint& p, int lane) {
        return p.mass[lane] != 0 && p.separation[lane] <= tuning::kLinearSlop_m;
    }
    static bool touches(const ContactBlock& block, int lane) {
        return is_closed_up_in_lane(block.points[0], lane) || is_closed_up_in_lane(block.points[1], lane);
    }

    [[nodiscard]] bool row_moves(int row) const {
        return row != kWorldRow && scratch_.motions.velocity[static_cast<std::size_t>(row)].inverse_mass != 0;
    }
    void join(int a, int b) {
        ++work_.touching[static_cast<std::size_t>(row_moves(b) ? b : a)];
        if (row_moves(a) && row_moves(b)) work_.heaps.unite(a, b);
    }
    [[nodiscard]] bool is_in_heap(int row) {
        return row_moves(row) && work_.touching[static_cast<std::size_t>(work_.heaps.find(row))] >
                                     static_cast<int>(kMostContacts);
    }

    // Most impacts are those of two bodies, and of nobody else's concern.
    [[nodiscard]] bool touches_more(int body, int contact) const {
        if (!moves(body)) return false;
        bool more = false;
        for_each_edge(stores_.contacts.slots, stores_.bodies.slots[body].first_contact, [&](int other, int) {
            more = more || (other != contact && stores_.contacts.slots[other].has_points);
        });
        return more;
    }

    ImpactScratch::Mark& mark(int contact) { return work_.marks[static_cast<std::size_t>(contact)]; }

    int& group_of(int row) { return work_.group_of[static_cast<std::size_t>(row)]; }

    [[nodiscard]] bool moves(int body) const {
        return stores_.bodies.is_awake(body) && stores_.bodies.slots[body].inverse_mass > 0;
    }

    [[nodiscard]] int row_of(int body) const { return stores_.bodies.places[body].row; }

    // Another impact may make a group of some of them.
    void let_go() {
        for (const int row : work_.rows) group_of(row) = kNone;
        work_.all_rows.resize(work_.all_rows.size() - work_.rows.size());
    }

    // False when another group had it.
    bool reach(int body) {
        if (!moves(body)) return true;
        const int row = row_of(body);
        if (group_of(row) == kNone) {
            group_of(row) = group_;
            work_.rows.push_back(row);
            work_.all_rows.push_back(row);
        }
        return group_of(row) == group_;
    }

    // Takes up what touches; false when something else acts on it.
    bool is_closed() {
        for (std::size_t next = 0; next < work_.rows.size(); ++next) {
            const int row = work_.rows[next];
            const BodyRecord& body = stores_.bodies.slots[stores_.bodies.rows(RowSet::Awake).body[row - 1]];
            if (body.first_joint != kNone || scratch_.motions.mover[row] == MovedBy::Direct ||
                scratch_.motions.locked_axes(row) != 0)
                return false;
            bool closed = true;
            for_each_edge(stores_.contacts.slots, body.first_contact,
                          [&](int contact, int) { closed = closed && takes(contact); });
            if (!closed) return false;
        }
        return true;
    }

    // Whether the contact is one that the group may have, if it touches at all.
    bool takes(int contact) {
        const ContactRecord& c = stores_.contacts.slots[contact];
        if (!c.has_points || mark(contact).group == group_) return true;
        if (work_.hits.size() == kMostContacts) return false;
        Impact hit;
        if (!describe(contact, c, hit)) {
            is_alone_ = false;
            return !has_pushed(contact);
        }
        if (gives_back_little(c.restitution) || (c.special & (special::kSurface | special::kOneWay)) != 0)
            return false;
        hit.friction = c.friction;
        hit.restitution = c.restitution;
        const float g =
            dot(scratch_.drives[hit.b].acceleration - scratch_.drives[hit.a].acceleration, hit.normal);
        hit.slow_m_s = rules_.restitution_speed_m_s + std::max(-g * time_.dt_s, 0.0f);
        work_.hits.push_back(hit);
        work_.contacts.push_back(contact);
        work_.marked.push_back(contact);
        mark(contact).group = group_;
        return reach(c.body_a) && reach(c.body_b);
    }

    // What it gave one of the group another body would keep.
    [[nodiscard]] bool has_pushed(int contact) {
        if (const ContactConstraint* plain = plain_form(contact)) {
            return std::any_of(plain->points.begin(), plain->points.begin() + plain->count,
                               [](const ContactPointConstraint& p) { return p.total_normal_impulse > 0; });
        }
        const ContactRecord& c = stores_.contacts.slots[contact];
        if (!is_colored(c.bucket)) return false;
        const ContactBlock& block = stores_.contacts.lanes.block(c.lane / kLanes);
        const int lane = c.lane % kLanes;
        return (block.bounces >> lane & 1) != 0 &&
               (block.total_impulse[0][lane] > 0 || block.total_impulse[1][lane] > 0);
    }

    // False when the surfaces are apart at the end of the step.
    bool describe(int contact, const ContactRecord& c, Impact& hit) {
        if (const ContactConstraint* plain = plain_form(contact)) {
            if (std::any_of(plain->points.begin(), plain->points.begin() + plain->count,
                            [&](const ContactPointConstraint& p) { return met_fast(p, rules_); }))
                ++met_;
            return describe(*plain, hit);
        }
        if (!is_colored(c.bucket)) return false;
        const ContactBlock& block = stores_.contacts.lanes.block(c.lane / kLanes);
        const int lane = c.lane % kLanes;
        hit.a = block.a[lane];
        hit.b = block.b[lane];
        hit.normal = {block.normal_x[lane], block.normal_y[lane]};
        for (const ContactBlockPoint& p : block.points) {
            if (!is_closed_up_in_lane(p, lane)) continue;
            hit.points[hit.count++] = {p.arm_a[lane], p.arm_b[lane]};
        }
        hit.tangent_arm_a = block.tangent_arm_a[lane];
        hit.tangent_arm_b = block.tangent_arm_b[lane];
        return hit.count > 0;
    }

    bool describe(const ContactConstraint& c, Impact& hit) const {
        const float k_a = scratch_.motions.pose[c.a].k;
        const float k_b = scratch_.motions.pose[c.b].k;
        hit.a = c.a;
        hit.b = c.b;
        hit.normal = c.normal;
        for (int i = 0; i < c.count; ++i) {
            const ContactPointConstraint& p = c.points[i];
            if (!is_closed_up(p)) continue;
            hit.points[hit.count++] = {k_a * cross(p.r_a, c.normal), k_b * cross(p.r_b, c.normal)};
        }
        const Vec2 tangent = right_perp(c.normal);
        hit.tangent_arm_a = k_a * cross(c.friction_r_a, tangent);
        hit.tangent_arm_b = k_b * cross(c.friction_r_b, tangent);
        return hit.count > 0;
    }

    [[nodiscard]] ContactConstraint* plain_form(int contact) {
        const int at = mark(contact).plain;
        return at == kNone ? nullptr : &scratch_.contacts[static_cast<std::size_t>(at)];
    }

    // As the substeps would have, had nothing touched.
    void fly_freely() {
        const Motions& m = scratch_.motions;
        work_.solved.clear();
        for (const int row : work_.rows) {
            const auto at = static_cast<std::size_t>(row);
            VelocityRow& velocity = scratch_.motions.velocity[at];
            work_.solved.push_back(velocity);
            const BodyRows& awake = stores_.bodies.rows(RowSet::Awake);
            velocity.v = awake.velocity[at - 1];
            velocity.w = m.pose[at].k > 0 ? awake.spin[at - 1] / m.pose[at].k : 0;
            for (int i = 0; i < time_.substeps; ++i) {
                velocity.v += m.kick[at].v;
                velocity.w += m.kick[at].w;
                if (m.kept.empty()) continue;
                velocity.v = {m.kept[at].v.x * velocity.v.x, m.kept[at].v.y * velocity.v.y};
                velocity.w *= m.kept[at].w;
            }
        }
    }

    // Where they come to when the impact falls at its time: up to then as before the step, from then on as
    // they leave it. Left where they were solved when it is not the only one, when others are near, or when
    // they could pass through something.
    void place(const ContactConstraint& impact) {
        if (met_ > 1 || !is_alone_) return;
        const auto& p = *std::ranges::min_element(impact.points.begin(), impact.points.begin() + impact.count,
                                                  {}, &ContactPointConstraint::closing_velocity);
        const float met_s = std::clamp(p.separation / -p.closing_velocity, -time_.dt_s, time_.dt_s);
        const BodyRows& awake = stores_.bodies.rows(RowSet::Awake);
        Motions& m = scratch_.motions;
        const auto placed = [&](int row) {
            return met_s * awake.velocity[row - 1] + (time_.dt_s - met_s) * m.velocity[row].v;
        };
        for (const int row : work_.rows) {
            const float most_m = stores_.bodies.slots[awake.body[row - 1]].inner_radius_m;
            if (length(placed(row) - m.pose[row].d) > most_m) return;
        }
        for (const int row : work_.rows) m.pose[row].d = placed(row);
    }

    void take_back() {
        for (std::size_t i = 0; i < work_.rows.size(); ++i)
            scratch_.motions.velocity[static_cast<std::size_t>(work_.rows[i])] = work_.solved[i];
    }

    void note_impulses() {
        for (std::size_t i = 0; i < work_.contacts.size(); ++i) {
            forget_lane_impulses(stores_.contacts, work_.contacts[i]);
            ContactConstraint* plain = plain_form(work_.contacts[i]);
            if (plain == nullptr) continue;
            plain->restitution = 0;  // done
            plain->friction_impulse = 0;
            int hit_point = 0;
            for (int k = 0; k < plain->count; ++k) {
                ContactPointConstraint& p = plain->points[k];
                p.normal_impulse = 0;
                if (is_closed_up(p)) p.total_normal_impulse = work_.hits[i].points[hit_point++].impulse;
            }
        }
    }

    Stores& stores_;
    StepScratch& scratch_;
    ImpactScratch& work_;
    const StepTime& time_;
    const ContactRules& rules_;
    bool plain_is_listed_ = false;
    bool heaps_are_known_ = false;
    int group_ = kNone;
    int met_ = 0;            // impacts of the group
    bool is_alone_ = false;  // nothing else is near
};

}  // namespace

void pass_impacts_on(Stores& stores, StepScratch& scratch, const StepTime& time, const ContactRules& rules) {
    const auto goes_on = [&](int i) {
        return !gives_back_little(scratch.contacts[static_cast<std::size_t>(i)].restitution);
    };
    const std::vector<int>& met = scratch.impacts.met;
    if (std::ranges::none_of(met, goes_on)) return;
    Groups groups(stores, scratch, time, rules);
    groups.find_heaps();
    for (const int i : met) {
        if (goes_on(i)) groups.from(scratch.contacts[static_cast<std::size_t>(i)]);
    }
}

}  // namespace cairn::physics
