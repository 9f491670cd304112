// The rule about virtual paths. Invariant: an accepted path is a list of plain names, so it cannot leave its
// mount on any operating system: no drive, no device, no parent, no second spelling of the same file.
#include <algorithm>

#include <cairn/engine/files.h>

namespace cairn::engine {
namespace {

/// For messages: control characters would break the line or hide the end.
std::string quoted(std::string_view path) {
    std::string out = "'";
    for (const char c : path) {
        if (c == '\0')
            out += "\\0";
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            out += '?';
        else
            out += c;
    }
    return out + "'";
}

Error bad_path(std::string_view path, std::string_view rule) {
    return Error{"path " + quoted(path) + ": " + std::string(rule)};
}

}  // namespace

Result<void> check_virtual_path(std::string_view path) {
    constexpr std::size_t kMaxPath = 1024;
    if (path.size() > kMaxPath) return bad_path(path.substr(0, 40), "must be no longer than 1024 bytes");
    for (const char c : path) {
        if (c == '\0') return bad_path(path, "must not contain a NUL character");
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            return bad_path(path, "must not contain control characters");
        if (c == '\\') return bad_path(path, "must use '/' between folders, not '\\'");
        if (c == ':') return bad_path(path, "must not contain ':'");
    }
    if (path.empty()) return {};
    if (path.front() == '/') return bad_path(path, "must not be absolute; paths start at the game's folder");
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t slash = std::min(path.find('/', start), path.size());
        const std::string_view name = path.substr(start, slash - start);
        if (name.empty()) return bad_path(path, "must not contain '//' or end in '/'");
        if (name.size() > kMaxFileNameBytes)
            return bad_path(path.substr(0, 40), "a name in it must be no longer than 255 bytes");
        if (name == "." || name == "..") return bad_path(path, "must not contain '.' or '..' as a folder");
        start = slash + 1;
    }
    return {};
}

}  // namespace cairn::engine
