// What the command line means, and what it says about mistakes.
#include "command_line.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "support/command_lines.h"

namespace cairn::bench {
namespace {

constexpr auto& parsed = test::parsed<parse_command_line>;
constexpr auto& error_of = test::error_of<parse_command_line>;

}  // namespace

TEST_CASE("scenes are run in the order in which they are named, each once") {
    const CommandLine line = parsed({"run", "washer", "smash", "washer", "--repeat", "3", "--steps", "20"});
    CHECK(line.command == Command::Run);
    REQUIRE(line.scenes.size() == 2);
    CHECK(line.scenes[0]->name == "washer");
    CHECK(line.scenes[1]->name == "smash");
    CHECK(line.repeat == 3);
    CHECK(line.most_steps == 20);
    CHECK(line.threads == 1);
    CHECK_FALSE(line.warm);
    CHECK(line.simd == physics::available_simd_levels().back());
}

TEST_CASE("all means every scene, and to compare, every scene that other engines can run") {
    CHECK(parsed({"run", "all"}).scenes.size() == all_scenes().size());
    const CommandLine line = parsed({"compare"});
    CHECK(!line.scenes.empty());
    CHECK(line.scenes.size() < all_scenes().size());
    for (const Scene* scene : line.scenes) CHECK(scene->for_every_engine);
}

TEST_CASE("runs in a world that is warm are asked for") {
    CHECK(parsed({"run", "smash", "--warm"}).warm);
}

TEST_CASE("a slow SIMD level can be asked for by its name") {
    CHECK(parsed({"run", "smash", "--simd", "scalar"}).simd == physics::SimdLevel::Scalar);
}

TEST_CASE("mistakes on the command line are named with what would have been right") {
    CHECK(error_of({"run", "teapot"}) == "there is no scene \"teapot\"; cairn-bench list names them all");
    CHECK(error_of({"compare", "falling_1k"}) ==
          "scene \"falling_1k\" uses what other engines lack, and cannot be compared");
    CHECK(error_of({"run", "smash", "--threads", "9"}) ==
          "--threads is \"9\", but must be a whole number from 1 to 8");
    CHECK(error_of({"run", "smash", "--repeat", "0"}) ==
          "--repeat is \"0\", but must be a whole number from 1 to 1000");
    CHECK(error_of({"run", "smash", "--steps", "ten"}) ==
          "--steps is \"ten\", but must be a whole number from 0 to 1000000");
    CHECK_THAT(error_of({"run", "smash", "--simd", "mmx"}),
               Catch::StartsWith("--simd is \"mmx\", but must be one of "));
    CHECK_THAT(error_of({"run"}), Catch::Contains("SCENE"));
    CHECK_THAT(error_of({"walk"}), Catch::Contains("walk"));
}

TEST_CASE("help is asked for in the usual ways") {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{}, {"--help"}, {"run", "--help"}}) {
        std::string help;
        const auto line = parse_command_line(arguments, help);
        REQUIRE(line);
        CHECK(line->command == Command::Help);
        CHECK_THAT(help, Catch::Contains("cairn-bench"));
    }
}

}  // namespace cairn::bench
