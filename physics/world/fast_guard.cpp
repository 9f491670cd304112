// The guard of fast bodies. Nearly all of them end the step without having passed through anything, so the
// pairs of which one could have are picked out first, by what their bodies did as a whole, in one walk over
// the contacts; the ways of their shapes' centres are then followed one by one.
// Invariant: what is picked out holds every pair of which a way meets the other shape.
#include "world/fast_guard.h"

#include <algorithm>
#include <bit>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "collide/place_lanes.h"
#include "world/edge_list.h"
#include "world/fast_bodies.h"
#include "world/filtering.h"
#include "world/finalize.h"
#include "world/last_way.h"
#include "world/special_contacts.h"
#include "world/sweeping_contacts.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kBodiesPerChunk = 64;
constexpr int kRowsPerChunk = 512;
constexpr int kBlocksPerChunk = 32;
constexpr int kContactsPerChunk = 64;
constexpr int kPressedPerChunk = 16;

// Rows ahead of which bodies are asked for.
constexpr int kRowsAhead = 12;

// Each turns a body back to less than the angle that was too much.
constexpr int kMostRounds = 8;

// While centres stay in the boxes that their shapes had when contacts were updated, those of a pair without a
// contact are in boxes apart, and neither can get past the other. What was hurled out of its own has to ask
// the trees.
bool is_lost(const Stores& stores, int body) {
    return (stores.bodies.places[body].flags & place_flag::kLost) != 0;
}

// Written where it stays: put together elsewhere and copied it would wait for its own parts.
void note_displacement(const Stores& stores, int row, Displacement& d, std::vector<int>& sweeping) {
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const int body = awake.body[row];
    const BodyRecord& record = stores.bodies.slots[body];
    const Rotation now = stores.bodies.places[body].rotation;
    const Rotation before = awake.rotation_before[row];
    const bool guarded = is_guarded(stores, body);
    d.moved = awake.moved[row];
    d.chord = length(Vec2{now.c - before.c, now.s - before.s});
    d.extent_m = record.extent_m;
    d.arm_m = guarded ? record.center_arm_m : Displacement{}.arm_m;
    d.least_way_m = guarded ? kFastShare * record.inner_radius_m : Displacement{}.least_way_m;
    // Without mass nothing can stop it.
    if (guarded && record.inverse_mass > 0 && sweeps(record, d.chord)) sweeping.push_back(body);
}

void note_displacements(const Stores& stores, WayScratch& ways, TaskPool& tasks) {
    const std::vector<int>& bodies = stores.bodies.rows(RowSet::Awake).body;
    std::vector<Displacement>& displacements = ways.displacements;
    resize_amply(displacements, bodies.size() + 1);
    displacements[kWorldRow] = {};
    ways.sweeping.start(static_cast<int>(bodies.size()), kRowsPerChunk, tasks);
    tasks.parallel_for(static_cast<int>(bodies.size()), kRowsPerChunk, [&](const Chunk& chunk) {
        ChunkedList<int>::Appender sweeping(ways.sweeping, chunk);
        for (int row = chunk.begin; row < chunk.end; ++row) {
            if (row + kRowsAhead < chunk.end) stores.bodies.ask_for(bodies[row + kRowsAhead]);
            note_displacement(stores, row, displacements[static_cast<std::size_t>(row) + 1],
                              sweeping.items());
        }
    });
}

// Up to eight of them, of one sort.
struct BlockOfPairs {
    const Lanes<std::int32_t>& body_a;
    const Lanes<std::int32_t>& body_b;
    int used;  // lanes
    const PairBlock* in_color;
    const NearPair* near;

    [[nodiscard]] int shape_a(int lane) const {
        return near != nullptr ? near[lane].shape_a : in_color->shape_a[lane];
    }
    [[nodiscard]] int shape_b(int lane) const {
        return near != nullptr ? near[lane].shape_b : in_color->shape_b[lane];
    }
};

