// Ways in two pieces: as was expected up to the first predicted contact that acted, and straight on from
// there to where the step left the body. Nothing lies on the first piece, or it would have been predicted to
// be met earlier; so wherever the body is put back to on the second, it gets there past nothing that stands.
#include "world/bent_ways.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "world/edge_list.h"
#include "world/fast_guard.h"
#include "world/filtering.h"
#include "world/finalize.h"
#include "world/last_way.h"
#include "world/special_contacts.h"
#include "world/sweep_guard.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kBodiesPerChunk = 8;

// Each turns a body back to less than the angle that was too much.
constexpr int kMostRounds = 8;

// What turns further after it was hit comes round.
constexpr float kWhirl_rad = 1;

// What is round meets nothing by turning, and what hangs on others would be torn off them.
bool is_held_whirling(const Stores& stores, int body) {
    return stores.bodies.slots[body].turn_arm_m > tuning::kLinearSlop_m && !hangs_on_what_moves(stores, body);
}

bool has_acted(const ContactConstraint& c) {
    return std::any_of(c.points.begin(), c.points.begin() + c.count,
                       [](const ContactPointConstraint& p) { return p.total_normal_impulse > 0; });
}

// Of each body that whirls at nothing the first that came about, in the order of the bodies.
void keep_first_bends(const Stores& stores, StepScratch& scratch) {
    std::vector<Bend>& bends = scratch.bent.bends;
    std::erase_if(bends, [&](const Bend& bend) {
        return !stores.bodies.is_awake(bend.body) ||
               std::ranges::binary_search(scratch.bent.whirled, bend.body, {}, &Whirled::body) ||
               !has_acted(scratch.contacts[static_cast<std::size_t>(bend.contact)]);
    });
    std::ranges::sort(bends, [](const Bend& a, const Bend& b) {
        return a.body != b.body ? a.body < b.body : a.share < b.share;
    });
    const auto of_one_body = [](const Bend& a, const Bend& b) { return a.body == b.body; };
    bends.erase(std::unique(bends.begin(), bends.end(), of_one_body), bends.end());
}

// Whether what was left of the step could have taken the body through something.
bool goes_on(const Stores& stores, const Bend& bend) {
    if (!is_guarded(stores, bend.body)) return false;
    const BodyRecord& record = stores.bodies.slots[bend.body];
    const Vec2 moved = stores.bodies.rows(RowSet::Awake).moved[record.row];
    return length(moved - bend.moved) > kFastShare * record.inner_radius_m;
}

// Whether the straight way from the start of the step does not tell what the body passed.
bool is_bent(const Stores& stores, const Bend& bend) {
    const BodyRecord& record = stores.bodies.slots[bend.body];
    const Vec2 moved = stores.bodies.rows(RowSet::Awake).moved[record.row];
    return length(bend.share * moved - bend.moved) > kFastShare * record.inner_radius_m;
}

// Of a contact in plain form, before substeps collided it anew.
Vec2 first_normal(const StepScratch& scratch, int contact) {
    const auto sweeping = std::ranges::lower_bound(scratch.sweeping, contact, {}, &SweepingContact::contact);
    if (sweeping != scratch.sweeping.end() && sweeping->contact == contact) return sweeping->first_normal;
    return scratch.contacts[static_cast<std::size_t>(contact)].normal;
}

// What a contact keeps a body from, seen from the body: how it and the other get on towards each other.
class Approach {
  public:
    Approach(const Stores& stores, const StepScratch& scratch, int contact, int body)
        : stores_(stores), motions_(scratch.motions), body_(body) {
        const ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(contact)];
        const ContactRecord& record = stores.contacts.slots[c.contact];
        const bool is_a = record.body_a == body;
        other_ = is_a ? record.body_b : record.body_a;
        const Vec2 normal = first_normal(scratch, contact);
        towards_ = is_a ? normal : -normal;
    }

    /// m/s, as the step left them.
    [[nodiscard]] float closing_m_s() const { return dot(velocity(body_) - velocity(other_), towards_); }
    /// m, since a moment of the step: of the body, and how far the other made way; negative where it came on.
    [[nodiscard]] float own_way_m(const Moment& since) const { return way_m(body_, since); }
    [[nodiscard]] float room_m(const Moment& since) const { return way_m(other_, since); }

  private:
    [[nodiscard]] Vec2 velocity(int body) const {
        return motions_.velocity[static_cast<std::size_t>(stores_.bodies.places[body].row)].v;
    }
    [[nodiscard]] float way_m(int body, const Moment& since) const {
        if (stores_.bodies.places[body].row == kWorldRow) return 0;
        return dot(since.motion_since(stores_, body).moved, towards_);
    }

    const Stores& stores_;
    const Motions& motions_;
    int body_;
    int other_;
    Vec2 towards_;
};

