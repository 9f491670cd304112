// Contacts are brought up to date, in lanes where they can be.
#include "world/contact_update.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <span>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "base/prefetch.h"
#include "world/bent_ways.h"
#include "world/contact_events.h"
#include "world/contact_lists.h"
#include "world/contacts.h"
#include "world/direct_groups.h"
#include "world/fast_bodies.h"
#include "world/narrow_phase.h"
#include "world/near_pairs.h"
#include "world/one_way.h"
#include "world/plain_contacts.h"
#include "world/pressed_bodies.h"
#include "world/sleep.h"
#include "world/special_contacts.h"
#include "world/tiny_contacts.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kBlocksPerChunk = 8;
constexpr int kBodiesPerChunk = 512;

// Blocks ahead of which bodies and shapes are asked for.
constexpr std::size_t kPairsAhead = 2;

// Blocks of near pairs ahead of which contacts are asked for, and the blocks themselves twice as far ahead.
constexpr std::size_t kFindingsAhead = 8;

// A kinematic body that stands still disturbs nobody.
bool disturbs(const BodyStore& bodies, int body) {
    const BodyRecord& record = bodies.slots[body];
    if (record.set != RowSet::Awake) return false;
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    return record.type == BodyType::Dynamic || awake.velocity[record.row] != Vec2{} ||
           awake.spin[record.row] != 0;
}

void wake_touched(Stores& stores, const ContactRecord& c) {
    const auto sleeps = [&](int body) {
        const BodyRecord& record = stores.bodies.slots[body];
        return record.set == RowSet::Asleep && record.type == BodyType::Dynamic;
    };
    if (sleeps(c.body_a) && disturbs(stores.bodies, c.body_b)) wake_body(stores, c.body_a);
    if (sleeps(c.body_b) && disturbs(stores.bodies, c.body_a)) wake_body(stores, c.body_b);
}

// One pass over the contacts of a step. What leaves its list is noted first and moved after the pass.
class Update {
  public:
    Update(WorldState& world, const StepTime& time, const ContactRules& rules)
        : world_(world),
          stores_(world.stores),
          scratch_(world.scratch),
          time_(time),
          plain_(world.stores, world.scratch, time, rules),
          impact_speed_(std::min(world.def.hit_speed_m_s, world.def.restitution_speed_m_s)) {}

    void run() {
        plain_.begin();
        if (!scratch_.pressed) scratch_.pressed = std::make_unique<PressedScratch>();
        scratch_.pressed->bodies.clear();
        if (stores_.contacts.slots.size() > 0) {
            look_at_all();
        } else {
            find_none();
        }
        const std::span<const int> moved = stores_.boxes_moved;
        world_.tasks.parallel_for(static_cast<int>(moved.size()), kBodiesPerChunk, [&](const Chunk& chunk) {
            for (int i = chunk.begin; i < chunk.end; ++i)
                stores_.bodies.places[moved[i]].flags &= ~place_flag::kBoxesMoved;
        });
        stores_.boxes_moved.clear();
    }

  private:
    void look_at_all() {
        std::array<int, kPairGeometries> near_before{};
        for (int g = 0; g < kPairGeometries; ++g)
            near_before[g] = stores_.contacts.lanes.near_count(static_cast<PairGeometry>(g));
        const int awake_before = stores_.bodies.rows(RowSet::Awake).size();
        update_uncolored();
        // What finds no colour is looked at once more, and there a side is decided, with which it may.
        while (!scratch_.met.empty()) {
            color_met();
            update_uncolored();
        }
        // What woke may hang together with what moves already, and nothing else holds its joints.
        if (stores_.bodies.rows(RowSet::Awake).size() > awake_before) {
            choose_direct_groups(stores_, world_.def.joint_solver, time_.most_swept_hz, world_.direct);
            plain_.leave_to_groups();
        }
        stores_.contacts.lanes.arrange();
        update_blocks();
        const auto ask_for_both = [&](int contact) {
            ask_for_place(stores_.contacts, contact);
            ask_for_bodies(stores_, contact);
        };
        visit_contacts(stores_.contacts, scratch_.parted, ask_for_both,
                       [&](int contact) { forget_points(stores_, contact); });
        scratch_.parted.clear();
        plain_.end();
        remove_gone(stores_, world_.events, scratch_);
        stores_.contacts.lanes.arrange();
        for (int g = 0; g < kPairGeometries; ++g)
            stores_.contacts.lanes.shrink_near(static_cast<PairGeometry>(g), near_before[g]);
    }

