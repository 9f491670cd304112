#include "base/slot_map.h"

#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include <cairn/physics/ids.h>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using Id = Handle<struct TestTag>;
using Map = SlotMap<int, Id>;

}  // namespace

TEST_CASE("a slot map finds what was inserted, by its handle") {
    Map map(7);
    const Id one = map.id(map.insert(11));
    const Id two = map.id(map.insert(22));
    CHECK(map[map.find(one)] == 11);
    CHECK(map[map.find(two)] == 22);
    CHECK(map.size() == 2);
    CHECK(one != two);
}

TEST_CASE("a null, a stale and a foreign handle find nothing") {
    Map map(7);
    Map other(8);
    const Id mine = map.id(map.insert(1));
    const Id foreign = other.id(other.insert(1));
    CHECK(map.find(Id{}) == kNone);
    CHECK(map.find(foreign) == kNone);
    CHECK(map.find(Id::make(99, 0, 7)) == kNone);
    map.erase(map.find(mine));
    CHECK(map.find(mine) == kNone);
    CHECK(map.size() == 0);
}

TEST_CASE("a slot is used again, and its old handle stays stale") {
    Map map(7);
    const Id old = map.id(map.insert(1));
    map.erase(map.find(old));
    const Id young = map.id(map.insert(2));
    CHECK(young.index1 == old.index1);
    CHECK(young != old);
    CHECK(map.find(old) == kNone);
    CHECK(map[map.find(young)] == 2);
}

TEST_CASE("a slot whose generations are used up retires") {
    Map map(7);
    const int index = map.insert(1);
    const Id first = map.id(index);
    for (std::uint32_t i = 0; i < Map::kMaxGeneration; ++i) {
        map.erase(index);
        REQUIRE(map.insert(1) == index);
    }
    const Id last = map.id(index);
    CHECK(last.generation == Map::kMaxGeneration);
    map.erase(index);
    CHECK(map.insert(1) != index);
    CHECK(map.find(last) == kNone);
    CHECK(map.find(first) == kNone);
}

TEST_CASE("handles survive being stored as one number") {
    const Id id = Id::make(0xabcdef, 0x123456, 0xfedc);
    CHECK(Id::from_bits(id.bits()) == id);
    CHECK(id);
    CHECK_FALSE(Id{});
    CHECK(Id{}.bits() == 0);
}

TEST_CASE("a slot map agrees with a map of handles under random insertion and removal") {
    test::Random random(1);
    Map map(3);
    std::map<std::uint64_t, int> expected;
    std::vector<Id> gone;
    for (int operation = 0; operation < 20'000; ++operation) {
        if (expected.empty() || random.chance(0.52)) {
            const Id id = map.id(map.insert(operation));
            REQUIRE(expected.emplace(id.bits(), operation).second);
        } else {
            auto victim = expected.begin();
            std::advance(victim, random.below(static_cast<int>(std::min<std::size_t>(expected.size(), 50))));
            const Id id = Id::from_bits(victim->first);
            map.erase(map.find(id));
            gone.push_back(id);
            expected.erase(victim);
        }
    }
    REQUIRE(map.size() == static_cast<int>(expected.size()));
    for (const auto& [bits, value] : expected) REQUIRE(map[map.find(Id::from_bits(bits))] == value);
    for (const Id id : gone) REQUIRE(map.find(id) == kNone);
}

}  // namespace cairn::physics