// What whirls, and touched something when the step began: its contact tells nothing of what its other corners
// meet. It goes no nearer to what it touched, and the next step finds it turned on.
void hold_whirling(Stores& stores, StepScratch& scratch) {
    std::vector<Whirled>& whirled = scratch.bent.whirled;
    whirled.clear();
    if (!scratch.motions.some_turn_far) return;
    constexpr std::uint32_t kHeld = place_flag::kFast | place_flag::kWhirls;
    auto predicted = scratch.bent.bends.begin();
    for (int i = 0; i < static_cast<int>(scratch.contacts.size()); ++i) {
        while (predicted != scratch.bent.bends.end() && predicted->contact < i) ++predicted;
        if (predicted != scratch.bent.bends.end() && predicted->contact == i) continue;
        const ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(i)];
        const ContactRecord& record = stores.contacts.slots[c.contact];
        for (const int body : {record.body_a, record.body_b}) {
            if ((stores.bodies.places[body].flags & kHeld) != kHeld || !is_guarded(stores, body)) continue;
            const Approach approach(stores, scratch, i, body);
            const float own = approach.own_way_m({});
            const float room = approach.room_m({});
            const float least_way = kFastShare * stores.bodies.slots[body].inner_radius_m;
            // What comes on would pass over a body that stays behind.
            if (own - room <= least_way || room < -least_way || !is_held_whirling(stores, body)) continue;
            push_amply(whirled, {body, std::max(room, 0.0f) / own});
        }
    }
    std::ranges::sort(whirled, [](const Whirled& a, const Whirled& b) {
        return a.body != b.body ? a.body < b.body : a.share < b.share;
    });
    for (const auto& [body, share] : whirled) put_back(stores, body, share, false);
}

// Of the second piece.
class SecondPieces {
  public:
    SecondPieces(const Stores& stores, const StepScratch& scratch, float dt_s)
        : stores_(stores), scratch_(scratch), bends_(scratch.bent.bends), dt_s_(dt_s) {}

    [[nodiscard]] float free_share(const Bend& bend) const {
        const Moment since(bend.share, bends_);
        const float whirling = free_share_of_whirling(bend, since);
        return whirling == 0 || !is_bent(stores_, bend)
                   ? whirling
                   : std::min(whirling, free_share_past_all(bend, since));
    }

  private:
    [[nodiscard]] float free_share_past_all(const Bend& bend, const Moment& since) const {
        float share = 1;
        for_each_edge(stores_.contacts.slots, stores_.bodies.slots[bend.body].first_contact,
                      [&](int contact, int side) {
                          const ContactRecord& c = stores_.contacts.slots[contact];
                          if (special::has(c, special::kRefused | special::kPassing)) return;
                          const int own = side == 0 ? c.shape_a : c.shape_b;
                          const int other = side == 0 ? c.shape_b : c.shape_a;
                          share = std::min(share, Way(stores_, own, since).free_share(other));
                      });
        return std::min(share, free_share_by_trees(bend, since));
    }

    // What spins so fast after it was hit that its other corners come round before it gets away would have
    // hit again, wherever its way leads: it goes no nearer to what it met.
    [[nodiscard]] float free_share_of_whirling(const Bend& bend, const Moment& since) const {
        const int row = stores_.bodies.places[bend.body].row;
        const float turned_rad = std::fabs(scratch_.motions.spin(row)) * (1 - bend.share) * dt_s_;
        if (turned_rad <= kWhirl_rad || !is_held_whirling(stores_, bend.body)) return 1;
        const Approach approach(stores_, scratch_, bend.contact, bend.body);
        const float least_way = kFastShare * stores_.bodies.slots[bend.body].inner_radius_m;
        if (approach.closing_m_s() * dt_s_ <= least_way) return 1;
        const float own = approach.own_way_m(since);
        const float room = approach.room_m(since);
        if (room < -least_way) return 1;  // it would be passed over
        if (own <= 0) return 0;
        return std::clamp(room / own, 0.0f, 1.0f);
    }