    void color_met() {
        visit_contacts(
            stores_.contacts, scratch_.met, [&](int contact) { ask_for_place(stores_.contacts, contact); },
            [&](int contact) { unlist_contact(stores_, contact); });
        loose_done_ = stores_.contacts.loose.size();
        stores_.contacts.lanes.make_room(scratch_.met.size());
        visit_contacts(
            stores_.contacts, scratch_.met, [&](int contact) { ask_for_bodies(stores_, contact); },
            [&](int contact) { color_contact(stores_, contact); });
        scratch_.met.clear();
    }

    // Where there are no contacts at all: what a look at them would find.
    void find_none() {
        find_unmoved();
        stores_.contacts.lanes.arrange();
        scratch_.standing->all_blocks_known = true;
        scratch_.some_bounce_in_lanes = false;
        scratch_.notes_in_order.clear();
        plain_.end();
    }

    // Near and loose contacts from where the last call left off: waking lists more.
    void update_uncolored() {
        const auto lanes = [&](PairGeometry geometry) { return stores_.contacts.lanes.near_count(geometry); };
        const auto near_is_done = [&] {
            for (int g = 0; g < kPairGeometries; ++g) {
                if (near_done_[g] < lanes(static_cast<PairGeometry>(g))) return false;
            }
            return true;
        };
        while (!near_is_done() || loose_done_ < stores_.contacts.loose.size()) {
            for (int g = 0; g < kPairGeometries; ++g) {
                near_done_[g] = update_near(static_cast<PairGeometry>(g), near_done_[g]);
            }
            while (loose_done_ < stores_.contacts.loose.size()) {
                update_loose(stores_.contacts.loose[loose_done_++]);
            }
        }
    }

    // Near pairs from a lane on: looked at on several threads; then, one by one, those that meet or may meet,
    // and those whose boxes have parted. The result is how many pairs there were.
    int update_near(PairGeometry geometry, int first) {
        const int count = stores_.contacts.lanes.near_count(geometry);
        if (first >= count) return first;
        find_near(stores_, geometry, first, count, world_.def.gravity_m_s2, time_.dt_s, scratch_,
                  world_.tasks);
        ahead_ = scratch_.near_ahead;
        const int first_block = first / kLanes;
        const std::vector<NearFindings>& findings = scratch_.near_findings;
        std::vector<int>& found = scratch_.near_found;
        found.clear();
        reserve_amply(found, findings.size());
        for (std::size_t i = 0; i < findings.size(); ++i) {
            if (findings[i].any() != 0) found.push_back(static_cast<int>(i));
        }
        const auto for_each_found = [&](int i, const auto& ask) {
            const std::size_t first_pair = static_cast<std::size_t>(first_block + i) * kLanes;
            const NearPair* pairs = &stores_.contacts.lanes.near_pairs(geometry)[first_pair];
            for (unsigned rest = findings[i].any(); rest != 0; rest &= rest - 1)
                ask(pairs[std::countr_zero(rest)]);
        };
        visit_asking_ahead(
            found, 2 * kFindingsAhead,
            [&](int i) { for_each_found(i, [](const NearPair& pair) { prefetch(&pair, sizeof pair); }); },
            [&](int i) {
                for_each_found(i,
                               [&](const NearPair& pair) { stores_.contacts.slots.ask_for(pair.contact); });
            },
            [&](int i) {
                const int block = first_block + i;
                settle_near(geometry, block, near_lanes(first, count, block), findings[i]);
            });
        return count;
    }

    void settle_near(PairGeometry geometry, int block, unsigned lanes, const NearFindings& found) {
        for (unsigned rest = found.any() & lanes; rest != 0; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            // Waking may move the pairs.
            const auto pair = [&]() -> NearPair& {
                return stores_.contacts.lanes.near_pairs(geometry)[block * kLanes + lane];
            };
            const int contact = pair().contact;
            if ((found.gone >> lane & 1) != 0) {
                push_amply(scratch_.gone, contact);
            } else if ((found.meets >> lane & 1) != 0) {
                if (meets(contact)) push_amply(scratch_.met, contact);
            } else if (predict(contact, next_ahead((found.will_meet >> lane & 1) != 0))) {
                pair().flags |= near_flag::kRemembers;
            } else {
                forget(pair());
                if ((found.rouses >> lane & 1) != 0) rouse(stores_.contacts.slots[contact]);
            }
        }
    }

    const ContactInput* next_ahead(bool will_meet) {
        if (!will_meet) return nullptr;
        const ContactInput* next = &ahead_.front().input;
        ahead_ = ahead_.subspan(1);
        return next;
    }

