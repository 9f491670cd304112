// Typed handles: a handle finds its own value or nothing.
#include "base/handle_table.h"

#include <catch2/catch.hpp>
#include <string>

using namespace cairn::engine;

TEST_CASE("a handle finds its value until the value is erased") {
    HandleTable<TextureId, std::string> table;
    const TextureId a = table.insert("a");
    const TextureId b = table.insert("b");
    REQUIRE(table.find(a));
    CHECK(*table.find(a) == "a");
    table.erase(a);
    CHECK(table.find(a) == nullptr);
    CHECK(*table.find(b) == "b");
}

TEST_CASE("a stale handle does not find the value that took its place") {
    HandleTable<TextureId, std::string> table;
    const TextureId old = table.insert("old");
    table.erase(old);
    const TextureId reused = table.insert("new");
    CHECK(reused.index == old.index);
    CHECK(table.find(old) == nullptr);
    table.erase(old);
    CHECK(*table.find(reused) == "new");
}

TEST_CASE("the null handle finds nothing") {
    HandleTable<TextureId, std::string> table;
    (void)table.insert("a");
    CHECK(TextureId{}.is_null());
    CHECK(table.find(TextureId{}) == nullptr);
}
