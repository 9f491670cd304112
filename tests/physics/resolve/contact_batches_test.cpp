// Batches, against passes over everything, which they must equal to the bit.
#include "resolve/contact_batches.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "integrator/integrate.h"
#include "physics/support/contact_heap.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr int kSubsteps = 3;
constexpr float kStepRatio = 1.3f;
constexpr float kFrictionRatio = 0.8f;

// Mostly small islands, scattered over the rows; a few bodies are carried, so carriers join many of them.
const std::vector<BlockKind> kSmallIslands = [] {
    std::vector<BlockKind> kinds(200, BlockKind::TwoBodies);
    for (std::size_t i = 0; i < kinds.size(); i += 4) kinds[i] = BlockKind::OneBody;
    kinds.back() = BlockKind::Carried;
    return kinds;
}();

void give_movers(Motions& motions, Random& random, double held) {
    motions.kick.resize(motions.velocity.size());
    for (int row = 1; row < motions.size(); ++row) {
        motions.mover[row] = random.chance(held) ? MovedBy::Turning : MovedBy::Substeps;
        motions.kick[row].v = {0, -0.04f};
    }
}

std::vector<int> numbered(int rows) {
    std::vector<int> bodies(static_cast<std::size_t>(rows) - 1);
    std::iota(bodies.begin(), bodies.end(), 0);
    return bodies;
}

// The passes of a step; `each(work)` calls work(runs, ranges of rows).
template <class Each>
void take_step(Motions& motions, const Each& each) {
    each([&](std::span<const ContactRun> runs, std::span<const RowRange> rows) {
        for (int substep = 0; substep < kSubsteps; ++substep) {
            for (const RowRange& r : rows) integrate_velocities(motions, substep == 0, r.first, r.last);
            for (const ContactRun& run : runs) {
                if (substep == 0) warm_start(run, motions, kStepRatio, kFrictionRatio);
            }
            for (const ContactRun& run : runs)
                solve(run, motions, kHeapRules, kHeapSubstep_s, Pass::Biased, Scope::All);
            for (const RowRange& r : rows) integrate_positions(motions, kHeapSubstep_s, r.first, r.last);
            for (const ContactRun& run : runs)
                solve(run, motions, kHeapRules, kHeapSubstep_s, Pass::Relax, Scope::All);
        }
    });
}

void take_step_whole(Heap& heap) {
    const WholeHeap whole(heap);
    const RowRange all{0, heap.motions.size()};
    take_step(heap.motions, [&](const auto& work) { work(whole.runs(), std::span(&all, 1)); });
}

void take_step_in_batches(Heap& heap, ContactBatches& batches) {
    heap.lanes.arrange();
    batches.cut(heap.lanes, heap.motions, numbered(heap.motions.size()), false);
    batches.fetch_rest();
    // The last one first: nothing may depend on the order.
    take_step(heap.motions, [&](const auto& work) {
        for (int i = batches.count() - 1; i >= 0; --i) {
            batches.fetch_lanes(i);
            work(batches.runs(i), batches.rows(i));
            batches.return_lanes(i);
        }
        work(batches.rest_runs(), batches.rest_rows());
    });
    batches.return_rest();
}

std::vector<std::uint32_t> bits_of(const Heap& heap) {
    std::vector<std::uint32_t> bits;
    const auto add = [&](auto... x) { (bits.push_back(std::bit_cast<std::uint32_t>(x)), ...); };
    for (const VelocityRow& row : heap.motions.velocity) add(row.v.x, row.v.y, row.w);
    for (const PoseRow& row : heap.motions.pose) add(row.d.x, row.d.y, row.theta);
    for (const int i : heap.lanes.blocks()) {
        const ContactBlock& block = heap.lanes.block(i);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            add(block.friction_impulse[lane]);
            for (std::size_t k = 0; k < 2; ++k) {
                add(block.points[k].impulse[lane], block.points[k].separation[lane],
                    block.total_impulse[k][lane]);
            }
        }
    }
    return bits;
}

