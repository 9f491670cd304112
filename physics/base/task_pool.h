// Runs short loops on several threads: fork and join, some hundred times per step of a world.
// Invariant: how a loop is cut depends on its count and grain alone, never on threads or time. A body that
// writes only to what belongs to its indices, or to its chunk's slot, leaves the same bits on any number of
// threads.
// Source: work that stays with its thread while there is enough of it, and is stolen when there is not, after
// Markatos and LeBlanc, "Using Processor Affinity in Loop Scheduling" (1994).
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cfenv>
#include <cstdint>
#include <memory>
#include <span>
#include <thread>
#include <vector>

#include <cairn/physics/tasks.h>

#include "base/assert.h"

namespace cairn::physics {

/// Part of a loop: the indices begin up to, and without, end.
struct Chunk {
    int begin;
    int end;
    int index;   // of the chunk in its loop, in ascending order
    int worker;  // who runs it, 0 up to threads - 1. For scratch memory; results must not depend on it
};

/// How many chunks of `grain` indices a loop has; the last may be shorter.
inline int chunk_count(int count, int grain) {
    return count / grain + (count % grain != 0 ? 1 : 0);
}

/// A loop as data. The body is called once per chunk, at the same time on several threads. It throws nothing.
struct ParallelLoop {
    void (*body)(const void* context, const Chunk& chunk);
    const void* context;
    int count;
    int grain;
};

/// A loop over 0 up to, and without, count. `f`, called as f(Chunk), must live until the loop has run.
template <class F>
ParallelLoop parallel_loop(int count, int grain, const F& f) {
    const auto body = [](const void* context, const Chunk& chunk) noexcept {
        (*static_cast<const F*>(context))(chunk);
    };
    return {body, std::addressof(f), count, grain};
}

/// The threads, and how they share loops. The thread that calls is worker 0 and takes part. With one thread
/// all is a plain loop. Nothing here allocates after construction.
///
/// No thread ever waits for another to take part: chunks that nobody has begun are free for all. Only a chunk
/// that has been begun is waited for, at first busily and then by yielding, so that more threads than cores
/// cost little.
class TaskPool {
  public:
    static constexpr int kMaxThreads = 64;
    /// The most chunks that a loop may have.
    static constexpr int kMaxChunks = (1 << 20) - 1;

    /// `threads` counts the caller. With a host, its tasks take the place of threads of our own; the struct
    /// is copied. Where the system refuses to make a thread, those that exist make do.
    explicit TaskPool(int threads, const TaskSystem* host = nullptr);
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    [[nodiscard]] int threads() const { return threads_; }

    /// While one exists the workers stay awake and wait for loops busily: about a microsecond per loop less.
    /// Worth it around a whole step. Regions do not nest. A loop outside of any gets one of its own.
    class Region {
      public:
        explicit Region(TaskPool& pool) : pool_(pool) { pool_.begin_region(); }
        ~Region() { pool_.end_region(); }
        Region(const Region&) = delete;
        Region& operator=(const Region&) = delete;

      private:
        TaskPool& pool_;
    };

    /// Calls f(Chunk) for every chunk, and comes back when all have been. Not from inside a loop of this
    /// pool.
    template <class F>
    void parallel_for(int count, int grain, const F& f) {
        if (count == 0) return;
        // What fits into one chunk is called in place: a step of few bodies is made of such loops.
        if (0 < count && count <= grain) {
            begin_loops();
            f(Chunk{0, count, 0, 0});
            end_loops();
            return;
        }
        const ParallelLoop loop = parallel_loop(count, grain, f);
        run_in_order({&loop, 1});
    }

    /// The same, while one thread calls alone(), which comes first where one thread has all to do. The loop
    /// must not depend on that, nor that on the loop.
    template <class Alone, class F>
    void parallel_for_beside(const Alone& alone, int count, int grain, const F& f) {
        if (count <= grain) {
            alone();
            return parallel_for(count, grain, f);
        }
        parallel_for(chunk_count(count, grain) + 1, 1, [&](const Chunk& chunk) {
            if (chunk.index == 0) return alone();
            const int begin = (chunk.index - 1) * grain;
            f(Chunk{begin, std::min(begin + grain, count), chunk.index - 1, chunk.worker});
        });
    }

