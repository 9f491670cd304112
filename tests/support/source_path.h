// Where tests find the goldens, games and assets of the source tree.
#pragma once

#include <string>
#include <string_view>

namespace cairn::test {

/// The path of a file or folder that the root of the source tree has at `relative`, such as "assets/fonts".
std::string source_path(std::string_view relative);

}  // namespace cairn::test
