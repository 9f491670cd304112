#include "base/task_pool.h"

#include <array>
#include <catch2/catch.hpp>
#include <cfenv>
#include <csignal>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

constexpr std::array kThreadCounts{1, 2, 3, 8};

// A game engine's task system as a fake: each group of tasks gets threads of its own.
struct HostWithThreads {
    struct Group {
        std::vector<std::thread> threads;
    };

    int groups_begun = 0;
    int groups_ended = 0;
    int tasks = 0;

    TaskSystem as_tasks() {
        return {.context = this,
                .enqueue = [](void* context, TaskSystem::Task task, void* data, int count) -> void* {
                    auto& self = *static_cast<HostWithThreads*>(context);
                    ++self.groups_begun;
                    self.tasks += count;
                    auto group = std::make_unique<Group>();
                    for (int i = 0; i < count; ++i) group->threads.emplace_back(task, data, i);
                    return group.release();
                },
                .wait =
                    [](void* context, void* handle) {
                        const std::unique_ptr<Group> group(static_cast<Group*>(handle));
                        for (std::thread& thread : group->threads) thread.join();
                        ++static_cast<HostWithThreads*>(context)->groups_ended;
                    }};
    }
};

// A host with a single thread, which runs tasks when they are enqueued, or not before somebody waits for
// them.
struct HostWithoutThreads {
    bool runs_at_once;
    std::function<void()> run_tasks = [] {};

    TaskSystem as_tasks() {
        return {.context = this,
                .enqueue = [](void* context, TaskSystem::Task task, void* data, int count) -> void* {
                    auto& self = *static_cast<HostWithoutThreads*>(context);
                    self.run_tasks = [=] {
                        for (int i = 0; i < count; ++i) task(data, i);
                    };
                    if (self.runs_at_once) self.run_tasks();
                    return nullptr;
                },
                .wait =
                    [](void* context, void*) {
                        const auto& self = *static_cast<HostWithoutThreads*>(context);
                        if (!self.runs_at_once) self.run_tasks();
                    }};
    }
};

// How often each index of a loop was visited.
std::vector<int> visits(TaskPool& pool, int count, int grain) {
    std::vector<int> result(count, 0);
    pool.parallel_for(count, grain, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) ++result[i];
    });
    return result;
}

// Waits in a loop body until the given number of workers are in one: proof that they run at the same time.
void require_all_take_part(TaskPool& pool) {
    std::atomic<int> present{0};
    std::vector<int> runs(pool.threads(), 0);
    const TaskPool::Region region(pool);
    pool.parallel_for(pool.threads(), 1, [&](const Chunk& chunk) {
        ++present;
        while (present < pool.threads()) std::this_thread::yield();
        ++runs[chunk.worker];
    });
    CHECK(runs == std::vector<int>(pool.threads(), 1));
}

// The signal that ends a child process which does this, or 0.
int signal_of(const std::function<void()>& act) {
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);
        close(STDERR_FILENO);
        act();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

TEST_CASE("a parallel loop visits each index once, on any number of threads") {
    for (const int threads : kThreadCounts) {
        TaskPool pool(threads);
        for (const int count : {0, 1, 2, 7, 64, 1000, 4099}) {
            for (const int grain : {1, 3, 64, 5000}) {
                INFO(threads << " threads, " << count << " by " << grain);
                REQUIRE(visits(pool, count, grain) == std::vector<int>(count, 1));
            }
        }
    }
}

TEST_CASE("the chunks of a loop follow from its count and grain alone") {
    for (const int threads : kThreadCounts) {
        TaskPool pool(threads);
        std::vector<Chunk> seen(chunk_count(103, 10));
        pool.parallel_for(103, 10, [&](const Chunk& chunk) { seen[chunk.index] = chunk; });
        REQUIRE(seen.size() == 11);
        for (int i = 0; i < 11; ++i) {
            CHECK(seen[i].index == i);
            CHECK(seen[i].begin == 10 * i);
            CHECK(seen[i].end == (i < 10 ? 10 * i + 10 : 103));
            CHECK((seen[i].worker >= 0 && seen[i].worker < threads));
        }
    }
}

