// The look at near pairs.
#include "world/near_pairs.h"

#include <bit>

#include "base/ample.h"
#include "base/prefetch.h"
#include "world/narrow_phase.h"

namespace cairn::physics {
namespace {

// What a thread takes at once: enough that few packs are not full.
constexpr int kBlocksPerChunk = 32;

// Blocks ahead of which memory is asked for.
constexpr int kLooksAhead = 4;

AxisGap seen_gap(const ManifoldLanes& manifold, int lane) {
    return {{manifold.normal_x[lane], manifold.normal_y[lane]}, manifold.gap[lane]};
}

// By what was seen along the normal.
bool may_meet_ahead(const std::vector<Advance>& advances, const BlockPlaces& places,
                    const ManifoldLanes& manifold, int lane, float dt_s) {
    return (places.hasty >> lane & 1) != 0 &&
           could_meet(advances[places.row_a[lane]], advances[places.row_b[lane]], seen_gap(manifold, lane),
                      dt_s);
}

// Looks at some blocks of near pairs, one after the other.
class NearLook {
  public:
    NearLook(Stores& stores, PairGeometry geometry, int first_block, Vec2 gravity_m_s2, float dt_s,
             StepScratch& scratch, std::vector<NearAhead>& ahead)
        : stores_(stores),
          pairs_(stores.contacts.lanes.near_pairs(geometry)),
          geometry_(geometry),
          first_block_(first_block),
          gravity_m_s2_(gravity_m_s2),
          dt_s_(dt_s),
          scratch_(scratch),
          ahead_(ahead) {}

    /// Asks for what looking at a block will read first.
    void ask_for(int block) const { prefetch(&pairs_[block * kLanes], kLanes * sizeof(NearPair)); }

    void look_at(int block, unsigned lanes) {
        const NearPair* pairs = &pairs_[block * kLanes];
        const NearLanes near =
            look_near(stores_.bodies.places.data(), pairs, scratch_.advances.data(), dt_s_, lanes);
        NearFindings& found = scratch_.near_findings[block - first_block_];
        found = {};
        found.remembers = static_cast<std::uint8_t>(near.remembers);
        found.gone = static_cast<std::uint8_t>(gone_lanes(pairs, near.boxes_moved));
        for (unsigned close = near.close & ~found.gone; close != 0; close &= close - 1) {
            const int lane = std::countr_zero(close);
            pack(pairs[lane], block * kLanes + lane);
            if (packed_ == kLanes) finish();
        }
    }

    /// Looks at what is still packed.
    void finish() {
        if (packed_ > 0) look_closer((1u << packed_) - 1);
        packed_ = 0;
    }

  private:
    [[nodiscard]] unsigned gone_lanes(const NearPair* pairs, unsigned lanes) const {
        if (lanes == 0) return 0;
        alignas(32) Lanes<std::int32_t> shape_a;
        alignas(32) Lanes<std::int32_t> shape_b;
        for (int lane = 0; lane < kLanes; ++lane) {
            shape_a[lane] = pairs[lane].shape_a;
            shape_b[lane] = pairs[lane].shape_b;
        }
        return physics::gone_lanes(stores_, shape_a, shape_b, lanes);
    }

    void pack(const NearPair& pair, int from) {
        const int to = packed_++;
        from_[to] = from;
        pack_.contact[to] = pair.contact;
        pack_.body_a[to] = pair.body_a;
        pack_.body_b[to] = pair.body_b;
        pack_.shape_a[to] = pair.shape_a;
        pack_.shape_b[to] = pair.shape_b;
        pack_.boxes.offset_ax[to] = pair.offset_a.x;
        pack_.boxes.offset_ay[to] = pair.offset_a.y;
        pack_.boxes.offset_bx[to] = pair.offset_b.x;
        pack_.boxes.offset_by[to] = pair.offset_b.y;
        stores_.shapes.ask_for(pair.shape_a);
        stores_.shapes.ask_for(pair.shape_b);
    }

    void look_at_sizes(unsigned lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            const Vec2 half_a = stores_.shapes[pack_.shape_a[lane]].convex().half_size;
            const Vec2 half_b = stores_.shapes[pack_.shape_b[lane]].convex().half_size;
            pack_.boxes.half_ax[lane] = half_a.x;
            pack_.boxes.half_ay[lane] = half_a.y;
            pack_.boxes.half_bx[lane] = half_b.x;
            pack_.boxes.half_by[lane] = half_b.y;
        }
    }

