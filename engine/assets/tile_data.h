// The tile numbers of a layer out of their text. Invariant: gives exactly the number of cells asked for, or
// an error.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <cairn/engine/result.h>

namespace cairn::engine {

/// "1,2,0,..." with any white space.
Result<std::vector<std::uint32_t>> tiles_from_csv(std::string_view text, std::size_t cells);
/// `compression` is "", "zlib" or "gzip".
Result<std::vector<std::uint32_t>> tiles_from_base64(std::string_view text, std::string_view compression,
                                                     std::size_t cells);

}  // namespace cairn::engine