    // The pair was in touch, or was about to be, and is apart again.
    void forget(NearPair& pair) {
        if ((pair.flags & near_flag::kRemembers) == 0) return;
        pair.flags &= ~near_flag::kRemembers;
        ContactRecord& c = stores_.contacts.slots[pair.contact];
        report_parting(stores_, c, world_.events.ends);
        c.has_points = false;
        c.memory = {};
    }

    // The contact has points: what sleeps wakes. False between a platform at rest and what sleeps on it,
    // where nothing happens.
    bool meets(int contact) {
        ContactRecord& c = stores_.contacts.slots[contact];
        if (!c.has_points) {
            c.put_in = true;  // until its depth is known
            stores_.contacts.put_in.push_back(contact);
        }
        c.has_points = true;
        rouse(c);
        return stores_.bodies.is_awake(c.body_b) ||
               (stores_.bodies.is_awake(c.body_a) && is_dynamic(c.body_a));
    }

    // What sleeps wakes, and takes part in this step.
    void rouse(const ContactRecord& c) {
        wake_touched(stores_, c);
        extend_motions(stores_.bodies, world_.def.gravity_m_s2, time_.dt_s, scratch_, world_.tasks);
        extend_advances(stores_, world_.def.gravity_m_s2, time_.dt_s, scratch_);
    }

    // A pair that is apart but meets within the step is solved in plain form, wherever it is listed. `ahead`
    // is the contact of then, or null.
    bool predict(int contact, const ContactInput* ahead) {
        ContactRecord& c = stores_.contacts.slots[contact];
        if (ahead == nullptr) {
            if (special::has(c, special::kOneWay)) forget_side(c);
            return false;
        }
        if (special::has(c, special::kOneWay) && !is_held_out(stores_, c)) return false;
        (void)meets(contact);
        ContactInput input = *ahead;
        input.a = stores_.bodies.places[c.body_a].row;
        input.b = stores_.bodies.places[c.body_b].row;
        input.contact = contact;
        input.unit = length_unit(stores_, c);
        plain_.add(input, c.memory);
        expect_bends(stores_, input, time_.dt_s, scratch_);
        return true;
    }

    [[nodiscard]] bool meets_again(const BlockPlaces& places, const ManifoldLanes& manifold, int lane,
                                   int contact, ContactInput& input) const {
        return meets_ahead(stores_, scratch_.advances, places, manifold, lane, contact,
                           world_.def.gravity_m_s2, time_.dt_s, input);
    }

    // All blocks, on several threads and as they stand in memory; then what they found that touches more than
    // the block itself, in the order of the colours. Contacts that are gone stand in none, so they are
    // removed meanwhile.
    void update_blocks() {
        find_unmoved();
        const std::span<const int> blocks =
            knows_all() ? std::span<const int>() : stores_.contacts.lanes.blocks_in_memory();
        const int count = static_cast<int>(blocks.size());
        if (count == 0) remove_gone(stores_, world_.events, scratch_);
        reserve_amply(scratch_.block_findings, stores_.contacts.lanes.pool_room());
        scratch_.block_findings.resize(static_cast<std::size_t>(stores_.contacts.lanes.pool_size()));
        scratch_.notes.start(count, kBlocksPerChunk, world_.tasks);
        scratch_.pressed->found.start(count, kBlocksPerChunk, world_.tasks);
        if (scratch_.motions.some_turn_far) stores_.contacts.lanes.make_room_for_turns();
        std::atomic<int> known = 0;
        world_.tasks.parallel_for(count, kBlocksPerChunk, [&](const Chunk& chunk) {
            BlockPlaces places;
            ManifoldLanes manifold;
            ChunkedList<LaneNote>::Appender notes(scratch_.notes, chunk);
            ChunkedList<int>::Appender pressed(scratch_.pressed->found, chunk);
            int known_here = 0;
            if (chunk.index == 0) remove_gone(stores_, world_.events, scratch_);
            for (int i = chunk.begin; i < chunk.end; ++i) {
                fetch_ahead(blocks, i);
                BlockFindings& found = scratch_.block_findings[blocks[i]];
                if (is_known(found, blocks[i])) {
                    start_as_before(stores_.contacts.lanes.block(blocks[i]));
                    ++known_here;
                    continue;
                }
                const std::size_t noted = notes.items().size();
                const unsigned gone = update_block(blocks[i], places, manifold, notes.items());
                found.gone = static_cast<std::uint8_t>(gone);
                found.notes = static_cast<std::uint8_t>(notes.items().size() - noted);
                found.bounces = stores_.contacts.lanes.block(blocks[i]).bounces != 0;
                found.presses = note_pressed(stores_, blocks[i], pressed.items());
            }
            known.fetch_add(known_here, std::memory_order_relaxed);
        });
        scratch_.standing->all_blocks_known = known == count;
        scratch_.pressed->found.for_each([&](int body) { push_amply(scratch_.pressed->bodies, body); });
        int all_notes = 0;
        scratch_.some_bounce_in_lanes = false;
        if (count == 0) return scratch_.notes_in_order.clear();
        for (const int block : stores_.contacts.lanes.blocks()) {
            BlockFindings& found = scratch_.block_findings[block];
            for (unsigned gone = found.gone; gone != 0; gone &= gone - 1)
                push_amply(scratch_.gone,
                           stores_.contacts.lanes.pairs(block).contact[std::countr_zero(gone)]);
            found.next_note = all_notes;
            all_notes += found.notes;
            scratch_.some_bounce_in_lanes |= found.bounces;
        }
        resize_amply(scratch_.notes_in_order, static_cast<std::size_t>(all_notes));
        scratch_.notes.for_each([&](const LaneNote& note) {
            scratch_.notes_in_order[scratch_.block_findings[note.block].next_note++] = &note;
        });
        const auto ask = [&](const LaneNote* note) { stores_.contacts.slots.ask_for(note->contact); };
        visit_asking_ahead(scratch_.notes_in_order, kRecordsAhead, ask,
                           [&](const LaneNote* note) { settle(*note); });
    }

