// Everything a world holds, as data. The functions on it are in the other files of this folder.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <cairn/physics/world.h>

#include "base/ample.h"
#include "base/chunked_list.h"
#include "base/motion.h"
#include "base/task_pool.h"
#include "base/union_find.h"
#include "broad/broad_phase.h"
#include "collide/place_lanes.h"
#include "islands/islands.h"
#include "resolve/contact_batches.h"
#include "resolve/contact_constraint.h"
#include "resolve/deep_overlap.h"
#include "resolve/direct/direct_component.h"
#include "resolve/direct/pin_chain.h"
#include "resolve/impacts.h"
#include "resolve/joints/joint_constraint.h"
#include "resolve/joints/pin_statics.h"
#include "resolve/joints/torn_joints.h"
#include "resolve/restitution_kernel.h"
#include "resolve/support_lanes.h"
#include "world/body_mass.h"
#include "world/body_store.h"
#include "world/breakable_store.h"
#include "world/chain_store.h"
#include "world/contact_store.h"
#include "world/direct_structures.h"
#include "world/domain_store.h"
#include "world/filter_calls.h"
#include "world/joint_store.h"
#include "world/material_mixing.h"
#include "world/plain_groups.h"
#include "world/resting.h"
#include "world/sensors.h"
#include "world/shape_store.h"
#include "world/unmoved.h"

namespace cairn::physics {

/// What the host said about pairs of shapes in general.
struct PairRules {
    PairFilter filter;
    MixingTable mixing;
};
/// Where the broad phase keeps the shapes of such a body.
inline Layer layer_of(RowSet set) {
    switch (set) {
        case RowSet::Static:
            return Layer::Static;
        case RowSet::Asleep:
            return Layer::Asleep;
        case RowSet::Awake:
            return Layer::Awake;
    }
    return Layer::Awake;
}

/// The objects of a world and how they hang together.
struct Stores {
    explicit Stores(std::uint16_t tag) : bodies(tag), shapes(tag), chains(tag), contacts(tag), joints(tag) {}