    void look_closer(unsigned lanes) {
        if (geometry_ == PairGeometry::Boxes) look_at_sizes(lanes);
        load_places(stores_.bodies.places.data(), pack_.body_a, pack_.body_b, lanes, places_);
        collide_block(stores_, pack_, geometry_, lanes, places_.poses, manifold_);
        unsigned ahead = 0;
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            NearFindings& found = scratch_.near_findings[from_[lane] / kLanes - first_block_];
            const auto bit = static_cast<std::uint8_t>(1 << from_[lane] % kLanes);
            if (manifold_.points[0].id[lane] != kNoFeature) {
                const bool is_new = (found.remembers & bit) == 0;
                if (!is_new ||
                    !passes_corner(stores_, manifold_, lane, pack_.contact[lane], gravity_m_s2_, dt_s_))
                    found.meets |= bit;
                continue;
            }
            NearPair& pair = pairs_[from_[lane]];
            pair.sight = make_sight(places_.poses, lane, manifold_.gap[lane]);
            pair.flags |= near_flag::kSeen;
            if (may_reach(scratch_.advances, places_, manifold_, lane, dt_s_)) found.rouses |= bit;
            if (!may_meet_ahead(scratch_.advances, places_, manifold_, lane, dt_s_)) continue;
            ahead |= 1u << lane;
            stores_.contacts.slots.ask_for(pack_.contact[lane]);
            stores_.bodies.slots.ask_for(pack_.body_a[lane]);
            stores_.bodies.slots.ask_for(pack_.body_b[lane]);
        }
        for (; ahead != 0; ahead &= ahead - 1) {
            const int lane = std::countr_zero(ahead);
            ContactInput input;
            const ContactRecord& c = stores_.contacts.slots[pack_.contact[lane]];
            if (!predict_contact(stores_, c, seen_gap(manifold_, lane), gravity_m_s2_, dt_s_, input))
                continue;
            scratch_.near_findings[from_[lane] / kLanes - first_block_].will_meet |=
                static_cast<std::uint8_t>(1 << from_[lane] % kLanes);
            ahead_.push_back({from_[lane], input});
        }
    }

    const Stores& stores_;
    std::vector<NearPair>& pairs_;
    const PairGeometry geometry_;
    const int first_block_;
    const Vec2 gravity_m_s2_;
    const float dt_s_;
    StepScratch& scratch_;
    std::vector<NearAhead>& ahead_;
    PairBlock pack_{};
    Lanes<int> from_{};  // near lanes that those of the pack are
    int packed_ = 0;
    BlockPlaces places_;
    ManifoldLanes manifold_;
};

}  // namespace

bool meets_ahead(const Stores& stores, const std::vector<Advance>& advances, const BlockPlaces& places,
                 const ManifoldLanes& manifold, int lane, int contact, Vec2 gravity_m_s2, float dt_s,
                 ContactInput& input) {
    return may_meet_ahead(advances, places, manifold, lane, dt_s) &&
           predict_contact(stores, stores.contacts.slots[contact], seen_gap(manifold, lane), gravity_m_s2,
                           dt_s, input);
}

bool passes_corner(const Stores& stores, const ManifoldLanes& manifold, int lane, int contact,
                   Vec2 gravity_m_s2, float dt_s) {
    return goes_over_corner(stores, stores.contacts.slots[contact], gravity_m_s2,
                            {manifold.normal_x[lane], manifold.normal_y[lane]}, dt_s);
}

bool may_reach(const std::vector<Advance>& advances, const BlockPlaces& places, const ManifoldLanes& manifold,
               int lane, float dt_s) {
    const int row_a = places.row_a[lane];
    const int row_b = places.row_b[lane];
    if ((places.rouses >> lane & 1) == 0 || (row_a != kWorldRow && row_b != kWorldRow)) return false;
    const Advance& a = advances[row_a];
    const Advance& b = advances[row_b];
    const Vec2 axis{manifold.normal_x[lane], manifold.normal_y[lane]};
    const float closing = a.turning_m_s + b.turning_m_s - dot(b.velocity_m_s - a.velocity_m_s, axis);
    return manifold.gap[lane] > 0 && manifold.gap[lane] <= dt_s * closing;
}

void find_near(Stores& stores, PairGeometry geometry, int first, int count, Vec2 gravity_m_s2, float dt_s,
               StepScratch& scratch, TaskPool& tasks) {
    const int first_block = first / kLanes;
    const int blocks = (count + kLanes - 1) / kLanes - first_block;
    resize_amply(scratch.near_findings, static_cast<std::size_t>(blocks));
    scratch.ahead_found.start(blocks, kBlocksPerChunk, tasks);
    tasks.parallel_for(blocks, kBlocksPerChunk, [&](const Chunk& chunk) {
        ChunkedList<NearAhead>::Appender ahead(scratch.ahead_found, chunk);
        NearLook look(stores, geometry, first_block, gravity_m_s2, dt_s, scratch, ahead.items());
        const int last_block = first_block + chunk.end;
        for (int block = first_block + chunk.begin; block < last_block; ++block) {
            if (block + kLooksAhead < last_block) look.ask_for(block + kLooksAhead);
            look.look_at(block, near_lanes(first, count, block));
        }
        look.finish();
    });
    scratch.ahead_found.copy_to(scratch.near_ahead);
}

}  // namespace cairn::physics
