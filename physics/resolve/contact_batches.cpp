// Islands by union and find, packed into batches in the order of their rows.
#include "resolve/contact_batches.h"

#include <algorithm>

#include "base/ample.h"

namespace cairn::physics {
namespace {

// Of a batch: with their contacts some hundred kilobytes, which the cache of a core holds, and with so many
// few blocks have lanes of two batches.
constexpr int kRowsPerBatch = 512;

// Larger islands are solved by all threads, colour by colour.
constexpr int kMostRowsOfIsland = 2 * kRowsPerBatch;

// Fewer take less than a megabyte: the cache of a core holds all of them anyway.
constexpr std::size_t kFewestBlocks = 1024;

// Looking for islands takes a twentieth of a step. Where most rows are of the rest, it is not done
// again for up to this many steps.
constexpr int kMostPatience = 64;

// Steps after which islands that contacts have left are looked for again: they may have fallen apart.
constexpr int kMostAge = 32;

// A number for the domain, the colour and the kind.
constexpr int run_of(int bucket) {
    return (domain_of(bucket) * kColors + color_of(bucket)) * kBlockKinds + static_cast<int>(kind_of(bucket));
}

}  // namespace

void ContactBatches::cut(ContactLanes& lanes, const Motions& motions, std::span<const int> bodies,
                         bool some_rest, std::span<const int> domain_rows) {
    const bool knows_rows = seen_.lanes == &lanes && same_rows(motions, bodies);
    if (wait_ > 0) --wait_;
    if (knows_rows && seen_.version == lanes.version() && seen_.some_rest == some_rest &&
        (is_settled_ || wait_ > 0))
        return;
    seen_.lanes = &lanes;
    seen_.some_rest = some_rest;
    seen_.version = lanes.version();
    if (!knows_rows) note_rows(motions, bodies);
    const int rows = motions.size();
    is_settled_ = wait_ == 0;
    const bool is_cut = wait_ == 0 && (some_rest || lanes.blocks().size() >= kFewestBlocks) &&
                        ((knows_rows && list_known()) || list_anew(rows));
    if (!is_cut) keep_whole(rows, domain_rows);
}

bool ContactBatches::same_rows(const Motions& motions, std::span<const int> bodies) const {
    if (!std::ranges::equal(seen_.bodies, bodies)) return false;
    bool same = true;
    for (std::size_t row = 0; row < seen_.held.size(); ++row)
        same &= seen_.held[row] == (motions.mover[row] > MovedBy::Substeps ? 1 : 0);
    return same;
}

void ContactBatches::note_rows(const Motions& motions, std::span<const int> bodies) {
    resize_amply(seen_.bodies, bodies.size());
    std::ranges::copy(bodies, seen_.bodies.begin());
    resize_amply(seen_.held, static_cast<std::size_t>(motions.size()));
    for (std::size_t row = 0; row < seen_.held.size(); ++row)
        seen_.held[row] = motions.mover[row] > MovedBy::Substeps ? 1 : 0;
}

// As the rows were grouped before, if that is still right.
bool ContactBatches::list_known() {
    if (count_ == 0 || ++age_ > kMostAge || !list_blocks()) return false;
    list_runs();
    return true;
}

// False where most would be in the rest.
bool ContactBatches::list_anew(int rows) {
    age_ = 0;
    find_islands(rows);
    const int cut_off = choose_groups(rows);
    patience_ = 8 * cut_off < rows ? std::clamp(2 * patience_, 1, kMostPatience) : 0;
    wait_ = patience_;
    if (wait_ > 0) return false;
    list_rows(rows);
    list_blocks();
    list_runs();
    return true;
}

void ContactBatches::keep_whole(int rows, std::span<const int> domain_rows) {
    count_ = 0;
    ranges_.clear();
    if (domain_rows.empty()) {
        for (int row = 0; row < rows; row += kRowsPerRange)
            ranges_.add(kRest, {row, std::min(row + kRowsPerRange, rows)});
    }
    // The last domain has the rows that came since.
    for (std::size_t i = 0; i < domain_rows.size(); ++i) {
        const bool is_last = i + 1 == domain_rows.size();
        const int first = std::min(domain_rows[i], rows);
        ranges_.add(kRest, {first, is_last ? rows : std::min(domain_rows[i + 1], rows)});
    }
    ranges_.sort(1);
    entries_.clear();
    entries_.sort(1);
    reserve_amply(blocks_, seen_.lanes->pool_room());
    blocks_.resize(seen_.lanes->blocks().size());
    runs_.clear();
    std::size_t at = 0;
    int run = kNone;
    for (const int bucket : seen_.lanes->buckets()) {
        for (const int block : seen_.lanes->blocks(bucket)) {
            blocks_[at] = &seen_.lanes->block(block);
            extend_runs(run, run_of(bucket), at++);
        }
    }
    first_run_.assign({0, runs_.size()});
}

std::span<const ContactRun> ContactBatches::runs_of(int group) const {
    const auto at = static_cast<std::size_t>(group);
    return std::span(runs_).subspan(first_run_[at], first_run_[at + 1] - first_run_[at]);
}

// Runs of a group follow one another.
std::span<ContactBlock* const> ContactBatches::blocks_of(int group) const {
    const std::span<const ContactRun> runs = runs_of(group);
    if (runs.empty()) return {};
    ContactBlock* const* const first = runs.front().blocks.data();
    return {first, runs.back().blocks.data() + runs.back().blocks.size()};
}

std::span<KeptImpulses> ContactBatches::kept_of(int group) {
    const std::span<ContactBlock* const> blocks = blocks_of(group);
    if (blocks.empty()) return {};
    return std::span(kept_).subspan(static_cast<std::size_t>(blocks.data() - blocks_.data()), blocks.size());
}

void ContactBatches::find_islands(int rows) {
    islands_.reset(rows);
    for (const int i : seen_.lanes->blocks_in_memory()) {
        if (kind_of(seen_.lanes->link(i).bucket) == BlockKind::OneBody) continue;
        const ContactBlock& block = seen_.lanes->block(i);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if (block.a[lane] != kWorldRow && block.b[lane] != kWorldRow)
                islands_.unite(block.a[lane], block.b[lane]);
        }
    }
}

