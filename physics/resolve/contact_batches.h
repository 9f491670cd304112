// Bodies and contacts of a step, cut into batches that share no body: each can be taken through all substeps
// at once, while the cache holds it, and threads take batches without waiting for each other.
// A batch holds whole islands, of bodies on which nothing acts but contacts in lanes. The rest, which is
// solved pass by pass with everything else, holds what anything else acts on, all that hangs together with
// it, and islands that are large.
// Invariant: every row but that of the world is in one batch or in the rest; the bits do not depend on how it
// was cut, since the blocks of a colour may be solved in any order. Source: Tarjan 1975, for the islands.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/ample.h"
#include "base/grouped.h"
#include "base/motion.h"
#include "base/union_find.h"
#include "resolve/contact_lanes.h"
#include "resolve/contact_passes.h"
#include "resolve/kept_impulses.h"

namespace cairn::physics {

/// From first up to, and without, last.
struct RowRange {
    int first = 0;
    int last = 0;
};

class ContactBatches {
  public:
    /// Rows of the rest come in ranges of at most this many, or one for each domain.
    static constexpr int kRowsPerRange = 1024;

    /// Of blocks that are arranged; `bodies` are those of the rows from 1 on. Tells from the movers what else
    /// acts on them. What nothing has changed since the last time is taken from there. Few contacts are cut
    /// only if `some_rest`, so that what rests can be left alone. `domain_rows` are the first rows of the
    /// domains, the first of them 0; the threads that take a domain take its rows.
    void cut(ContactLanes& lanes, const Motions& motions, std::span<const int> bodies, bool some_rest,
             std::span<const int> domain_rows = {});
    /// To be told when the lanes are others, though of the same version.
    void forget() { seen_.lanes = nullptr; }

    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] std::span<const RowRange> rows(int batch) const { return ranges_.of(batch + 1); }
    [[nodiscard]] std::span<const RowRange> rest_rows() const { return ranges_.of(kRest); }
    /// In the order of the domains, the interface last, and of the colours.
    [[nodiscard]] std::span<const ContactRun> runs(int batch) const { return runs_of(batch + 1); }
    /// Each of one domain and colour.
    [[nodiscard]] std::span<const ContactRun> rest_runs() const { return runs_of(kRest); }

    /// All of them together, and room beside them to keep their impulses, once that was made.
    [[nodiscard]] std::span<ContactBlock* const> blocks(int batch) const { return blocks_of(batch + 1); }
    [[nodiscard]] std::span<ContactBlock* const> rest_blocks() const { return blocks_of(kRest); }
    void make_room_to_keep() {
        reserve_amply(kept_, std::max(blocks_.size(), seen_.lanes->pool_room()));
        kept_.resize(blocks_.size());
    }
    [[nodiscard]] std::span<KeptImpulses> kept(int batch) { return kept_of(batch + 1); }
    [[nodiscard]] std::span<KeptImpulses> rest_kept() { return kept_of(kRest); }

    // Blocks of which some lanes are another batch's are copied, each batch its lanes. Before the first pass
    // and after the last one.
    void fetch_lanes(int batch) { fetch_group(batch + 1); }
    void return_lanes(int batch) { return_group(batch + 1); }
    void fetch_rest() { fetch_group(kRest); }
    void return_rest() { return_group(kRest); }

  private:
    static constexpr int kRest = 0;  // group; batch i is group i + 1

    struct Entry {
        int block;  // of the lanes, or ~place among the copies
        int run;    // a number for its colour and kind
    };
    struct Copy {
        ContactBlock block;
        TurnLanes turns;
        Lanes<std::int32_t> from{};  // lanes
        int used = 0;
    };
    // The copy that a group fills.
    struct OpenCopy {
        int run = -1;
        int copy = -1;
    };

    // From what the lists were made.
    struct Seen {
        ContactLanes* lanes = nullptr;
        std::uint64_t version = 0;
        bool some_rest = false;
        std::vector<int> bodies;         // by row, from 1 on
        std::vector<std::uint8_t> held;  // by row: something else acts on it
    };

    [[nodiscard]] std::span<const ContactRun> runs_of(int group) const;
    [[nodiscard]] std::span<ContactBlock* const> blocks_of(int group) const;
    [[nodiscard]] std::span<KeptImpulses> kept_of(int group);
    bool same_rows(const Motions& motions, std::span<const int> bodies) const;
    void note_rows(const Motions& motions, std::span<const int> bodies);
    bool list_known();
    bool list_anew(int rows);
    void keep_whole(int rows, std::span<const int> domain_rows);
    void find_islands(int rows);
    int choose_groups(int rows);
    void list_rows(int rows);
    bool list_blocks();
    void list_runs();
    void extend_runs(int& run, int next, std::size_t block);
    void split(int block, int bucket);
    int group_of(const ContactBlock& block, std::size_t lane) const;
    void fetch_group(int group);
    void return_group(int group);

    Seen seen_;
    int count_ = 0;
    bool is_settled_ = false;  // with the same rows and lanes the lists would be the same
    int age_ = 0;              // steps since islands were looked for
    // Steps until they are looked for again, and how many that were when none were found.
    int wait_ = 0;
    int patience_ = 0;
    UnionFind islands_;         // of rows
    std::vector<int> sizes_;    // of islands, at their roots; less than 0: of the rest
    std::vector<int> groups_;   // of rows
    Grouped<RowRange> ranges_;  // rows of a group
    Grouped<Entry> entries_;
    std::vector<Copy> copies_;  // the first of them are in use
    int copies_used_ = 0;
    std::vector<OpenCopy> open_copies_;   // by group
    std::vector<ContactBlock*> blocks_;   // beside the sorted entries
    std::vector<KeptImpulses> kept_;      // beside them, where they are kept
    std::vector<ContactRun> runs_;        // group by group
    std::vector<std::size_t> first_run_;  // by group
};

}  // namespace cairn::physics