    // Only where something stood in the last step, and nothing is afoot that could change what blocks found.
    void find_unmoved() {
        if (!scratch_.standing) scratch_.standing = std::make_unique<StandingScratch>();
        Unmoved& unmoved = scratch_.standing->unmoved;
        unmoved.make_room(scratch_.motions.size());
        // Places of awake bodies are compared; others that went elsewhere have new boxes.
        const auto is_asleep = [&](int body) { return !stores_.bodies.is_awake(body); };
        if (scratch_.motions.standing.empty() || world_.direct.count > 0 ||
            std::ranges::any_of(stores_.boxes_moved, is_asleep))
            return unmoved.forget();
        unmoved.compare(stores_.bodies.places, stores_.bodies.rows(RowSet::Awake).body, scratch_.motions,
                        {stores_.contacts.lanes.version(), world_.def.gravity_m_s2}, world_.tasks);
    }

    // Whether all blocks are known, and as they were when the last step began.
    [[nodiscard]] bool knows_all() const {
        const StandingScratch& standing = *scratch_.standing;
        return standing.unmoved.all() && standing.all_blocks_known && standing.none_solved;
    }

    // Whether looking at the block would find what it found in the last step: nothing to be noted.
    [[nodiscard]] bool is_known(const BlockFindings& last, int block) const {
        const Unmoved& unmoved = scratch_.standing->unmoved;
        return unmoved.some() && last.notes == 0 && last.gone == 0 && !last.bounces && !last.presses &&
               stores_.contacts.lanes.block(block).turning == nullptr &&
               unmoved.all_of(stores_.contacts.lanes.block(block));
    }

    // What a step changes of a block, besides impulses, is as it was at its beginning.
    static void start_as_before(ContactBlock& block) {
        for (ContactBlockPoint& point : block.points) point.separation = point.start_separation;
    }

    void fetch_ahead(std::span<const int> blocks, int at) const {
        const ContactLanes& lanes = stores_.contacts.lanes;
        const std::size_t soon = static_cast<std::size_t>(at) + kPairsAhead;
        if (soon < blocks.size()) {
            const int block = blocks[soon];
            ask_for_pairs(stores_, lanes.pairs(block), geometry_of(lanes.link(block).bucket),
                          lanes_of(block));
        }
        const std::size_t ahead = static_cast<std::size_t>(at) + kBlocksAhead;
        if (ahead >= blocks.size()) return;
        prefetch(&lanes.pairs(blocks[ahead]), sizeof(PairBlock));
        prefetch(&lanes.block(blocks[ahead]), sizeof(ContactBlock));
    }

    [[nodiscard]] unsigned lanes_of(int block) const {
        return (1u << stores_.contacts.lanes.link(block).used) - 1;
    }