    BodyStore bodies;
    ShapePrototypes prototypes;
    ShapeStore shapes;
    std::vector<Aabb> fat_boxes;  // by shape: in the broad phase
    ChainStore chains;
    ContactStore contacts;
    JointStore joints;
    Domains domains;  // of the lanes of both
    BroadPhase broad;
    std::vector<int> boxes_moved;  // bodies of which a box was made anew since contacts were updated last
    MassLedger masses;
    PairRules rules;
    SensorStore sensors;
    std::vector<Breakable> breakables;
    FilterCalls filter_calls;  // of queries
};

/// A shape with its box; that of a sensor is empty.
inline int insert_shape(Stores& stores, const ShapeRecord& record, const Aabb& fat_box) {
    const int shape = stores.shapes.insert(record);
    cover_amply(stores.fat_boxes, static_cast<std::size_t>(shape) + 1);
    stores.fat_boxes[shape] = fat_box;
    return shape;
}

inline void erase_shape(Stores& stores, int shape) {
    stores.prototypes.release(stores.shapes[shape].prototype);
    stores.shapes.erase(shape);
}

/// Makes the shape of something else; `def` holds what is its own too.
inline void remake_shape(Stores& stores, int shape, const Convex& convex, const ShapeDef& def) {
    ShapeRecord& record = stores.shapes[shape];
    ShapePrototype* const before = record.prototype;
    record.take_prototype(stores.prototypes, convex, def);
    stores.prototypes.release(before);
}

/// The same, for a change of its definition: change(def).
template <class Change>
void redefine_shape(Stores& stores, int shape, const Change& change) {
    ShapeDef def = stores.shapes[shape].def();
    change(def);
    remake_shape(stores, shape, stores.shapes[shape].convex(), def);
}

/// The contacts of the body will be asked whether their boxes still overlap. Whether it is yet to be listed
/// in boxes_moved.
inline bool mark_moved_boxes(Stores& stores, int body) {
    std::uint32_t& flags = stores.bodies.places[body].flags;
    if (flags & place_flag::kBoxesMoved) return false;
    flags |= place_flag::kBoxesMoved;
    return true;
}
inline void note_moved_boxes(Stores& stores, int body) {
    if (mark_moved_boxes(stores, body)) push_amply(stores.boxes_moved, body);
}

struct Events {
    std::vector<ContactBegin> begins;
    std::vector<ContactEnd> ends;
    std::vector<ContactHit> hits;
    std::vector<JointBreak> joint_breaks;
    std::vector<SensorBegin> sensor_begins;
    std::vector<SensorEnd> sensor_ends;
    std::vector<BodyBreak> breaks;
    std::vector<Overload> overloads;    // behind the breaks
    std::vector<BodyId> broken_pieces;  // to which the breaks refer
    std::vector<BodyId> quarantined;
    /// Ends caused between steps, by destroying things; they are told with the next step.
    std::vector<ContactEnd> pending_ends;
    std::vector<SensorEnd> pending_sensor_ends;
};

std::uint64_t hash_state(const WorldState& world);

/// Stage: forgets the events of the step before.
inline void start_events(Events& events) {
    events.begins.clear();
    events.hits.clear();
    events.joint_breaks.clear();
    events.quarantined.clear();
    events.breaks.clear();
    events.overloads.clear();
    events.broken_pieces.clear();
    events.ends.clear();
    events.ends.swap(events.pending_ends);
    events.sensor_begins.clear();
    events.sensor_ends.clear();
    events.sensor_ends.swap(events.pending_sensor_ends);
}

/// A support is a lane of the supports: of block i / kLanes, lane i % kLanes.
struct StaticsScratch {
    /// What stands on a body, while it is found out.
    struct Stand {
        int first = kNone;  // support of the body
        int above = 0;      // bearing contacts from above that are not visited yet
        float load = 0;     // N s
        float moment = 0;   // of the load, in scaled arms
    };
    std::vector<SupportLanes> supports;
    std::vector<int> next;      // support of the same body, by support
    std::vector<Stand> stands;  // by row of the motions
    std::vector<int> ready;     // rows of which all above has been visited
    std::vector<int> slopes;    // supports that are
    std::vector<float> x;       // of the supporting points of one body
    std::vector<float> shares;
};

/// What is known of things that stand (docs/adr/021-rest.md).
struct StandingScratch {
    Unmoved unmoved;
    Resting resting;
    bool all_blocks_known = false;  // none of them was looked at in this step, since all would be the same
    bool all_rest = false;          // and would be left by the passes as they are
    bool most_rest = false;         // or most would be
    bool none_solved = false;       // no pass went over any block in the last step
    // For what the statics estimate was made last, if that was noted.
    Vec2 weight_ns_kg;
    std::vector<float> gravity_scales;  // by row; empty where not
};

/// What comes of telling many boxes at once, on several threads.
struct ShiftedBoxes {
    ChunkedList<int> first_moves;  // shapes, of which it is the first since the last search
    ChunkedList<int> bodies;       // that are marked anew
};

/// How much of its way a body was free to go.
struct FreeShare {
    int row = 0;
    float share = 1;
};

/// For the guard of fast bodies.
struct WayScratch {
    std::vector<Displacement> displacements;  // by row of the motions
    ChunkedList<int> sweeping;                // fast bodies that swept (world/sweeping_contacts.h)
    std::vector<std::uint8_t> strayed;        // by shape: the body went another way than was expected
    std::vector<LaneMask> strayed_lanes;      // the same, by group of the broad phase
    ChunkedList<FreeShare> found_shares;      // of ways that met something
    std::vector<float> free_shares;           // of all ways, by row: the least that was found
    std::vector<std::uint8_t> held;           // beside the fast bodies: it was not free to go all of it
    std::vector<int> turned_back;             // bodies, of which the shapes are to be looked at again
};

/// Bodies that others press deep into what cannot give way (world/pressed_bodies.h).
struct PressedScratch {
    std::vector<int> bodies;
    std::vector<float> free_shares;  // of their ways
    ChunkedList<int> found;          // by contacts in lanes
};

/// A contact in a lane that wants more than its block can do for it.
struct LaneNote {
    int block;
    int lane;
    int contact;
    bool is_loose;  ///< solved in plain form instead of the lane's; else beside it
    /// The plain form. What has no points any more has none, or the contact that it will make again within
    /// the step.
    std::variant<std::monostate, ContactInput, ContactConstraint> form;
};

/// What was found in a block in a colour that touches more than the block.
struct BlockFindings {
    int next_note = 0;  // of all blocks, in the order of the colours
    std::uint8_t notes = 0;
    std::uint8_t gone = 0;  // bits: lanes of which the boxes have parted
    bool bounces = false;   // in some lane
    bool presses = false;   // some body deep into what cannot give way
};

/// A contact that acts once, when it is reached (world/awaited_contacts.h).
struct AwaitedContact {
    int contact;         ///< in the plain form
    int substep;         ///< in which it is reached
    ContactInput input;  ///< with the arms of the impact
    Vec2 between;        ///< centre of b less centre of a, m, at the start of the step
};

/// Where a predicted contact may have turned a body aside (world/bent_ways.h).
struct Bend {
    int body;
    int contact;        ///< in the plain form
    float share;        ///< of the step, at which it acts
    Vec2 moved;         ///< from the start of the step until then
    Rotation rotation;  ///< then
};

/// A body that whirls at what it touches, and how much of its way it may go (world/bent_ways.h).
struct Whirled {
    int body;
    float share;
};

/// For bodies that predicted contacts turn aside.
struct BentScratch {
    std::vector<Bend> bends;     // in the order of the contacts; of all that are expected
    std::vector<Bend> followed;  // those of which the rest of the way may lead through something
    std::vector<float> shares;   // of that rest, beside them: how much is free
    std::vector<Whirled> whirled;
};

/// A contact that is collided anew in each substep (world/sweeping_contacts.h).
struct SweepingContact {
    int contact;        ///< in the plain form
    int first_substep;  ///< in which it is
    Vec2 first_normal;  ///< as it was when it was added
};

/// What was found in a block of pairs that had no points, as bits by lane.
struct NearFindings {
    std::uint8_t gone = 0;       // the boxes have parted
    std::uint8_t meets = 0;      // points
    std::uint8_t will_meet = 0;  // within the step
    std::uint8_t rouses = 0;     // reaches what sleeps within the step, and is solved from the next one on
    std::uint8_t remembers = 0;  // as the pairs have it