// The blocks of all contacts of awake bodies that are not loose, numbered: near ones, then those in colours.
class AllBlocks {
  public:
    explicit AllBlocks(const ContactLanes& lanes) : lanes_(lanes) {
        for (int g = 0; g < kPairGeometries; ++g) {
            const int count = lanes.near_count(static_cast<PairGeometry>(g));
            first_[g + 1] = first_[g] + (count + kLanes - 1) / kLanes;
        }
    }

    [[nodiscard]] int size() const {
        return first_.back() + static_cast<int>(lanes_.blocks_in_memory().size());
    }

    /// Calls visit(pairs).
    template <class Visit>
    void with(int i, Visit&& visit) const {
        if (i >= first_.back()) {
            const int block = lanes_.blocks_in_memory()[i - first_.back()];
            const PairBlock& pairs = lanes_.pairs(block);
            return visit(BlockOfPairs{pairs.body_a, pairs.body_b, lanes_.link(block).used, &pairs, nullptr});
        }
        int g = 0;
        while (i >= first_[g + 1]) ++g;
        const auto geometry = static_cast<PairGeometry>(g);
        const int first = (i - first_[g]) * kLanes;
        const NearPair* pairs = &lanes_.near_pairs(geometry)[first];
        alignas(32) Lanes<std::int32_t> body_a;
        alignas(32) Lanes<std::int32_t> body_b;
        for (int lane = 0; lane < kLanes; ++lane) {
            body_a[lane] = pairs[lane].body_a;
            body_b[lane] = pairs[lane].body_b;
        }
        const int used = std::min(lanes_.near_count(geometry) - first, kLanes);
        visit(BlockOfPairs{body_a, body_b, used, nullptr, pairs});
    }

  private:
    const ContactLanes& lanes_;
    std::array<int, kPairGeometries + 1> first_{};
};

// Finds how far fast bodies were free to go, by all pairs of which one may have passed through the other.
// What threads find are shares of ways, of which the least counts, so their order does not matter.
class Guard {
  public:
    Guard(const Stores& stores, WayScratch& ways, TaskPool& tasks)
        : stores_(stores), ways_(ways), tasks_(tasks), places_(stores.bodies.places.data()) {
        assign_amply(ways.free_shares, ways.displacements.size(), 1.0f);
    }

    void look_at_lost(std::span<const int> fast) {
        tasks_.parallel_for(static_cast<int>(fast.size()), kBodiesPerChunk, [&](const Chunk& chunk) {
            for (int i = chunk.begin; i < chunk.end; ++i) {
                const int body = fast[i];
                if (!is_guarded(stores_, body) || !is_lost(stores_, body)) continue;
                ways_.free_shares[places_[body].row] = free_share_by_trees(body);
            }
        });
    }

    void look_at_blocks() {
        const AllBlocks blocks(stores_.contacts.lanes);
        look(blocks.size(), kBlocksPerChunk, [&](int i, std::vector<FreeShare>& found) {
            blocks.with(i, [&](const BlockOfPairs& pairs) {
                unsigned passed = passed_lanes(pairs.body_a, pairs.body_b, pairs.used);
                for (; passed != 0; passed &= passed - 1) {
                    const int lane = std::countr_zero(passed);
                    follow_both({pairs.body_a[lane], pairs.shape_a(lane)},
                                {pairs.body_b[lane], pairs.shape_b(lane)}, found);
                }
            });
        });
    }

    void look_at_loose() {
        look(static_cast<int>(stores_.contacts.loose.size()), kContactsPerChunk,
             [&](int i, std::vector<FreeShare>& found) {
                 const ContactRecord& c = stores_.contacts.slots[stores_.contacts.loose[i]];
                 if (special::has(c, special::kRefused | special::kPassing)) return;
                 alignas(32) const Lanes<std::int32_t> body_a{c.body_a};
                 alignas(32) const Lanes<std::int32_t> body_b{c.body_b};
                 if (passed_lanes(body_a, body_b, 1) != 0)
                     follow_both({c.body_a, c.shape_a}, {c.body_b, c.shape_b}, found);
             });
    }

