// Writing files of the operating system, outside what a game may see: recordings, pictures, new games.
#pragma once

#include <string>
#include <string_view>

#include <cairn/engine/result.h>

namespace cairn::engine {

/// Replaces a file in one stroke: when the disk is full or the program dies, the old contents or nothing at
/// all are there, never a part. A link's target is replaced, and what is no regular file (a terminal, a pipe)
/// is written to directly. The error names the path and the reason.
Result<void> write_native_file(const std::string& path, std::string_view contents);

/// Whether it could be written now, found without touching what is there: for what is written after hours of
/// play.
Result<void> check_native_file(const std::string& path);

}  // namespace cairn::engine