    [[nodiscard]] unsigned any() const {
        return static_cast<unsigned>(gone | meets | will_meet | rouses | remembers);
    }
};

/// A contact that is yet to be made (world/new_contacts.h).
struct NewContact {
    bool makes = false;  // if not, nothing else is told
    PairGeometry geometry{};
    ContactRecord record;
    NearPair pair;  // what it will be among the near ones
};

/// A near pair that will meet within the step.
struct NearAhead {
    int lane;
    ContactInput input;
};

/// Impacts that go from one body to the next (world/impact_groups.h).
struct ImpactScratch {
    struct Mark {
        int plain = kNone;  // place in the plain form
        int group = kNone;
    };
    std::vector<int> met;  // contacts in the plain form that bounce, and were met in this step
    // Of each contact; between steps none has any.
    std::vector<Mark> marks;
    std::vector<int> marked;    // contacts that have a group
    std::vector<int> group_of;  // by row of the motions
    std::vector<int> all_rows;  // that have one
    UnionFind heaps;            // of rows, by what touches
    std::vector<int> touching;  // contacts that touch, by row; of a whole heap at its root
    // Of one group:
    std::vector<int> rows;
    std::vector<int> contacts;
    std::vector<Impact> hits;         // beside them
    std::vector<VelocityRow> solved;  // beside the rows: as the solver left them
};

/// Bounces that win no energy (world/bounce_energy.h).
struct BounceScratch {
    struct Mark {
        int before = kNone;  // place in `before`, of what bounces
        int group = kNone;
    };
    enum class Push : std::uint8_t { Unknown, None, Some };
    // Of each row of the motions and of each contact; between steps none has any.
    std::vector<Mark> marks;
    std::vector<Push> pushes;
    std::vector<int> marked;          // rows, those that bounce first
    std::vector<VelocityRow> before;  // bounces, beside them
    UnionFind heaps;                  // of rows, by what pushes
    std::vector<int> bodies;          // of a heap, at its root
    std::vector<int> group;           // rows of one
};

/// Of the blocks that bounce, those of a bucket.
struct BouncingRun {
    int bucket;
    std::size_t first;
    std::size_t count;
};

/// What dividing heaps works on (world/domains.h).
struct DomainScratch {
    std::vector<int> items;      // in turn bodies, rows, contacts and joints: one memory for all four lists
    std::vector<int> first_row;  // of motions, by domain from 1 on, as of the last division
};

/// What a step works on. Kept from step to step for its memory only.
struct StepScratch {
    // Contacts that change their list are few in most steps, and may be many in one.
    StepScratch() {
        for (std::vector<int>* list : {&met, &parted, &gone}) list->reserve(48);
    }

