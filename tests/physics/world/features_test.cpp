// What a build has, and the words about what it lacks. That builds which lack something refuse it and are
// otherwise the same is for tools/lab/cost, which makes such builds.
#include "world/features.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

namespace cairn::physics {

TEST_CASE("every feature has a name of its own, and is in a build with tests") {
    std::set<std::string_view> names;
    for (const Feature feature : kFeatures) {
        names.insert(name(feature));
        CHECK(is_built_in(feature));
        CHECK_FALSE(require_built_in(feature, true));
        CHECK_FALSE(require_built_in(feature, false));
    }
    CHECK(names.size() == kFeatures.size());
}

TEST_CASE("what a build lacks is named with the option that left it out") {
    CHECK(absence(Feature::Sensors).message ==
          "sensors were left out of this build, which was made with CAIRN_WITH_SENSORS=OFF");
    CHECK(absence(Feature::DirectSolver).message ==
          "direct solver was left out of this build, which was made with CAIRN_WITH_DIRECT_SOLVER=OFF");
}

}  // namespace cairn::physics
