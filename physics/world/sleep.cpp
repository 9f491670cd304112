// Sleep and wake of groups of bodies.
#include "world/sleep.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "base/prefetch.h"
#include "world/contact_lists.h"
#include "world/joint_lists.h"
#include "world/joints.h"

namespace cairn::physics {
namespace {

// Lanes move the rows of awake bodies. What sleeps on a platform that is awake is near it, until it is woken.
void relist_beside(Stores& stores, int contact) {
    const ContactRecord& c = stores.contacts.slots[contact];
    const auto sleeps = [&](int body) {
        const BodyRecord& record = stores.bodies.slots[body];
        return record.type == BodyType::Dynamic && record.set == RowSet::Asleep;
    };
    const bool moves_a_sleeper = sleeps(c.body_a) || sleeps(c.body_b);
    if (moves_a_sleeper && is_colored(c.bucket)) unlist_contact(stores, contact);
    list_contact(stores, contact);
}

void update_links(Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    for_each_edge(stores.contacts.slots, record.first_contact, [&](int contact, int) {
        const ContactRecord& c = stores.contacts.slots[contact];
        if (stores.bodies.is_awake(c.body_a) || stores.bodies.is_awake(c.body_b)) {
            relist_beside(stores, contact);
        } else {
            unlist_contact(stores, contact);
        }
    });
    // Which structures there are depends on what moves, even where the same joints stay active.
    if (record.first_joint != kNone) ++stores.joints.version;
    for_each_edge(stores.joints.slots, record.first_joint, [&](int joint, int) {
        if (acts(stores.bodies, stores.joints.slots[joint])) {
            list_joint(stores, joint);
        } else {
            unlist_joint(stores, joint);
        }
    });
}

// To the layer of what the body is now.
void move_boxes(Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    for (int shape = record.first_shape; shape != kNone; shape = stores.shapes[shape].next_of_body)
        stores.broad.set_layer(shape, layer_of(record.set));
}

// Kinematic bodies carry islands but do not join them: two piles on one lift are two islands.
bool joins_islands(const Stores& stores, int body) {
    return stores.bodies.slots[body].type == BodyType::Dynamic && stores.bodies.is_awake(body);
}

bool is_moving(const Stores& stores, int body) {
    const BodyRows& rows = stores.bodies.rows_of(body);
    const int row = stores.bodies.slots[body].row;
    return rows.velocity[row] != Vec2{} || rows.spin[row] != 0;
}

// By a joint. What touches a body that moves wakes in the step.
bool is_held_by_moving(const Stores& stores, int body) {
    bool held = false;
    for_each_edge(stores.joints.slots, stores.bodies.slots[body].first_joint, [&](int joint, int side) {
        const JointRecord& j = stores.joints.slots[joint];
        const int other = side == 0 ? j.body_b : j.body_a;
        const bool is_carrier = stores.bodies.slots[other].type == BodyType::Kinematic;
        held |= takes_part(j) && is_carrier && is_moving(stores, other);
    });
    return held;
}

// Joins bodies into islands. `matters(row_a, row_b)` tells of awake rows whether it is of interest that the
// two are joined; `motions` are those of the step, in which blocks of contacts and of joints know the rows of
// their bodies.
template <class Matters>
class Linking {
  public:
    Linking(Stores& stores, const Motions& motions, Islands& islands, const Matters& matters)
        : stores_(stores), islands_(islands), matters_(matters) {
        const int awake = stores.bodies.rows(RowSet::Awake).size();
        // What woke since then has rows behind them, and blocks that do not know these yet.
        blocks_know_rows_ = motions.size() == awake + 1;
        islands.reset(awake);
    }

    void link_all() {
        // Who is joined to whom does not depend on the order in which it is found.
        stores_.contacts.lanes.arrange();
        const std::span<const int> blocks = stores_.contacts.lanes.blocks_in_memory();
        visit_asking_ahead(
            blocks, kBlocksAhead, [&](int block) { ask_for(block); }, [&](int block) { link_block(block); });
        for (const int contact : stores_.contacts.loose) {
            const ContactRecord& c = stores_.contacts.slots[contact];
            link_any(c.body_a, c.body_b);
        }
        stores_.joints.lanes.arrange();
        stores_.joints.lanes.for_each_block([&](const AnchorBlock& anchors, const JointRows& rows,
                                                JointBlockKind kind) { link_block(anchors, rows, kind); });
        for (const int joint : stores_.joints.swept) {
            const JointRecord& j = stores_.joints.slots[joint];
            link_any(j.body_a, j.body_b);
        }
    }

  private:
    void ask_for(int block) const {
        const ContactBlock& rows = stores_.contacts.lanes.block(block);
        prefetch(&rows.a, sizeof rows.a + sizeof rows.b);
    }

    // What stands on the world joins nothing.
    void link_block(int block) {
        const ContactLanes& lanes = stores_.contacts.lanes;
        const BlockKind kind = kind_of(lanes.link(block).bucket);
        if (kind == BlockKind::OneBody) return;
        const PairBlock& pairs = lanes.pairs(block);
        const int used = lanes.link(block).used;
        for (int lane = 0; lane < used; ++lane) {
            if (kind == BlockKind::Carried) {
                link_any(pairs.body_a[lane], pairs.body_b[lane]);
            } else if (blocks_know_rows_) {
                link_rows(lanes.block(block).a[lane], lanes.block(block).b[lane]);
            } else {
                link_rows(row_of(pairs.body_a[lane]), row_of(pairs.body_b[lane]));
            }
        }
    }