    Motions motions;  // row i + 1 is awake row i
    std::vector<Drive> drives;
    ChunkedList<int> noted_rows;  // that move along no axis or one, or are paddles
    std::vector<ContactConstraint>
        contacts;  // in plain form: solved as scalars, or wanted for restitution or events
    std::vector<int> scalar_contacts;       // those of them
    PlainGroups plain_groups;               // of the scalar ones
    std::vector<AwaitedContact> awaited;    // those that are reached in the course of the step
    BentScratch bent;                       // of bodies that may be turned aside in it
    std::vector<SweepingContact> sweeping;  // those that are collided anew in each substep
    std::vector<DeepOverlap> deep;          // those of them that overlap deeply
    LaneOrder lane_order;
    std::unique_ptr<DomainScratch> domains;   // none before there are many contacts
    std::unique_ptr<ContactBatches> batches;  // none before the first substep
    bool all_stand = false;                   // of what is in no batch, since the first substep
    std::vector<int> pushed;                  // bodies that were moved out of others in the last step
    ImpactScratch impacts;
    std::unique_ptr<BounceScratch> bouncing;  // none before the first bounce
    std::vector<JointConstraint> joints;      // the swept ones, in their order
    std::vector<JointPlace> joint_places;
    std::vector<int> jointed_rows;  // where joints are few: what they can move
    bool few_are_jointed = false;
    std::vector<TornJoint> torn;
    std::vector<int> unseated;         // joints that may get a lane, or break
    bool has_crowded_springs = false;  // outside of lanes
    std::vector<SpringLoad> spring_loads;
    std::vector<char> holds_of_row;  // where some springs are stiff
    std::vector<int> met;            // contacts that were near and have points now
    std::vector<int> parted;         // contacts that have none any more
    std::vector<int> gone;           // contacts whose boxes no longer overlap
    std::vector<int> resting;        // bodies of an island that goes to sleep
    Islands islands;
    std::unique_ptr<StaticsScratch> statics;  // none before the first estimate
    std::vector<Advance> advances;            // by row of the motions
    std::vector<int> fast;                    // bodies that could pass through others in this step
    // m. By no more than this they may leave their boxes: half the least inner radius, so that of two whose
    // boxes keep apart no centre has met the other then.
    float stray_m = 0;
    std::vector<int> paddles;  // kinematic bodies that sweep, or are fast, in this step
    ChunkedList<int> fast_found;
    std::unique_ptr<PressedScratch> pressed;      // none before the first step
    ChunkedList<int> untold_boxes;                // of shapes: written, but not known to the broad phase yet
    std::unique_ptr<ShiftedBoxes> shifted_boxes;  // none before many are told at once
    std::unique_ptr<WayScratch> ways;             // none before the first fast body
    std::vector<BlockFindings> block_findings;    // of blocks in colours, by their number
    std::unique_ptr<StandingScratch> standing;    // none before the first step
    ChunkedList<LaneNote> notes;
    std::vector<const LaneNote*> notes_in_order;  // of the colours
    bool some_bounce_in_lanes = false;
    std::vector<BouncingBlock> bouncing_blocks;  // in the order of the passes
    std::vector<BouncingRun> bouncing_runs;
    std::vector<NearFindings> near_findings;
    std::vector<int> near_found;  // where they are not empty
    ChunkedList<NearAhead> ahead_found;
    std::vector<NearAhead> near_ahead;  // in the order of their lanes
    ChunkedList<ItemPair> found_pairs;
    std::vector<ItemPair> pairs;
    std::vector<NewContact> new_contacts;
    ChunkedList<PairsBeside> beside;  // shapes that keep apart unless one goes another way than is expected
};

/// What is solved directly (world/direct_groups.h).
struct DirectGroups {
    /// A version that no joints have: what was found is of others.
    static constexpr std::uint64_t kUnknown = ~std::uint64_t{0};

