// What the command line means, and what it says about mistakes.
#include "command_line.h"

#include <catch2/catch.hpp>
#include <set>

#include "cost_command.h"
#include "determinism/proof.h"
#include "support/command_lines.h"

namespace cairn::lab {
namespace {

constexpr auto& parsed = test::parsed<parse_command_line>;
constexpr auto& error_of = test::error_of<parse_command_line>;

}  // namespace

TEST_CASE("cases are run in the order in which they are named, each once") {
    const CommandLine line = parsed({"torture", "--case", "19b", "--case", "5", "--case", "19b", "--peers"});
    CHECK(line.command == Command::Torture);
    REQUIRE(line.cases.size() == 2);
    CHECK(line.cases[0]->number == "19b");
    CHECK(line.cases[1]->number == "5");
    CHECK(line.peers);
    CHECK(line.json.empty());
}

TEST_CASE("all cases are run when none is named") {
    CHECK(parsed({"torture"}).cases.size() == all_cases().size());
}

TEST_CASE("every case of the specification is there, once, with a name") {
    const std::set<std::string> expected{"1",  "2",  "3",  "4",  "5",  "6",  "7",   "8",  "10",
                                         "11", "13", "14", "15", "16", "18", "19b", "20", "21",
                                         "22", "23", "25", "26", "29", "30", "31",  "32", "34",
                                         "35", "36", "37", "38", "39", "40", "42",  "43", "44"};
    std::set<std::string> found;
    for (const Case& test : all_cases()) {
        CHECK(found.insert(test.number).second);
        CHECK(!test.name.empty());
    }
    CHECK(found == expected);
}

TEST_CASE("problems are solved in the order in which they are named") {
    const CommandLine line =
        parsed({"accuracy", "--problem", "spring", "--problem", "bounce", "--quick", "--plot", "plots"});
    CHECK(line.command == Command::Accuracy);
    REQUIRE(line.problems.size() == 2);
    CHECK(line.problems[0]->name == "spring");
    CHECK(line.problems[1]->name == "bounce");
    CHECK(line.quick);
    CHECK(line.plot == "plots");
    CHECK(parsed({"accuracy"}).problems.size() == all_problems().size());
    CHECK_FALSE(parsed({"accuracy"}).quick);
}

TEST_CASE("what is said to cost is said to its script") {
    const CommandLine line =
        parsed({"cost", "--feature", "joints", "--json", "-", "--quick", "--feature", "mover"});
    CHECK(line.command == Command::Cost);
    CHECK(cost_arguments(line, "script") == std::vector<std::string>{"script", "--quick", "--feature",
                                                                     "joints", "--feature", "mover", "--json",
                                                                     "-"});
    CHECK(cost_arguments(parsed({"cost"}), "script") == std::vector<std::string>{"script"});
}

TEST_CASE("scenes are compared as they are named, all of them when none is") {
    const CommandLine line = parsed({"determinism", "--scene", "joint_weld", "--scene", "rain", "--steps",
                                     "30", "--nudge", "4", "--quick"});
    CHECK(line.command == Command::Determinism);
    REQUIRE(line.scenes.size() == 2);
    CHECK(line.scenes[0]->name == "joint_weld");
    CHECK(line.scenes[1]->name == "rain");
    CHECK(line.steps == 30);
    CHECK(line.nudged_step == 4);
    CHECK(line.quick);
    CHECK(parsed({"determinism"}).scenes.size() == determinism_scenes().size());
    CHECK(parsed({"determinism"}).nudged_step == -1);
}

TEST_CASE("mistakes on the lab's command line are named") {
    CHECK(error_of({"torture", "--case", "9"}) == "there is no case \"9\"; cairn-lab list names them all");
    CHECK(error_of({"accuracy", "--problem", "tea"}) ==
          "there is no problem \"tea\"; cairn-lab list names them all");
    CHECK(error_of({"determinism", "--scene", "tea"}) ==
          "there is no scene \"tea\"; cairn-lab list names them all");
    CHECK_THAT(error_of({"determinism", "--steps", "few"}), Catch::Contains("--steps is \"few\""));
    CHECK_THAT(error_of({"walk"}), Catch::Contains("walk"));
    CHECK_THAT(error_of({"torture", "--case"}), Catch::Contains("--case"));
}

TEST_CASE("help of the lab is asked for in the usual ways") {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{}, {"--help"}, {"torture", "--help"}}) {
        std::string help;
        const auto line = parse_command_line(arguments, help);
        REQUIRE(line);
        CHECK(line->command == Command::Help);
        CHECK_THAT(help, Catch::Contains("cairn-lab"));
    }
}

}  // namespace cairn::lab