// The result is how many rows are in batches.
int ContactBatches::choose_groups(int rows) {
    constexpr int kHeld = -1;
    count_ = 0;
    assign_amply(sizes_, static_cast<std::size_t>(rows), 0);
    resize_amply(groups_, static_cast<std::size_t>(rows));
    for (int row = 1; row < rows; ++row) {
        const int root = groups_[row] = islands_.find(row);
        if (seen_.held[row] != 0) sizes_[root] = kHeld;
        if (sizes_[root] != kHeld) ++sizes_[root];
    }
    int cut_off = 0;
    int room = 0;
    for (int row = 1; row < rows; ++row) {
        const int root = groups_[row];
        if (root < row) {
            groups_[row] = groups_[root];
        } else if (sizes_[row] == kHeld || sizes_[row] > kMostRowsOfIsland) {
            groups_[row] = kRest;
        } else {
            if (room <= 0) {
                ++count_;
                room = kRowsPerBatch;
            }
            groups_[row] = count_;
            room -= sizes_[row];
            cut_off += sizes_[row];
        }
    }
    groups_[kWorldRow] = kRest;
    return cut_off;
}

void ContactBatches::list_rows(int rows) {
    ranges_.clear();
    int first = 1;
    for (int row = 1; row < rows; ++row) {
        const bool ends = row + 1 == rows || groups_[row + 1] != groups_[row];
        if (!ends && row + 1 - first < kRowsPerRange) continue;
        ranges_.add(groups_[row], {first, row + 1});
        first = row + 1;
    }
    ranges_.sort(count_ + 1);
}

// Unused lanes are of no group.
int ContactBatches::group_of(const ContactBlock& block, std::size_t lane) const {
    const int row = block.b[lane] != kWorldRow ? block.b[lane] : block.a[lane];
    return row != kWorldRow ? groups_[row] : kNone;
}