// The place of the first bits that differ, or -1.
std::ptrdiff_t first_difference(const Heap& a, const Heap& b) {
    const std::vector<std::uint32_t> bits = bits_of(a);
    const std::vector<std::uint32_t> others = bits_of(b);
    REQUIRE(bits.size() == others.size());
    const auto at = std::ranges::mismatch(bits, others).in1;
    return at == bits.end() ? -1 : at - bits.begin();
}

// Which batch each row is in, -1 for the rest.
std::vector<int> batch_of_rows(const ContactBatches& batches, int rows) {
    std::vector<int> batch(static_cast<std::size_t>(rows), -2);
    const auto take = [&](std::span<const RowRange> ranges, int to) {
        for (const RowRange& range : ranges) {
            for (int row = range.first; row < range.last; ++row) {
                REQUIRE(batch[static_cast<std::size_t>(row)] == -2);
                batch[static_cast<std::size_t>(row)] = to;
            }
        }
    };
    take(batches.rest_rows(), -1);
    for (int i = 0; i < batches.count(); ++i) take(batches.rows(i), i);
    REQUIRE(std::count(batch.begin() + 1, batch.end(), -2) == 0);
    return batch;
}

// Takes contacts out and puts them in again, with all that their lanes hold.
class Churn {
  public:
    explicit Churn(Heap& heap) : heap_(heap) {
        for (const Placed& p : heap.placed) {
            const auto contact = static_cast<std::size_t>(heap.pairs(p).contact[p.lane % kLanes]);
            if (seats_.size() <= contact) seats_.resize(contact + 1);
            seats_[contact] = {p.bucket, p.lane, {}};
        }
    }

    void toggle(int contact) {
        Seat& seat = seats_[static_cast<std::size_t>(contact)];
        ContactLanes& lanes = heap_.lanes;
        if (seat.lane != kNone) {
            copy_lane(seat.kept, 0, lanes.block(seat.lane / kLanes), seat.lane % kLanes);
            const int moved = lanes.remove(seat.bucket, seat.lane);
            if (moved != kNone) seats_[static_cast<std::size_t>(moved)].lane = seat.lane;
            seat.lane = kNone;
        } else {
            PairLane pair;
            pair.contact = contact;
            seat.lane = lanes.add(seat.bucket, pair);
            copy_lane(lanes.block(seat.lane / kLanes), seat.lane % kLanes, seat.kept, 0);
        }
    }

    [[nodiscard]] int count() const { return static_cast<int>(seats_.size()); }

  private:
    struct Seat {
        int bucket = kNone;
        int lane = kNone;
        ContactBlock kept;
    };
    Heap& heap_;
    std::vector<Seat> seats_;
};

}  // namespace

TEST_CASE("batches and the rest give the bits of passes over everything") {
    const unsigned seed = GENERATE(1u, 2u, 3u);
    const double held = GENERATE(0.0, 0.02);
    CAPTURE(seed, held);
    Heap heap = make_heap(seed, kSmallIslands, 20000, 10000);
    Random random(seed);
    give_movers(heap.motions, random, held);
    Heap whole = heap;
    ContactBatches batches;
    take_step_in_batches(heap, batches);
    REQUIRE(batches.count() > 3);
    take_step_whole(whole);
    CHECK(first_difference(heap, whole) == -1);
}

TEST_CASE("batches are kept up while contacts come and go and other things act on bodies") {
    Heap heap = make_heap(4, kSmallIslands, 20000, 10000);
    Random random(4);
    give_movers(heap.motions, random, 0.01);
    Churn churn(heap);
    ContactBatches batches;
    int cuts = 0;
    for (int round = 0; round < 60; ++round) {
        // Steps in which nothing changes, some, and much; and what holds bodies changes now and then.
        const int changes = random.chance(0.3) ? 0 : random.below(random.chance(0.1) ? 500 : 10);
        for (int i = 0; i < changes; ++i) churn.toggle(random.below(churn.count()));
        if (random.chance(0.1)) give_movers(heap.motions, random, random.chance(0.2) ? 0.9 : 0.01);
        heap.lanes.arrange();
        Heap whole = heap;
        take_step_in_batches(heap, batches);
        cuts += batches.count() > 0 ? 1 : 0;
        take_step_whole(whole);
        CAPTURE(round, changes, batches.count());
        REQUIRE(first_difference(heap, whole) == -1);
    }
    CHECK(cuts > 15);
    CHECK(cuts < 60);
}