    void link_block(const AnchorBlock& anchors, const JointRows& rows, JointBlockKind kind) {
        if (kind == JointBlockKind::TwoBodies && blocks_know_rows_) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) link_rows(rows.a[lane], rows.b[lane]);
            return;
        }
        for (std::size_t lane = 0; lane < kLanes && anchors.joint[lane] != kNone; ++lane)
            link_any(anchors.body_a[lane], anchors.body_b[lane]);
    }

    [[nodiscard]] int row_of(int body) const { return stores_.bodies.places[body].row; }

    void link_rows(int row_a, int row_b) {
        if (row_a != kWorldRow && row_b != kWorldRow && matters_(row_a - 1, row_b - 1))
            islands_.link(row_a - 1, row_b - 1);
    }

    void link_any(int a, int b) {
        const bool a_joins = joins_islands(stores_, a);
        const bool b_joins = joins_islands(stores_, b);
        if (a_joins && b_joins) return link_rows(row_of(a), row_of(b));
        // What a moving platform carries stays awake, however slowly it goes.
        BodyRows& awake = stores_.bodies.rows(RowSet::Awake);
        if (a_joins && is_moving(stores_, b)) awake.rest_time[stores_.bodies.slots[a].row] = 0;
        if (b_joins && is_moving(stores_, a)) awake.rest_time[stores_.bodies.slots[b].row] = 0;
    }

    Stores& stores_;
    Islands& islands_;
    const Matters& matters_;
    bool blocks_know_rows_ = false;
};

}  // namespace

void wake_body(Stores& stores, int body) {
    BodyStore& bodies = stores.bodies;
    if (bodies.slots[body].set == RowSet::Static) return;
    if (bodies.is_awake(body)) {
        bodies.rows(RowSet::Awake).rest_time[bodies.slots[body].row] = 0;
        return;
    }
    int sleeper = body;
    do {
        const int next = bodies.slots[sleeper].next_sleeper;
        bodies.slots[sleeper].next_sleeper = kNone;
        bodies.move_row(sleeper, RowSet::Awake);
        move_boxes(stores, sleeper);
        bodies.rows(RowSet::Awake).rest_time.back() = 0;
        note_moved_boxes(stores, sleeper);  // what lay beside it may have gone while it slept
        update_links(stores, sleeper);
        sleeper = next;
    } while (sleeper != body);
}

void wake_neighbours(Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    for_each_edge(stores.contacts.slots, record.first_contact, [&](int contact, int side) {
        const ContactRecord& c = stores.contacts.slots[contact];
        if (c.has_points) wake_body(stores, side == 0 ? c.body_b : c.body_a);
    });
    wake_jointed(stores, body);
}

void wake_jointed(Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    for_each_edge(stores.joints.slots, record.first_joint, [&](int joint, int side) {
        const JointRecord& j = stores.joints.slots[joint];
        wake_body(stores, side == 0 ? j.body_b : j.body_a);
    });
}

void put_to_sleep(Stores& stores, std::span<const int> bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const int body = bodies[i];
        stores.bodies.move_row(body, RowSet::Asleep);
        move_boxes(stores, body);
        BodyRows& asleep = stores.bodies.rows(RowSet::Asleep);
        asleep.velocity.back() = {};
        asleep.spin.back() = 0;
        asleep.moved.back() = {};
        asleep.rotation_before.back() = stores.bodies.places[body].rotation;
        stores.bodies.slots[body].next_sleeper = bodies[(i + 1) % bodies.size()];
    }
    for (const int body : bodies) update_links(stores, body);
}

void sleep_islands(Stores& stores, std::uint64_t step_count, StepScratch& scratch) {
    // Looking at all contacts of a heap takes as long as some of the stages. What is tired in one of more
    // bodies than these waits for a fourth step.
    constexpr int kMany = 1024;
    constexpr std::uint64_t kInterval = 4;
    BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    if (awake.size() > kMany && step_count % kInterval != 0) return;
    const auto is_tired = [](float rest_time) { return rest_time >= tuning::kTimeToSleep_s; };
    if (std::none_of(awake.rest_time.begin(), awake.rest_time.end(), is_tired)) return;

    // An island sleeps when all of it is tired, so what joins those that are not is of no interest.
    const auto matters = [&](int row_a, int row_b) {
        return is_tired(awake.rest_time[row_a]) || is_tired(awake.rest_time[row_b]);
    };
    Linking(stores, scratch.motions, scratch.islands, matters).link_all();
    // Rows change places while islands leave, so the members are noted first: bodies, one island after
    // another, each island closed by kNone.
    scratch.resting.clear();
    scratch.islands.for_each_resting(awake.rest_time, tuning::kTimeToSleep_s, [&](std::span<const int> rows) {
        for (const int row : rows) scratch.resting.push_back(awake.body[row]);
        scratch.resting.push_back(kNone);
    });
    auto first = scratch.resting.begin();
    while (first != scratch.resting.end()) {
        const auto last = std::find(first, scratch.resting.end(), kNone);
        put_to_sleep(stores, {first, last});
        first = last + 1;
    }
}

void put_island_to_sleep(Stores& stores, StepScratch& scratch, int body) {
    if (!stores.bodies.is_awake(body)) return;
    const auto always = [](int, int) { return true; };
    Linking(stores, Motions{}, scratch.islands, always).link_all();
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const int own_row = stores.bodies.slots[body].row;
    scratch.resting.clear();
    for (int row = 0; row < awake.size(); ++row) {
        if (scratch.islands.together(row, own_row)) scratch.resting.push_back(awake.body[row]);
    }
    put_to_sleep(stores, scratch.resting);
    for (const int sleeper : scratch.resting) {
        if (is_held_by_moving(stores, sleeper)) return wake_body(stores, sleeper);
    }
}

}  // namespace cairn::physics