TEST_CASE("sums per chunk, added in the order of the chunks, are the same bits on any number of threads") {
    test::Random random(1);
    std::vector<float> numbers(10'000);
    for (float& number : numbers) number = random.real_f(-1e6, 1e6);
    std::vector<float> sums;
    for (const int threads : kThreadCounts) {
        TaskPool pool(threads);
        std::vector<float> partial(chunk_count(10'000, 37));
        pool.parallel_for(10'000, 37, [&](const Chunk& chunk) {
            partial[chunk.index] =
                std::accumulate(numbers.begin() + chunk.begin, numbers.begin() + chunk.end, 0.0f);
        });
        float sum = 0;
        for (const float part : partial) sum += part;
        sums.push_back(sum);
    }
    CHECK(sums == std::vector<float>(kThreadCounts.size(), sums[0]));
}

TEST_CASE("all workers of a pool run at the same time") {
    for (const int threads : {2, 3, 8}) {
        TaskPool pool(threads);
        require_all_take_part(pool);
        require_all_take_part(pool);
    }
}

TEST_CASE("loops in order see all that the loops before them wrote") {
    for (const int threads : kThreadCounts) {
        TaskPool pool(threads);
        // Each index of a row is the sum of three of the row before, which different chunks have written.
        constexpr int kRows = 200;
        constexpr int kColumns = 97;
        std::vector<std::uint32_t> expected((kRows + 1) * kColumns, 1);
        std::vector<std::uint32_t> cells = expected;
        const auto next = [](std::vector<std::uint32_t>& in, int row, int i) {
            const std::uint32_t* above = &in[row * kColumns];
            in[(row + 1) * kColumns + i] =
                above[i] + above[(i + 31) % kColumns] + above[(i + kColumns - 1) % kColumns];
        };
        for (int row = 0; row < kRows; ++row) {
            for (int i = 0; i < kColumns; ++i) next(expected, row, i);
        }
        struct Row {
            std::function<void(int, int)> next;
            int row;
            void operator()(const Chunk& chunk) const {
                for (int i = chunk.begin; i < chunk.end; ++i) next(row, i);
            }
        };
        std::vector<Row> rows;
        for (int row = 0; row < kRows; ++row) {
            rows.push_back({[&](int r, int i) { next(cells, r, i); }, row});
        }
        std::vector<ParallelLoop> loops;
        for (const Row& row : rows) loops.push_back(parallel_loop(kColumns, 1 + row.row % 40, row));
        const TaskPool::Region region(pool);
        pool.run_in_order(loops);
        CHECK(cells == expected);
    }
}

TEST_CASE("what is done beside a loop is done once, and the loop is cut as it would be alone") {
    for (const int threads : kThreadCounts) {
        TaskPool pool(threads);
        for (const int count : {0, 1, 7, 8, 9, 1'000}) {
            constexpr int kGrain = 8;
            int calls = 0;
            std::vector<int> alone(static_cast<std::size_t>(count), -1);
            std::vector<int> beside(static_cast<std::size_t>(count), -1);
            const auto note = [](std::vector<int>& chunks) {
                return [&chunks](const Chunk& chunk) {
                    for (int i = chunk.begin; i < chunk.end; ++i)
                        chunks[static_cast<std::size_t>(i)] += 1 + chunk.index;
                };
            };
            pool.parallel_for(count, kGrain, note(alone));
            pool.parallel_for_beside([&] { ++calls; }, count, kGrain, note(beside));
            INFO(threads << " threads, " << count << " indices");
            CHECK(calls == 1);
            CHECK(beside == alone);
        }
    }
}

TEST_CASE("loops in order may be empty, and so may the list of them") {
    TaskPool pool(2);
    std::atomic<int> runs{0};
    const auto count = [&](const Chunk&) { ++runs; };
    pool.run_in_order({});
    CHECK(runs == 0);
    const std::array loops{parallel_loop(0, 1, count), parallel_loop(5, 2, count), parallel_loop(0, 1, count),
                           parallel_loop(1, 1, count), parallel_loop(0, 1, count)};
    for (int i = 0; i < 100; ++i) pool.run_in_order(loops);
    CHECK(runs == 400);
}

TEST_CASE("a hundred thousand small loops lose no index, one by one and in order") {
    // With eight threads there are more than most test machines have cores.
    for (const int threads : {2, 8}) {
        TaskPool pool(threads);
        std::array<std::int64_t, 16> sums{};
        const auto add = [&](const Chunk& chunk) {
            for (int i = chunk.begin; i < chunk.end; ++i) sums[i] += i;
        };
        const std::vector<ParallelLoop> loops(50, parallel_loop(16, 4, add));
        for (int steps = 0; steps < 500; ++steps) {
            const TaskPool::Region region(pool);
            for (int i = 0; i < 50; ++i) pool.parallel_for(16, 4, add);
            pool.run_in_order(loops);
        }
        for (int i = 0; i < 16; ++i) CHECK(sums[i] == 50'000 * i);
    }
}

TEST_CASE("a pool can be destroyed while its threads wait for work") {
    for (int i = 0; i < 50; ++i) {
        TaskPool pool(4);
        if (i % 3 == 1) CHECK(visits(pool, 100, 7) == std::vector<int>(100, 1));
        if (i % 3 == 2) const TaskPool::Region region(pool);
    }
}

TEST_CASE("the floating-point environment of the caller holds in all workers, and only in loops") {
    TaskPool pool(4);
    std::vector<int> modes(4, -1);
    const auto round_of_each = [&] {
        std::atomic<int> present{0};
        const TaskPool::Region region(pool);
        pool.parallel_for(4, 1, [&](const Chunk& chunk) {
            ++present;
            while (present < 4) std::this_thread::yield();
            modes[chunk.worker] = std::fegetround();
        });
        return modes;
    };
    for (const int mode : {FE_UPWARD, FE_TOWARDZERO, FE_TONEAREST}) {
        std::fesetround(mode);
        const std::vector<int> seen = round_of_each();
        std::fesetround(FE_TONEAREST);
        CHECK(seen == std::vector<int>(4, mode));
    }
}

TEST_CASE("a loop inside a loop of the same pool, and a region inside a region, are refused") {
    // A child process makes no threads: one thread is refused like many.
    CHECK(signal_of([] {
              TaskPool pool(1);
              pool.parallel_for(1, 1, [&](const Chunk&) { pool.parallel_for(1, 1, [](const Chunk&) {}); });
          }) == SIGABRT);
    CHECK(signal_of([] {
              TaskPool pool(1);
              pool.parallel_for(1, 1, [](const Chunk&) {});
              pool.parallel_for(1, 1, [](const Chunk&) {});
          }) == 0);
    CHECK(signal_of([] {
              HostWithoutThreads host{.runs_at_once = true};
              const TaskSystem tasks = host.as_tasks();
              TaskPool pool(2, &tasks);
              const TaskPool::Region outer(pool);
              const TaskPool::Region inner(pool);
          }) == SIGABRT);
    CHECK(signal_of([] { TaskPool pool(0); }) == SIGABRT);
    CHECK(signal_of([] { TaskPool pool(65); }) == SIGABRT);
}

TEST_CASE("a pool may be used inside a loop of another one") {
    TaskPool outer(2);
    std::vector<std::vector<int>> seen(4);
    outer.parallel_for(4, 1, [&](const Chunk& chunk) {
        TaskPool inner(2);
        seen[chunk.index] = visits(inner, 50, 3);
    });
    for (const std::vector<int>& s : seen) CHECK(s == std::vector<int>(50, 1));
}

TEST_CASE("a host's task system runs the loops on its threads") {
    HostWithThreads host;
    {
        const TaskSystem tasks = host.as_tasks();
        TaskPool pool(4, &tasks);
        require_all_take_part(pool);
        CHECK(host.groups_begun == 1);
        CHECK(host.tasks == 3);
        for (int steps = 0; steps < 20; ++steps) {
            const TaskPool::Region region(pool);
            CHECK(visits(pool, 1000, 7) == std::vector<int>(1000, 1));
            CHECK(visits(pool, 10, 1) == std::vector<int>(10, 1));
        }
        CHECK(host.groups_begun == 21);  // one per region, however many loops it has
        CHECK(visits(pool, 1000, 7) == std::vector<int>(1000, 1));
    }
    CHECK(host.groups_begun == 22);
    CHECK(host.groups_ended == 22);
}

TEST_CASE("a host that runs tasks at once, or only when they are waited for, gets correct work") {
    for (const bool at_once : {true, false}) {
        HostWithoutThreads host{.runs_at_once = at_once};
        const TaskSystem tasks = host.as_tasks();
        TaskPool pool(3, &tasks);
        CHECK(visits(pool, 1000, 7) == std::vector<int>(1000, 1));
        const TaskPool::Region region(pool);
        CHECK(visits(pool, 1000, 7) == std::vector<int>(1000, 1));
        CHECK(visits(pool, 1000, 7) == std::vector<int>(1000, 1));
    }
}

TEST_CASE("a pool with one thread asks nothing of its host") {
    HostWithThreads host;
    const TaskSystem tasks = host.as_tasks();
    TaskPool pool(1, &tasks);
    CHECK(visits(pool, 1000, 7) == std::vector<int>(1000, 1));
    CHECK(host.groups_begun == 0);
}

}  // namespace cairn::physics