    // Pairs that kept apart by what was expected of them: those of which a body strayed from that, and which
    // may have met then.
    void look_beside(std::span<const int> fast, const ChunkedList<PairsBeside>& beside) {
        if (beside.size() == 0 || !note_strayed(fast)) return;
        look(beside.parts(), 1, [&](int part, std::vector<FreeShare>& found) {
            Pack pack;
            const auto follow = [&](const ItemPair& pair, std::size_t lane) {
                if (can_meet(pair))
                    follow_both({pack.body_a[lane], pair.a}, {pack.body_b[lane], pair.b}, found);
            };
            for (const PairsBeside& pairs : beside.part(part)) {
                const auto group = static_cast<std::size_t>(pairs.group);
                LaneMask lanes = pairs.lanes;
                if (ways_.strayed[pairs.item] == 0) lanes &= ways_.strayed_lanes[group];
                for (; lanes != 0; lanes &= lanes - 1) {
                    const int other = stores_.broad.group_items()[group][std::countr_zero(lanes)];
                    if (add({std::min(pairs.item, other), std::max(pairs.item, other)}, pack))
                        for_passed(pack, follow);
                }
            }
            for_passed(pack, follow);
        });
    }

    // At bodies that were put back. What was taken for straight is an arc where a body turns, at the end of
    // which the centre of any of its shapes may be beyond something.
    void look_again(std::span<const int> bodies) {
        tasks_.parallel_for(static_cast<int>(bodies.size()), 1, [&](const Chunk& chunk) {
            for (int i = chunk.begin; i < chunk.end; ++i)
                ways_.free_shares[places_[bodies[i]].row] = free_share_by_trees(bodies[i]);
        });
    }

  private:
    struct Side {
        int body;
        int shape;
    };

    // Pairs of shapes, eight at once.
    struct Pack {
        std::array<ItemPair, kLanes> pairs;
        alignas(32) Lanes<std::int32_t> body_a{};
        alignas(32) Lanes<std::int32_t> body_b{};
        int size = 0;
    };

    // Whether the pack is full now.
    [[nodiscard]] bool add(const ItemPair& pair, Pack& pack) const {
        pack.pairs[pack.size] = pair;
        pack.body_a[pack.size] = stores_.shapes[pair.a].body;
        pack.body_b[pack.size] = stores_.shapes[pair.b].body;
        return ++pack.size == kLanes;
    }