    /// Runs the loops one after the other: each begins when all chunks of the one before it have ended, and
    /// sees what they wrote. Cheaper than as many calls, because the workers pass from loop to loop by
    /// themselves. Chunk i of n goes by preference to the worker that had chunk i of n before, whose cache
    /// holds its data.
    void run_in_order(std::span<const ParallelLoop> loops);

  private:
    friend class Region;

    static constexpr std::size_t kCacheLine = 64;

    /// What one worker tells the others. Each has a cache line that it alone writes, and one that others
    /// write only when they steal: to look at a line that another core has written since takes a tenth of a
    /// microsecond or more, and that is what a short loop costs in the end.
    struct Worker {
        /// It may read the job although it holds none of its chunks.
        alignas(kCacheLine) std::atomic<bool> inside{false};
        /// Chunks that it has run and ended since the pool was made.
        std::atomic<std::int64_t> ended{0};
        std::uint32_t region = 0;  // whose environment its thread has
        /// Chunks taken of its part, and of which loop: number << 20 | taken. What belongs to an earlier loop
        /// counts as none, so nobody need reset it.
        alignas(kCacheLine) std::atomic<std::uint64_t> taken{0};
    };

    /// The loops that run. Except for `open`, read by whoever holds a chunk of them or is inside, and written
    /// while nobody does or is.
    struct alignas(kCacheLine) Job {
        /// The newest loop that has opened: number << 20 | chunks. Loops are numbered from 1 on as long as
        /// the pool lives.
        std::atomic<std::uint64_t> open{0};
        std::span<const ParallelLoop> loops;
        std::uint64_t first = 1;        // number of loops[0]
        std::int64_t ended_before = 0;  // chunks of all jobs before
        std::uint32_t region = 0;

        [[nodiscard]] const ParallelLoop& loop(std::uint64_t number) const { return loops[number - first]; }
        [[nodiscard]] bool is_last(std::uint64_t number) const { return number - first + 1 == loops.size(); }
        [[nodiscard]] std::int64_t ended_after(std::uint64_t number) const;
    };

    /// Chunks that are a worker's own, unless others steal them.
    struct Part {
        int begin;
        int size;
    };

    // Between the two, no other loop of this pool may begin.
    void begin_loops() {
        CAIRN_ASSERT(!running_.load(std::memory_order_relaxed),
                     "a loop of a pool must not run inside another");
        running_.store(true, std::memory_order_relaxed);
    }
    void end_loops() { running_.store(false, std::memory_order_relaxed); }

    static Part part_of(int chunks, int worker, int threads);

    void begin_region();
    void end_region();
    void run_thread(int worker);
    static void run_host_task(void* pool, int index);
    void work_in_region(int worker, std::uint32_t region);
    void run_job(std::span<const ParallelLoop> loops);
    void help_from(std::uint64_t number, int chunks, int worker);
    bool take_part(std::uint64_t number, int chunks, std::int64_t ended_after, int worker);
    int run_part(std::uint64_t number, const Part& part, int owner, int worker);
    void take_environment(int worker);
    [[nodiscard]] std::int64_t ended() const;
    [[nodiscard]] bool in_region() const;

    int threads_;
    bool has_host_;
    TaskSystem host_;
    void* host_group_ = nullptr;
    std::fenv_t environment_{};  // of the thread that began the region: rounding, subnormal numbers
    std::atomic<bool> running_{false};

    Job job_;
    /// Odd while a region is open. Workers sleep on it in between; kStop ends them.
    alignas(kCacheLine) std::atomic<std::uint32_t> region_{0};
    std::vector<Worker> workers_;
    std::vector<std::thread> own_threads_;
};

}  // namespace cairn::physics