    std::vector<DirectStructure> structures;  // of joints alone
    std::uint64_t version = 0;                // of the joints for which they were found
    std::vector<int> structure_of;            // by body
    int count = 0;                            // groups of this step, the first of the following
    std::vector<DirectStructure> groups;
    // What solves each: as a row of pins, where it is one and nothing touches it, or as any structure.
    std::vector<PinChain> chains;
    std::vector<DirectComponent> components;
    std::vector<std::uint8_t> is_chain;
    std::vector<std::vector<int>> contacts;  // places in the plain form
    std::vector<int> of_body;                // group, by body
    StructureSearch search;
    // Found with the others, and waiting for their loads to be estimated (world/pin_loads.h).
    std::vector<DirectStructure> without_loads;
    PinStatics statics;          // of one of them
    std::vector<int> number_of;  // there, by body
    // While groups are chosen and assembled:
    std::vector<int> reached;   // bodies from one seed
    std::vector<int> found;     // structures from one seed
    std::vector<int> joints;    // of no structure, which groups took up
    std::vector<int> too_many;  // bodies that hang together with more than a group may take up
    std::vector<int> places;
    std::vector<float> inertia;    // by row of the motions
    std::vector<int> body_of_row;  // working list of DirectComponent::assemble
};

/// What is known of the last steps.
struct LastSteps {
    float h_s = 0;  // of a substep of the last one
    float longest_h_s =
        0;              // of a second or more, so that short steps among them make nothing else of springs
    float since_s = 0;  // that one
};

/// What a snapshot is read into before it takes the place of the world's own (state/snapshot.cpp); kept for
/// its memory.
struct RestoreSpace {
    explicit RestoreSpace(std::uint16_t tag) : stores(tag) {}

    WorldDef def;
    Stores stores;
    Events events;
    std::uint64_t step_count = 0;
    LastSteps last;
    std::vector<std::uint8_t> marks;  // by body, while checking
};

struct WorldState {
    WorldState(const WorldDef& definition, std::uint16_t tag)
        : def(definition), stores(tag), tasks(definition.threads, definition.tasks) {
        def.tasks = nullptr;  // the pool has a copy; the user's may be gone tomorrow
    }

    WorldDef def;
    Stores stores;
    Events events;
    StepScratch scratch;
    DirectGroups direct;
    std::uint64_t step_count = 0;
    bool stepping = false;  // the host may be asked within a step
    Profile profile;        // of the last step
    bool profiling = false;
    LastSteps last;
    TaskPool tasks;  // with one thread, the default, it is empty and runs loops where they stand
    std::unique_ptr<RestoreSpace> restore_space;  // made by the first restore
};

}  // namespace cairn::physics
