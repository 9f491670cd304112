// For tests of programs that take arguments: what those mean, and what is said about wrong ones.
#pragma once

#include <string>
#include <vector>

namespace cairn::test {

/// Of arguments that are right. `kParse` takes them and a place for the help.
template <auto kParse>
auto parsed(const std::vector<std::string>& arguments) {
    std::string help;
    return kParse(arguments, help).value();
}

template <auto kParse>
std::string error_of(const std::vector<std::string>& arguments) {
    std::string help;
    const auto line = kParse(arguments, help);
    return line ? "no error" : line.error().message;
}

}  // namespace cairn::test