    // Calls visit(pair, its lane) for those that may have met, and empties the pack.
    template <class Visit>
    void for_passed(Pack& pack, const Visit& visit) const {
        if (pack.size == 0) return;
        unsigned passed = passed_lanes(pack.body_a, pack.body_b, pack.size);
        for (; passed != 0; passed &= passed - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(passed));
            visit(pack.pairs[lane], lane);
        }
        pack.size = 0;
    }

    [[nodiscard]] bool can_meet(const ItemPair& pair) const {
        return may_collide(stores_, pair.a, pair.b) && !lets_pass(stores_, pair.a, pair.b);
    }

    [[nodiscard]] float free_share_by_trees(int body) const {
        float share = 1;
        for (int s = stores_.bodies.slots[body].first_shape; s != kNone; s = stores_.shapes[s].next_of_body) {
            const Way way(stores_, s);
            if (!way.is_looked_at()) continue;
            Pack pack;
            const auto follow = [&](const ItemPair& pair, std::size_t) {
                const float met = way.free_share(pair.b);
                if (met < share && can_meet(pair)) share = met;
            };
            const auto visit = [&](int other) {
                if (add({s, other}, pack)) for_passed(pack, follow);
            };
            for (const Layer layer : kLayers)
                stores_.broad.tree(layer).query_segment(way.from(), way.way(), visit);
            for_passed(pack, follow);
        }
        return share;
    }

    // Calls visit(i, found) for 0 up to, and without, count, and takes the least shares found.
    template <class Visit>
    void look(int count, int grain, const Visit& visit) {
        ways_.found_shares.start(count, grain, tasks_);
        tasks_.parallel_for(count, grain, [&](const Chunk& chunk) {
            ChunkedList<FreeShare>::Appender found(ways_.found_shares, chunk);
            for (int i = chunk.begin; i < chunk.end; ++i) visit(i, found.items());
        });
        ways_.found_shares.for_each([&](const FreeShare& found) {
            float& share = ways_.free_shares[found.row];
            share = std::min(share, found.share);
        });
    }

    [[nodiscard]] unsigned passed_lanes(const Lanes<std::int32_t>& body_a, const Lanes<std::int32_t>& body_b,
                                        int used) const {
        return find_passed(places_, body_a, body_b, ways_.displacements.data(), (1u << used) - 1);
    }

    // Two shapes that may have met, seen from each fast body.
    void follow_both(const Side& a, const Side& b, std::vector<FreeShare>& found) const {
        follow(a, b.shape, found);
        follow(b, a.shape, found);
    }
    void follow(const Side& side, int other, std::vector<FreeShare>& found) const {
        if (!is_guarded(stores_, side.body) || is_lost(stores_, side.body)) return;
        const float share = Way(stores_, side.shape).free_share(other);
        if (share < 1) found.push_back({places_[side.body].row, share});
    }

    // By shape, and by lane of the groups; whether there are any.
    bool note_strayed(std::span<const int> fast) {
        bool some = false;
        assign_amply(ways_.strayed, stores_.fat_boxes.size(), std::uint8_t{0});
        for (const int body : fast) {
            if ((places_[body].flags & place_flag::kStrayed) == 0) continue;
            some = true;
            for (int s = stores_.bodies.slots[body].first_shape; s != kNone;
                 s = stores_.shapes[s].next_of_body)
                ways_.strayed[s] = 1;
        }
        if (some) note_strayed_lanes();
        return some;
    }

    void note_strayed_lanes() {
        const std::span<const BroadPhase::GroupItems> groups = stores_.broad.group_items();
        resize_amply(ways_.strayed_lanes, groups.size());
        for (std::size_t g = 0; g < groups.size(); ++g) {
            LaneMask strayed = 0;
            for (int lane = 0; lane < kGroupSize; ++lane) {
                const int item = groups[g][lane];
                if (item != kNone && ways_.strayed[item] != 0) strayed |= 1u << lane;
            }
            ways_.strayed_lanes[g] = strayed;
        }
    }

    const Stores& stores_;
    WayScratch& ways_;
    TaskPool& tasks_;
    const Place* places_;
};

}  // namespace

bool is_guarded(const Stores& stores, int body) {
    return (stores.bodies.places[body].flags & place_flag::kFast) != 0 && stores.bodies.is_awake(body) &&
           stores.bodies.slots[body].type == BodyType::Dynamic;
}

bool takes_shapes_round(const BodyRecord& record) {
    return record.center_arm_m > tuning::kLinearSlop_m;
}

void put_back(Stores& stores, int body, float share, bool turns) {
    BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const BodyRecord& record = stores.bodies.slots[body];
    const Vec2 moved = awake.moved[record.row];
    Place& place = stores.bodies.places[body];
    place.center = place.center + (share - 1) * moved;
    awake.moved[record.row] = share * moved;
    if (turns) {
        const Rotation before = awake.rotation_before[record.row];
        const double turned_rad = (inverse(before) * place.rotation).angle_rad();
        place.rotation = normalized(Rotation::from_angle(share * turned_rad) * before);
    }
    update_boxes(stores, body);
}