TEST_CASE("no contact joins two batches, and what else is acted on is in the rest with its island") {
    Heap heap = make_heap(5, kSmallIslands, 20000, 10000);
    Random random(5);
    give_movers(heap.motions, random, 0.02);
    heap.lanes.arrange();
    ContactBatches batches;
    batches.cut(heap.lanes, heap.motions, numbered(heap.motions.size()), false);
    const std::vector<int> batch = batch_of_rows(batches, heap.motions.size());
    for (int row = 1; row < heap.motions.size(); ++row) {
        if (heap.motions.mover[row] == MovedBy::Turning) REQUIRE(batch[row] == -1);
    }
    for (const Placed& p : heap.placed) {
        if (p.input.a != kWorldRow) REQUIRE(batch[p.input.a] == batch[p.input.b]);
    }
}

TEST_CASE("where all hangs together there are no batches") {
    // Three contacts to a body: one island holds nearly all of them.
    Heap heap = make_heap(6, {BlockKind::TwoBodies}, 4000, 12000);
    Random random(6);
    give_movers(heap.motions, random, 0);
    heap.lanes.arrange();
    ContactBatches batches;
    batches.cut(heap.lanes, heap.motions, numbered(heap.motions.size()), false);
    CHECK(batches.count() == 0);
    CHECK(batch_of_rows(batches, heap.motions.size())[1] == -1);
}

TEST_CASE("few contacts are cut only where something rests") {
    Heap heap = make_heap(8, kSmallIslands, 2000, 1000);
    Random random(8);
    give_movers(heap.motions, random, 0);
    heap.lanes.arrange();
    ContactBatches batches;
    for (const bool some_rest : {false, true, false, true}) {
        batches.cut(heap.lanes, heap.motions, numbered(heap.motions.size()), some_rest);
        CHECK((batches.count() > 0) == some_rest);
    }
}

TEST_CASE("rows that changed their bodies are looked at again") {
    Heap heap = make_heap(7, kSmallIslands, 20000, 10000);
    Random random(7);
    give_movers(heap.motions, random, 0);
    heap.lanes.arrange();
    ContactBatches batches;
    std::vector<int> bodies = numbered(heap.motions.size());
    batches.cut(heap.lanes, heap.motions, bodies, false);
    REQUIRE(batches.count() > 3);
    // Two rows change places, in the lanes too, which are the same otherwise.
    const std::vector<int> before = batch_of_rows(batches, heap.motions.size());
    const auto joined =
        std::ranges::find_if(heap.placed, [&](const Placed& p) { return p.input.a >= heap.first_free; });
    const int first = joined->input.a;
    const int second = static_cast<int>(
        std::ranges::find_if(before, [&](int b) { return b >= 0 && b != before[first]; }) - before.begin());
    REQUIRE(second < heap.motions.size());
    std::swap(bodies[static_cast<std::size_t>(first) - 1], bodies[static_cast<std::size_t>(second) - 1]);
    std::swap(heap.motions.velocity[first], heap.motions.velocity[second]);
    std::swap(heap.motions.pose[first], heap.motions.pose[second]);
    for (const int i : heap.lanes.blocks()) {
        for (Lanes<std::int32_t>* rows : {&heap.lanes.block(i).a, &heap.lanes.block(i).b}) {
            for (std::int32_t& row : *rows) {
                if (row == first || row == second) row = first + second - row;
            }
        }
    }
    batches.cut(heap.lanes, heap.motions, bodies, false);
    const std::vector<int> batch = batch_of_rows(batches, heap.motions.size());
    for (const int i : heap.lanes.blocks()) {
        const ContactBlock& block = heap.lanes.block(i);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if (block.a[lane] != kWorldRow) REQUIRE(batch[block.a[lane]] == batch[block.b[lane]]);
        }
    }
}

}  // namespace cairn::physics
