// Results of tests as JUnit's XML, which CI services read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lua/errors.h"

namespace cairn::scripting {

struct TestResult {
    std::string file;
    std::string name;
    double duration_s = 0;
    std::optional<ScriptError> error;
};

/// One suite per file, in the order of the results.
std::string junit_xml(const std::string& game, const std::vector<TestResult>& results);

}  // namespace cairn::scripting