    void collide(const PairBlock& pairs, PairGeometry geometry, unsigned lanes, BlockPlaces& places,
                 ManifoldLanes& manifold, float unit = 1) const {
        load_places(stores_.bodies.places.data(), pairs.body_a, pairs.body_b, lanes, places);
        collide_block(stores_, pairs, geometry, lanes, places.poses, manifold, unit);
    }

    // The result are the lanes of which the boxes have parted.
    unsigned update_block(int block_index, BlockPlaces& places, ManifoldLanes& manifold,
                          std::vector<LaneNote>& notes) {
        PairBlock& pairs = stores_.contacts.lanes.pairs(block_index);
        ContactBlock& block = stores_.contacts.lanes.block(block_index);
        const PairGeometry geometry = geometry_of(stores_.contacts.lanes.link(block_index).bucket);
        collide(pairs, geometry, lanes_of(block_index), places, manifold);
        block.a = places.row_a;
        block.b = places.row_b;
        block.turning = nullptr;
        const PreparedLanes prepared = prepare_block(
            places.poses, manifold, scratch_.motions.velocity.data(), scratch_.motions.pose.data(),
            pairs.features, impact_speed_, block, stores_.contacts.lanes.impacts(block_index));
        // The boxes of what has points overlap.
        const unsigned without = prepared.apart & lanes_of(block_index);
        const unsigned gone = gone_lanes(stores_, pairs.shape_a, pairs.shape_b, places.boxes_moved & without);
        const unsigned apart = without & ~gone;
        const unsigned faint = pairs.faint & prepared.fast & ~prepared.apart;
        const unsigned told =
            ((pairs.reports | (pairs.impacts & prepared.fast)) & ~prepared.apart) | lone_lanes(pairs, faint);
        const unsigned swings = places.turn_far & prepared.swings & ~places.direct & ~prepared.apart;
        const unsigned loose =
            (places.direct & ~prepared.apart) | turn_in_lanes(block_index, pairs, places, manifold, swings);
        const unsigned deep = calm_lanes(block, prepared.deep & ~places.direct & ~prepared.apart);
        // What takes the plain form bounces in it.
        const unsigned bounces = faint & ~(told | loose | deep);
        block.bounces = static_cast<LaneBits>(bounces);
        block.reports = (told | bounces) != 0;
        const unsigned plain = (told | loose | deep) & ~gone;
        for (unsigned rest = apart | plain; rest != 0; rest &= rest - 1)
            stores_.contacts.slots.ask_for(pairs.contact[std::countr_zero(rest)]);
        for (unsigned rest = apart; rest != 0; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            LaneNote& note = notes.emplace_back(LaneNote{block_index, lane, pairs.contact[lane], false, {}});
            ContactInput ahead;
            if (meets_again(places, manifold, lane, pairs.contact[lane], ahead)) note.form = ahead;
        }
        for (unsigned rest = plain; rest != 0; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            const bool is_loose = (loose >> lane & 1) != 0;
            LaneNote& note =
                notes.emplace_back(LaneNote{block_index, lane, pairs.contact[lane], is_loose, {}});
            note.form = plain_.form_of(make_input(stores_, pairs, places, manifold, lane), block, lane);
        }
        return gone;
    }

