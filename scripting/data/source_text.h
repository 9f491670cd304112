// What editors and shells put before the code of a Lua file.
#pragma once

#include <algorithm>
#include <string_view>

namespace cairn::scripting {

/// The code of a file, without a UTF-8 byte order mark and without a first line that begins with #. The end
/// of that line stays, so that lines keep their numbers.
inline std::string_view code_of(std::string_view file) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (file.starts_with(kByteOrderMark)) file.remove_prefix(kByteOrderMark.size());
    if (file.starts_with('#')) file.remove_prefix(std::min(file.find('\n'), file.size()));
    return file;
}

}  // namespace cairn::scripting
