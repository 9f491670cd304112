// Upkeep of lanes.
#include "resolve/contact_lanes.h"

#include <algorithm>

#include "base/ample.h"
#include "base/assert.h"
#include "base/prefetch.h"

namespace cairn::physics {
namespace {

void copy_pair(PairBlock& to, int to_lane, const PairBlock& from, int from_lane) {
    const auto copy = [&](auto& t, const auto& f) { t[to_lane] = f[from_lane]; };
    copy(to.contact, from.contact);
    copy(to.body_a, from.body_a);
    copy(to.body_b, from.body_b);
    copy(to.shape_a, from.shape_a);
    copy(to.shape_b, from.shape_b);
    copy(to.boxes.half_ax, from.boxes.half_ax);
    copy(to.boxes.half_ay, from.boxes.half_ay);
    copy(to.boxes.half_bx, from.boxes.half_bx);
    copy(to.boxes.half_by, from.boxes.half_by);
    copy(to.boxes.offset_ax, from.boxes.offset_ax);
    copy(to.boxes.offset_ay, from.boxes.offset_ay);
    copy(to.boxes.offset_bx, from.boxes.offset_bx);
    copy(to.boxes.offset_by, from.boxes.offset_by);
    for (int i = 0; i < 2; ++i) copy(to.features[i], from.features[i]);
    const auto copy_bit = [&](LaneBits& t, LaneBits f) { copy_lane_bit(t, to_lane, f, from_lane); };
    copy_bit(to.reports, from.reports);
    copy_bit(to.impacts, from.impacts);
    copy_bit(to.faint, from.faint);
}

void write_pair(PairBlock& to, int lane, const PairLane& from) {
    to.contact[lane] = from.contact;
    to.body_a[lane] = from.body_a;
    to.body_b[lane] = from.body_b;
    to.shape_a[lane] = from.shape_a;
    to.shape_b[lane] = from.shape_b;
    to.boxes.half_ax[lane] = from.half_a.x;
    to.boxes.half_ay[lane] = from.half_a.y;
    to.boxes.half_bx[lane] = from.half_b.x;
    to.boxes.half_by[lane] = from.half_b.y;
    to.boxes.offset_ax[lane] = from.offset_a.x;
    to.boxes.offset_ay[lane] = from.offset_a.y;
    to.boxes.offset_bx[lane] = from.offset_b.x;
    to.boxes.offset_by[lane] = from.offset_b.y;
    for (auto& features : to.features) features[lane] = kNoFeature;
    set_lane_bit(to.reports, lane, from.reports);
    set_lane_bit(to.impacts, lane, from.impacts);
    set_lane_bit(to.faint, lane, from.faint);
}

void copy_lane(ImpactLanes& to, int to_lane, const ImpactLanes& from, int from_lane) {
    to.restitution[to_lane] = from.restitution[from_lane];
    for (int i = 0; i < 2; ++i) to.closing_velocity[i][to_lane] = from.closing_velocity[i][from_lane];
}

void clear_pairs(PairBlock& pairs) {
    for (int lane = 0; lane < kLanes; ++lane) write_pair(pairs, lane, PairLane{});
}

// Room that the pool begins with: the contacts of small worlds, which fill their blocks badly, allocate once.
constexpr std::size_t kFirstBlocks = 32;

}  // namespace

void ContactLanes::make_room(std::size_t contacts) {
    // The last block of each bucket may stay half empty, and large heaps have buckets in several domains.
    constexpr std::size_t kHalfEmpty = 8;
    constexpr std::size_t kShareOfDomains = 32;
    const std::size_t more = contacts / kLanes + kHalfEmpty + contacts / (kLanes * kShareOfDomains);
    if (contacts < kLanes * kHalfEmpty || more <= free_.size()) return;
    const std::size_t blocks = pairs_.size() + more - free_.size();
    reserve_amply(pairs_, blocks);
    reserve_amply(blocks_, blocks);
    reserve_amply(links_, blocks);
}

int ContactLanes::add(int bucket, const PairLane& pair) {
    CAIRN_ASSERT(is_colored(bucket), "pairs without points are in no colour");
    const int lane = open_lane(bucket);
    write_pair(pairs_[lane / kLanes], lane % kLanes, pair);
    return lane;
}

int ContactLanes::open_lane(int bucket) {
    ++version_;
    if (bucket >= bucket_end()) {
        const int domains = domain_of(bucket) + 1;
        chains_.resize(static_cast<std::size_t>(kFirstColored + domains * kBucketsOfDomain));
    }
    int block = chains_[bucket].last;
    if (block == kNone || links_[block].used == kLanes) block = open_block(bucket);
    return block * kLanes + links_[block].used++;
}

int ContactLanes::remove(int bucket, int lane) {
    if (!is_colored(bucket)) return remove_near(geometry_of(bucket), lane);
    ++version_;
    const int last_block = chains_[bucket].last;
    PairBlock& from = pairs_[last_block];
    PairBlock& to = pairs_[lane / kLanes];
    const int last = --links_[last_block].used;
    copy_pair(to, lane % kLanes, from, last);
    copy_lane(blocks_[lane / kLanes], lane % kLanes, blocks_[last_block], last);
    move_turn(lane / kLanes, lane % kLanes, last_block, last);
    clear_lane(blocks_[last_block], last);
    if (!impacts_.empty()) {
        copy_lane(impacts_[lane / kLanes], lane % kLanes, impacts_[last_block], last);
        impacts_[last_block].restitution[last] = 0;
    }
    write_pair(from, last, PairLane{});
    const int moved = last_block * kLanes + last == lane ? kNone : to.contact[lane % kLanes];
    if (last == 0) close_block(bucket);
    return moved;
}

ContactLanes::Moved ContactLanes::move(int bucket, int lane, int to_bucket) {
    const int to = open_lane(to_bucket);
    const int block = lane / kLanes;
    const int to_block = to / kLanes;
    copy_pair(pairs_[to_block], to % kLanes, pairs_[block], lane % kLanes);
    copy_lane(blocks_[to_block], to % kLanes, blocks_[block], lane % kLanes);
    if (!impacts_.empty()) copy_lane(impacts_[to_block], to % kLanes, impacts_[block], lane % kLanes);
    return {to, remove(bucket, lane)};
}

void ContactLanes::ask_for(int bucket, int lane) const {
    if (!is_colored(bucket)) return prefetch(&near_[index(geometry_of(bucket))][lane], sizeof(NearPair));
    for (const int block : {lane / kLanes, chains_[bucket].last}) {
        prefetch(&pairs_[block], sizeof(PairBlock));
        prefetch(&blocks_[block], sizeof(ContactBlock));
    }
}

int ContactLanes::open_near(PairGeometry geometry) {
    std::vector<NearPair>& pairs = near_[index(geometry)];
    const int lane = near_count_[index(geometry)]++;
    if (lane == static_cast<int>(pairs.size())) cover_amply(pairs, pairs.size() + kLanes);
    constexpr std::size_t kPairsAhead = 4;
    const std::size_t ahead = static_cast<std::size_t>(lane) + kPairsAhead;
    if (ahead < pairs.size()) prefetch(&pairs[ahead], sizeof(NearPair));
    return lane;
}

int ContactLanes::remove_near(PairGeometry geometry, int lane) {
    std::vector<NearPair>& pairs = near_[index(geometry)];
    const int last = --near_count_[index(geometry)];
    pairs[lane] = pairs[last];
    pairs[last] = {};
    return last == lane ? kNone : pairs[lane].contact;
}

void ContactLanes::shrink_near(PairGeometry geometry, int before) {
    constexpr int kMany = 512;
    const int now = near_count_[index(geometry)];
    if (near_shrank_[index(geometry)] || before < kMany || now > before / 4) return;
    near_shrank_[index(geometry)] = true;
    std::vector<NearPair>& pairs = near_[index(geometry)];
    const int blocks = (now + kLanes - 1) / kLanes;
    pairs.resize(static_cast<std::size_t>(blocks * kLanes));
    pairs.shrink_to_fit();
}

int ContactLanes::open_block(int bucket) {
    int block = static_cast<int>(pairs_.size());
    if (free_.empty()) {
        if (pairs_.empty()) {
            pairs_.reserve(kFirstBlocks);
            blocks_.reserve(kFirstBlocks);
            links_.reserve(kFirstBlocks);
        }
        push_amply(pairs_, {});
        push_amply(blocks_, {});
        push_amply(links_, {});
        for (int lane = 0; lane < kLanes; ++lane) clear_lane(blocks_.back(), lane);
        if (!impacts_.empty()) make_room_for_impacts();
        free_.reserve(pairs_.capacity());
        order_.reserve(pairs_.capacity());
        in_memory_.reserve(pairs_.capacity());
    } else {
        block = free_.back();
        free_.pop_back();
    }
    clear_pairs(pairs_[block]);
    blocks_[block].turning = nullptr;
    Chain& chain = chains_[bucket];
    links_[block] = {bucket, 0, chain.last, kNone};
    (chain.last == kNone ? chain.first : links_[chain.last].next) = block;
    chain.last = block;
    is_arranged_ = false;
    return block;
}

void ContactLanes::close_block(int bucket) {
    Chain& chain = chains_[bucket];
    free_.push_back(chain.last);
    chain.last = links_[chain.last].previous;
    (chain.last == kNone ? chain.first : links_[chain.last].next) = kNone;
    is_arranged_ = false;
}

void ContactLanes::arrange() {
    if (is_arranged_) return;
    is_arranged_ = true;
    order_.clear();
    used_.clear();
    used_.reserve(chains_.size());
    ranges_.assign(chains_.size(), {});
    const int domains = (bucket_end() - kFirstColored) / kBucketsOfDomain;
    for (int domain = 1; domain < domains; ++domain) arrange_domain(domain);
    if (domains > 0) arrange_domain(kInterface);
    in_memory_.clear();
    for (int block = 0; block < pool_size(); ++block) {
        if (links_[block].used > 0) in_memory_.push_back(block);
    }
}

void ContactLanes::arrange_domain(int domain) {
    const int first = colored_bucket(0, BlockKind{}, PairGeometry{}, domain);
    for (int bucket = first; bucket < first + kBucketsOfDomain; ++bucket) {
        if (chains_[bucket].first == kNone) continue;
        used_.push_back(bucket);
        Range& range = ranges_[bucket];
        range.first = static_cast<std::uint32_t>(order_.size());
        for (int block = chains_[bucket].first; block != kNone; block = links_[block].next)
            order_.push_back(block);
        range.count = static_cast<std::uint32_t>(order_.size()) - range.first;
    }
}

// False where they are in order already.
bool ContactLanes::find_order(int bucket, std::span<const Place> places, LaneOrder& order) const {
    const auto row = [&](int body) { return places[static_cast<std::size_t>(body)].row; };
    order.clear();
    for (int block = chains_[bucket].first; block != kNone; block = links_[block].next) {
        const PairBlock& pairs = pairs_[block];
        order.add_block(block);
        for (int lane = 0; lane < links_[block].used; ++lane) {
            const int row_b = row(pairs.body_b[lane]);
            const int row_a = kind_of(bucket) == BlockKind::OneBody ? row_b : row(pairs.body_a[lane]);
            order.add_lane(row_a + row_b);
        }
    }
    return order.sort();
}

void ContactLanes::take_order(LaneOrder& order) {
    PairBlock kept_pair;
    ContactBlock kept_block;
    ImpactLanes kept_impact;
    order.apply(
        [&](LaneAt from) {
            copy_pair(kept_pair, 0, pairs_[from.block], from.lane);
            copy_lane(kept_block, 0, blocks_[from.block], from.lane);
            if (!impacts_.empty()) copy_lane(kept_impact, 0, impacts_[from.block], from.lane);
        },
        [&](LaneAt to, LaneAt from) {
            copy_pair(pairs_[to.block], to.lane, pairs_[from.block], from.lane);
            copy_lane(blocks_[to.block], to.lane, blocks_[from.block], from.lane);
            if (!impacts_.empty()) copy_lane(impacts_[to.block], to.lane, impacts_[from.block], from.lane);
        },
        [&](LaneAt to) {
            copy_pair(pairs_[to.block], to.lane, kept_pair, 0);
            copy_lane(blocks_[to.block], to.lane, kept_block, 0);
            if (!impacts_.empty()) copy_lane(impacts_[to.block], to.lane, kept_impact, 0);
        });
}

ContactMemory ContactLanes::memory(int lane) const {
    const PairBlock& pairs = pairs_[lane / kLanes];
    const ContactBlock& block = blocks_[lane / kLanes];
    ContactMemory memory;
    for (int i = 0; i < 2; ++i) {
        memory.features[i] = pairs.features[i][lane % kLanes];
        memory.impulse[i] = block.points[i].impulse[lane % kLanes];
    }
    memory.friction_impulse = block.friction_impulse[lane % kLanes];
    return memory;
}

void ContactLanes::set_memory(int lane, const ContactMemory& memory) {
    PairBlock& pairs = pairs_[lane / kLanes];
    ContactBlock& block = blocks_[lane / kLanes];
    for (int i = 0; i < 2; ++i) {
        pairs.features[i][lane % kLanes] = memory.features[i];
        block.points[i].impulse[lane % kLanes] = memory.impulse[i];
    }
    block.friction_impulse[lane % kLanes] = memory.friction_impulse;
}

void ContactLanes::set_material(int lane, float friction, float restitution) {
    blocks_[lane / kLanes].friction[lane % kLanes] = friction;
    if (restitution > 0 || !impacts_.empty()) make_room_for_impacts();
    if (!impacts_.empty()) impacts_[lane / kLanes].restitution[lane % kLanes] = restitution;
}

void ContactLanes::make_room_for_impacts() {
    if (impacts_.size() == pairs_.size()) return;
    impacts_.reserve(pairs_.capacity());
    impacts_.resize(pairs_.size());
}

void ContactLanes::make_room_for_turns() {
    if (turns_.size() == pairs_.size()) return;
    turns_.reserve(pairs_.capacity());
    turns_.resize(pairs_.size());
}

void ContactLanes::turn(int block, int lane, float bow_a_m, float bow_b_m) {
    TurnLanes& turns = turns_[block];
    if (blocks_[block].turning == nullptr) turns.used = 0;
    blocks_[block].turning = &turns;
    turns.bow_a[lane] = bow_a_m;
    turns.bow_b[lane] = bow_b_m;
    turns.bend[0][lane] = turns.bend[1][lane] = 0;
    set_lane_bit(turns.used, lane, true);
}

void ContactLanes::move_turn(int block, int lane, int from_block, int from_lane) {
    TurnLanes* const from = blocks_[from_block].turning;
    TurnLanes* const to = blocks_[block].turning;
    if (to != nullptr) set_lane_bit(to->used, lane, false);
    if (from == nullptr || (from->used >> from_lane & 1) == 0) return;
    turn(block, lane, from->bow_a[from_lane], from->bow_b[from_lane]);
    set_lane_bit(from->used, from_lane, false);
}

void ContactLanes::blank(int lane) {
    ContactBlock& block = blocks_[lane / kLanes];
    const int at = lane % kLanes;
    const std::int32_t a = block.a[at];
    const std::int32_t b = block.b[at];
    const float friction = block.friction[at];
    clear_lane(block, at);
    block.a[at] = a;
    block.b[at] = b;
    block.friction[at] = friction;
}

}  // namespace cairn::physics