    // Of some lanes with bodies that turn far, those that turn too far for a lane.
    [[nodiscard]] unsigned turn_in_lanes(int block, const PairBlock& pairs, const BlockPlaces& places,
                                         const ManifoldLanes& manifold, unsigned lanes) {
        unsigned whirling = 0;
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            const auto whirls = [&](int body) {
                constexpr std::uint32_t kInPlainForm = place_flag::kWhirls | place_flag::kSweeps;
                return (stores_.bodies.places[body].flags & kInPlainForm) != 0;
            };
            if (whirls(pairs.body_a[lane]) || whirls(pairs.body_b[lane])) {
                whirling |= 1u << lane;
            } else {
                const Bows bows = bows_of(stores_, pairs, places, manifold, lane);
                stores_.contacts.lanes.turn(block, lane, bows.a_m, bows.b_m);
            }
        }
        return whirling;
    }

    // Of some lanes, those of bodies that no other contact in a lane moves: what they do can be told exactly.
    [[nodiscard]] unsigned lone_lanes(const PairBlock& pairs, unsigned lanes) const {
        const auto is_moved_more = [&](int body) {
            const auto at = static_cast<std::size_t>(body);
            return at < stores_.contacts.colors.size() && is_in_several(stores_.contacts.colors[at]);
        };
        unsigned lone = 0;
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            if (!is_moved_more(pairs.body_a[lane]) && !is_moved_more(pairs.body_b[lane])) lone |= 1u << lane;
        }
        return lone;
    }

    void settle(const LaneNote& note) {
        const auto* plain = std::get_if<ContactConstraint>(&note.form);
        if (plain != nullptr)
            return plain_.add_beside(*plain, note.block * kLanes + note.lane, note.is_loose);
        part(note.contact, std::get_if<ContactInput>(&note.form));
    }

    // The contact has no points any more. It leaves its list after this pass.
    void part(int contact, const ContactInput* ahead) {
        // What it bore was in its lane, and went with the points.
        stores_.contacts.slots[contact].memory = {};
        if (predict(contact, ahead)) {
            push_amply(scratch_.parted, contact);
        } else {
            lose_points(contact);
        }
    }

    void lose_points(int contact) {
        push_amply(scratch_.parted, contact);
        report_parting(stores_, stores_.contacts.slots[contact], world_.events.ends);
        stores_.contacts.slots[contact].has_points = false;
    }

    // Of some lanes. In a dense crowd many overlap deeply, and few of those are calm.
    [[nodiscard]] unsigned calm_lanes(const ContactBlock& block, unsigned lanes) const {
        unsigned calm = 0;
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            if (is_calm(scratch_.motions, block.a[lane]) && is_calm(scratch_.motions, block.b[lane]))
                calm |= 1u << lane;
        }
        return calm;
    }

    void update_loose(int contact) {
        ContactRecord& c = stores_.contacts.slots[contact];
        single_.contact[0] = contact;
        single_.body_a[0] = c.body_a;
        single_.body_b[0] = c.body_b;
        single_.shape_a[0] = c.shape_a;
        single_.shape_b[0] = c.shape_b;
        const float unit = length_unit(stores_, c);
        collide(single_, PairGeometry::Chains, 1, places_, manifold_, unit);
        if (gone_lanes(stores_, single_.shape_a, single_.shape_b, places_.boxes_moved) != 0) {
            push_amply(scratch_.gone, contact);
            return;
        }
        if (special::has(c, special::kRefused)) return;
        if (manifold_.points[0].id[0] == kNoFeature) {
            ContactInput ahead;
            const bool will_meet = meets_again(places_, manifold_, 0, contact, ahead);
            if (predict(contact, will_meet ? &ahead : nullptr)) return;
            if (c.has_points) lose_points(contact);
            if (may_reach(scratch_.advances, places_, manifold_, 0, time_.dt_s)) rouse(c);
            return;
        }
        if (!c.has_points &&
            passes_corner(stores_, manifold_, 0, contact, world_.def.gravity_m_s2, time_.dt_s))
            return;
        const bool was_loose = is_loose(c);
        if (special::has(c, special::kOneWay) && !is_held_out(stores_, c)) {
            if (c.has_points) lose_points(contact);
            return;
        }
        if (was_loose && !is_loose(c)) {  // decided just now
            if (meets(contact)) push_amply(scratch_.met, contact);
            return;
        }
        if (!meets(contact)) return;
        ContactInput input = make_input(stores_, single_, places_, manifold_, 0);
        // What slept when its place was read has woken.
        input.a = stores_.bodies.places[c.body_a].row;
        input.b = stores_.bodies.places[c.body_b].row;
        if (special::has(c, special::kSurface)) {
            const SurfaceEffects effects = surface_effects(stores_, c);
            input.rolling_m = effects.rolling_m;
            input.surface_speed_m_s = effects.speed_m_s;
        }
        input.unit = unit;
        note_pressed(stores_, input, scratch_.pressed->bodies);
        plain_.add(input, c.memory);
    }

    [[nodiscard]] bool is_dynamic(int body) const {
        return stores_.bodies.slots[body].type == BodyType::Dynamic;
    }

    WorldState& world_;
    Stores& stores_;
    StepScratch& scratch_;
    const StepTime& time_;
    PlainContacts plain_;
    float impact_speed_;  // m/s; slower contacts neither bounce nor tell of a hit
    BlockPlaces places_;
    ManifoldLanes manifold_;
    PairBlock single_{};                // a loose contact, in the first lane
    std::span<const NearAhead> ahead_;  // of the near pairs that are being settled, from the next one on
    std::array<int, kPairGeometries> near_done_{};
    std::size_t loose_done_ = 0;
};

}  // namespace

void update_contacts(WorldState& world, const StepTime& time, const ContactRules& rules) {
    Update(world, time, rules).run();
}

}  // namespace cairn::physics
