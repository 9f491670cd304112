// A temporary file beside the target, renamed over it when it is complete.
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <cairn/engine/native_file.h>

namespace cairn::engine {
namespace {

namespace fs = std::filesystem;

Error write_error(const std::string& path, const std::error_code& reason) {
    return Error{"cannot write \"" + path + "\": " + reason.message()};
}

std::error_code last_error() {
    return {errno, std::generic_category()};
}

/// Whether it is there, and a rename would take the place of something else than a file's contents.
bool is_special(const fs::file_status& status) {
    return fs::exists(status) && !fs::is_regular_file(status);
}

std::error_code write_whole(const fs::path& path, std::string_view contents) {
    std::FILE* file = std::fopen(path.string().c_str(), "wb");
    if (file == nullptr) return last_error();
    std::error_code reason;
    // Nothing may have no address, which fwrite does not take.
    if (!contents.empty() && std::fwrite(contents.data(), 1, contents.size(), file) != contents.size())
        reason = last_error();
    // Closing writes what is still buffered.
    if (std::fclose(file) != 0 && !reason) reason = last_error();
    return reason;
}

/// What a path leads to, which need not be there yet.
fs::path target_of(const std::string& path) {
    std::error_code ignored;
    const fs::path target = fs::canonical(path, ignored);  // empty when there is nothing yet
    return target.empty() ? fs::path(path) : target;
}
fs::path unfinished_of(fs::path target) {
    return target += ".unfinished";
}

}  // namespace

Result<void> check_native_file(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) return write_error(path, std::make_error_code(std::errc::is_a_directory));
    if (is_special(status)) return {};
    const fs::path unfinished = unfinished_of(target_of(path));
    const std::error_code reason = write_whole(unfinished, {});
    fs::remove(unfinished, ignored);
    if (reason) return write_error(path, reason);
    return {};
}

Result<void> write_native_file(const std::string& path, std::string_view contents) {
    std::error_code ignored;
    if (is_special(fs::status(path, ignored))) {
        if (const std::error_code reason = write_whole(path, contents)) return write_error(path, reason);
        return {};
    }
    const fs::path target = target_of(path);
    const fs::path unfinished = unfinished_of(target);
    std::error_code reason = write_whole(unfinished, contents);
    if (!reason) fs::rename(unfinished, target, reason);
    if (reason) {
        fs::remove(unfinished, ignored);
        return write_error(path, reason);
    }
    return {};
}

}  // namespace cairn::engine