    // Among what it did not expect to come near.
    [[nodiscard]] float free_share_by_trees(const Bend& bend, const Moment& since) const {
        constexpr std::uint32_t kElsewhere = place_flag::kLost | place_flag::kStrayed;
        float share = 1;
        if ((stores_.bodies.places[bend.body].flags & kElsewhere) == 0) return share;
        for (int s = stores_.bodies.slots[bend.body].first_shape; s != kNone;
             s = stores_.shapes[s].next_of_body) {
            const Way way(stores_, s, since);
            if (!way.is_looked_at()) continue;
            const auto visit = [&](int other) {
                if (!may_collide(stores_, s, other) || lets_pass(stores_, s, other)) return;
                share = std::min(share, way.free_share(other));
            };
            for (const Layer layer : kLayers)
                stores_.broad.tree(layer).query_segment(way.from(), way.way(), visit);
        }
        return share;
    }

    const Stores& stores_;
    const StepScratch& scratch_;
    std::span<const Bend> bends_;
    float dt_s_;
};

// To a share of the second piece.
void put_back(Stores& stores, const Bend& bend, float share) {
    BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const BodyRecord& record = stores.bodies.slots[bend.body];
    Place& place = stores.bodies.places[bend.body];
    Vec2& moved = awake.moved[record.row];
    const Vec2 free_way = bend.moved + share * (moved - bend.moved);
    place.center = place.center + (free_way - moved);
    moved = free_way;
    if (takes_shapes_round(record)) {
        const double turned_rad = (inverse(bend.rotation) * place.rotation).angle_rad();
        place.rotation =
            normalized(Rotation::from_angle(static_cast<double>(share) * turned_rad) * bend.rotation);
    }
    update_boxes(stores, bend.body);
}

}  // namespace

void expect_bends(const Stores& stores, const ContactInput& input, float dt_s, StepScratch& scratch) {
    const ContactRecord& c = stores.contacts.slots[input.contact];
    for (const int body : {c.body_a, c.body_b}) {
        const BodyRecord& record = stores.bodies.slots[body];
        if (record.type != BodyType::Dynamic || !stores.bodies.is_awake(body)) continue;
        const float spin = stores.bodies.rows_of(body).spin[record.row];
        const Place& place = stores.bodies.places[body];
        const Vec2 velocity = without_locked(
            scratch.advances[static_cast<std::size_t>(place.row)].velocity_m_s, locked_axes(record));
        push_amply(
            scratch.bent.bends,
            {.body = body,
             .contact = static_cast<int>(scratch.contacts.size()) - 1,
             .share = std::min(input.reached_s / dt_s, 1.0f),
             .moved = input.reached_s * velocity,
             .rotation = normalized(Rotation::from_small_angle(input.reached_s * spin) * place.rotation)});
    }
}

void hold_bent_ways(Stores& stores, StepScratch& scratch, float dt_s, TaskPool& tasks) {
    hold_whirling(stores, scratch);
    if (scratch.bent.bends.empty()) return;
    keep_first_bends(stores, scratch);
    const SecondPieces pieces(stores, scratch, dt_s);
    std::vector<Bend>& followed = scratch.bent.followed;
    std::vector<float>& shares = scratch.bent.shares;
    followed.clear();
    std::ranges::copy_if(scratch.bent.bends, std::back_inserter(followed),
                         [&](const Bend& bend) { return goes_on(stores, bend); });
    for (int round = 0; round < kMostRounds && !followed.empty(); ++round) {
        resize_amply(shares, followed.size());
        tasks.parallel_for(static_cast<int>(followed.size()), kBodiesPerChunk, [&](const Chunk& chunk) {
            for (int i = chunk.begin; i < chunk.end; ++i)
                shares[static_cast<std::size_t>(i)] =
                    pieces.free_share(followed[static_cast<std::size_t>(i)]);
        });
        std::size_t again = 0;
        for (std::size_t i = 0; i < followed.size(); ++i) {
            if (shares[i] == 1) continue;
            put_back(stores, followed[i], shares[i]);
            if (takes_shapes_round(stores.bodies.slots[followed[i].body])) followed[again++] = followed[i];
        }
        followed.resize(again);
    }
}

}  // namespace cairn::physics
