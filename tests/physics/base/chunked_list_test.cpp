// Oracle: the same loop without chunks.
#include "base/chunked_list.h"

#include <catch2/catch.hpp>

#include "physics/support/allocation_counter.h"

namespace cairn::physics {
namespace {

// Each index appends itself as often as its last digit says.
std::vector<int> appended(TaskPool& pool, ChunkedList<int>& list, int count, int grain) {
    list.start(count, grain, pool);
    pool.parallel_for(count, grain, [&](const Chunk& chunk) {
        ChunkedList<int>::Appender appender(list, chunk);
        for (int i = chunk.begin; i < chunk.end; ++i)
            appender.items().insert(appender.items().end(), i % 10, i);
    });
    std::vector<int> all;
    list.copy_to(all);
    return all;
}

std::vector<int> expected(int count) {
    std::vector<int> all;
    for (int i = 0; i < count; ++i) all.insert(all.end(), i % 10, i);
    return all;
}

}  // namespace

TEST_CASE("what chunks append is read in the order of the chunks, on any number of threads") {
    for (const int threads : {1, 2, 3, 8}) {
        TaskPool pool(threads);
        ChunkedList<int> list;
        for (const int count : {1000, 0, 1, 64, 1000}) {
            for (const int grain : {1, 7, 64, 5000}) {
                INFO(threads << " threads, " << count << " by " << grain);
                CHECK(appended(pool, list, count, grain) == expected(count));
            }
        }
    }
}

TEST_CASE("a list that chunks append to keeps its memory from loop to loop") {
    TaskPool pool(1);
    ChunkedList<int> list;
    appended(pool, list, 1000, 7);
    const test::AllocationCounter counter;
    list.start(1000, 7, pool);
    pool.parallel_for(1000, 7, [&](const Chunk& chunk) {
        ChunkedList<int>::Appender appender(list, chunk);
        for (int i = chunk.begin; i < chunk.end; ++i) appender.items().push_back(i);
    });
    CHECK(counter.count() == 0);
}

TEST_CASE("of two threads either has room for all that ever stood in the list") {
    TaskPool pool(2);
    ChunkedList<int> list;
    // As if one worker was faster than the other each time.
    const auto append_by = [&](int worker) {
        list.start(2, 1, pool);
        for (int index = 0; index < 2; ++index) {
            ChunkedList<int>::Appender appender(list, {index, index + 1, index, worker});
            for (int i = 0; i < 500; ++i) appender.items().push_back(i);
        }
    };
    append_by(0);
    list.start(2, 1, pool);
    const test::AllocationCounter counter;
    append_by(1);
    append_by(0);
    CHECK(counter.count() == 0);
    CHECK(list.size() == 1000);
}

}  // namespace cairn::physics