namespace {

void put_back(Stores& stores, int body, float share) {
    put_back(stores, body, share, takes_shapes_round(stores.bodies.slots[body]));
}

void find_held(const Stores& stores, std::span<const int> fast, WayScratch& ways, TaskPool& tasks) {
    resize_amply(ways.held, fast.size());
    tasks.parallel_for(static_cast<int>(fast.size()), kRowsPerChunk, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) {
            const int body = fast[static_cast<std::size_t>(i)];
            const bool held =
                is_guarded(stores, body) && ways.free_shares[stores.bodies.places[body].row] < 1;
            ways.held[static_cast<std::size_t>(i)] = held ? 1 : 0;
        }
    });
}

// As far as it was free to go; false where that is all of its way.
bool hold(Stores& stores, const WayScratch& ways, int body) {
    const float share = ways.free_shares[stores.bodies.places[body].row];
    if (share < 1) put_back(stores, body, share);
    return share < 1;
}

// Of a body, by what it touches and cannot push away.
float free_share_of_pressed(const Stores& stores, int body) {
    constexpr float kAllWays = 0;
    float free_share = 1;
    for_each_edge(stores.contacts.slots, stores.bodies.slots[body].first_contact, [&](int contact, int side) {
        const ContactRecord& c = stores.contacts.slots[contact];
        const bool is_b = side == 1;
        if (!is_b || stores.bodies.slots[c.body_a].type == BodyType::Dynamic) return;
        if (special::has(c, special::kRefused | special::kPassing)) return;
        free_share = std::min(free_share, Way(stores, c.shape_b, {}, kAllWays).free_share(c.shape_a));
    });
    return free_share;
}

}  // namespace

void hold_pressed_bodies(Stores& stores, StepScratch& scratch, TaskPool& tasks) {
    std::vector<int>& pressed = scratch.pressed->bodies;
    if (pressed.empty()) return;
    std::sort(pressed.begin(), pressed.end());
    pressed.erase(std::unique(pressed.begin(), pressed.end()), pressed.end());
    std::erase_if(pressed, [&](int body) { return !stores.bodies.is_awake(body); });
    // They are held by what is not dynamic, never by each other, so their order does not matter.
    std::vector<float>& free_shares = scratch.pressed->free_shares;
    resize_amply(free_shares, pressed.size());
    tasks.parallel_for(static_cast<int>(pressed.size()), kPressedPerChunk, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) {
            const auto at = static_cast<std::size_t>(i);
            free_shares[at] = free_share_of_pressed(stores, pressed[at]);
        }
    });
    for (std::size_t i = 0; i < pressed.size(); ++i) {
        if (free_shares[i] < 1) put_back(stores, pressed[i], free_shares[i]);
    }
}

void hold_fast_bodies(Stores& stores, StepScratch& scratch, TaskPool& tasks) {
    if (scratch.fast.empty()) return;
    if (!scratch.ways) scratch.ways = std::make_unique<WayScratch>();
    WayScratch& ways = *scratch.ways;
    note_displacements(stores, ways, tasks);
    Guard guard(stores, ways, tasks);
    guard.look_at_lost(scratch.fast);
    guard.look_at_blocks();
    guard.look_beside(scratch.fast, scratch.beside);
    guard.look_at_loose();
    std::vector<int>& turned_back = ways.turned_back;
    turned_back.clear();
    find_held(stores, scratch.fast, ways, tasks);
    for (std::size_t i = 0; i < scratch.fast.size(); ++i) {
        const int body = scratch.fast[i];
        if (ways.held[i] != 0 && hold(stores, ways, body) && takes_shapes_round(stores.bodies.slots[body]))
            turned_back.push_back(body);
    }
    for (int round = 0; round < kMostRounds && !turned_back.empty(); ++round) {
        guard.look_again(turned_back);
        std::erase_if(turned_back, [&](int body) { return !hold(stores, ways, body); });
    }
}

}  // namespace cairn::physics
