#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include <cairn/scripting/reference.h>

namespace cairn::scripting {
namespace {

std::string file_text(const std::string& path) {
    std::ifstream file(CAIRN_SOURCE_DIR + ("/" + path));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// To renew them: cairn help --reference > docs/reference/lua.md; cairn help --types >
// scripting/types/cairn.lua
TEST_CASE("the committed reference is the one that the bindings give") {
    const bool is_same = file_text("docs/reference/lua.md") == reference_markdown();
    INFO("to renew it: cairn help --reference > docs/reference/lua.md");
    CHECK(is_same);
}

TEST_CASE("the committed format of levels is the one that the descriptions give") {
    const bool is_same = file_text("docs/reference/levels.md") == level_reference_markdown();
    INFO("to renew it: cairn help --levels > docs/reference/levels.md");
    CHECK(is_same);
}

TEST_CASE("the committed annotations are those that the bindings give") {
    const bool is_same = file_text("scripting/types/cairn.lua") == editor_annotations();
    INFO("to renew them: cairn help --types > scripting/types/cairn.lua");
    CHECK(is_same);
}

}  // namespace
}  // namespace cairn::scripting