// False where a contact joins rows of two groups.
bool ContactBatches::list_blocks() {
    entries_.clear();
    copies_used_ = 0;
    open_copies_.assign(static_cast<std::size_t>(count_) + 1, {});
    for (const int bucket : seen_.lanes->buckets()) {
        const bool joins = kind_of(bucket) != BlockKind::OneBody;
        for (const int i : seen_.lanes->blocks(bucket)) {
            const ContactBlock& block = seen_.lanes->block(i);
            const int group = group_of(block, 0);
            bool together = true;
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const int own = group_of(block, lane);
                together &= own == group || own == kNone;
                if (joins && block.a[lane] != kWorldRow && groups_[block.a[lane]] != own) return false;
            }
            if (together) {
                entries_.add(std::max(group, kRest), {i, run_of(bucket)});
            } else {
                split(i, bucket);
            }
        }
    }
    return true;
}

void ContactBatches::split(int block, int bucket) {
    for (int lane = 0; lane < kLanes; ++lane) {
        const int group = group_of(seen_.lanes->block(block), static_cast<std::size_t>(lane));
        if (group == kNone) continue;
        OpenCopy& open = open_copies_[static_cast<std::size_t>(group)];
        const int run = run_of(bucket);
        if (open.run != run || copies_[static_cast<std::size_t>(open.copy)].used == kLanes) {
            open = {run, copies_used_++};
            if (copies_.size() < static_cast<std::size_t>(copies_used_)) copies_.emplace_back();
            copies_[static_cast<std::size_t>(open.copy)].used = 0;
            entries_.add(group, {~open.copy, run});
        }
        Copy& copy = copies_[static_cast<std::size_t>(open.copy)];
        copy.from[static_cast<std::size_t>(copy.used++)] = block * kLanes + lane;
    }
}

// `run` is that of the block before, which is followed by another.
void ContactBatches::extend_runs(int& run, int next, std::size_t block) {
    if (next != run)
        runs_.push_back({static_cast<BlockKind>(next % kBlockKinds),
                         {&blocks_[block], 0},
                         next / kBlockKinds % kColors,
                         next / kBlockKinds / kColors});
    run = next;
    runs_.back().blocks = {runs_.back().blocks.data(), runs_.back().blocks.size() + 1};
}

// Entries of a group come bucket by bucket, so those of a run follow one another.
void ContactBatches::list_runs() {
    entries_.sort(count_ + 1);
    resize_amply(blocks_, entries_.sorted().size());
    runs_.clear();
    first_run_.clear();
    std::size_t at = 0;
    for (int group = 0; group <= count_; ++group) {
        first_run_.push_back(runs_.size());
        int run = kNone;
        for (const Entry& entry : entries_.of(group)) {
            blocks_[at] = entry.block >= 0 ? &seen_.lanes->block(entry.block)
                                           : &copies_[static_cast<std::size_t>(~entry.block)].block;
            extend_runs(run, entry.run, at);
            ++at;
        }
    }
    first_run_.push_back(runs_.size());
}

void ContactBatches::fetch_group(int group) {
    for (const Entry& entry : entries_.of(group)) {
        if (entry.block >= 0) continue;
        Copy& copy = copies_[static_cast<std::size_t>(~entry.block)];
        copy.block.reports = false;
        copy.block.turning = nullptr;
        copy.turns.used = 0;
        for (int lane = 0; lane < kLanes; ++lane) {
            if (lane >= copy.used) {
                clear_lane(copy.block, lane);
                continue;
            }
            const int from = copy.from[static_cast<std::size_t>(lane)];
            const ContactBlock& block = seen_.lanes->block(from / kLanes);
            copy_lane(copy.block, lane, block, from % kLanes);
            if (block.turning == nullptr) continue;
            copy_lane(copy.turns, lane, *block.turning, from % kLanes);
            copy.block.turning = &copy.turns;
        }
    }
}

void ContactBatches::return_group(int group) {
    for (const Entry& entry : entries_.of(group)) {
        if (entry.block >= 0) continue;
        const Copy& copy = copies_[static_cast<std::size_t>(~entry.block)];
        for (int lane = 0; lane < copy.used; ++lane) {
            const int to = copy.from[static_cast<std::size_t>(lane)];
            copy_outcome(seen_.lanes->block(to / kLanes), to % kLanes, copy.block, lane);
        }
    }
}

}  // namespace cairn::physics
