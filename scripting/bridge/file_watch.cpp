// Looks at times and sizes; the system's own notices would need a watch for each folder, and editors that
// save by renaming leave those behind. A thousand files cost about a millisecond per look.
#include "bridge/file_watch.h"

#include <chrono>

namespace cairn::scripting {

namespace fs = std::filesystem;

namespace {
/// New files that nobody has looked for matter less than those that change.
constexpr double kSearchPeriod_s = 1;
}  // namespace

FileWatch::FileWatch(const std::string& folder, bool finds_new_files)
    : folder_(folder), finds_new_files_(finds_new_files) {
    find_files(false);
}

FileWatch::State FileWatch::state_of(const fs::path& file) {
    std::error_code failed;
    const auto modified = fs::last_write_time(file, failed);
    if (failed) return {};
    const std::uintmax_t size = fs::file_size(file, failed);
    if (failed) return {};
    return {std::chrono::duration_cast<std::chrono::nanoseconds>(modified.time_since_epoch()).count(), size};
}

void FileWatch::find_files(bool are_new) {
    std::error_code failed;
    std::size_t met = 0;
    for (fs::recursive_directory_iterator entry(folder_, failed), end;
         !failed && entry != end && ++met <= kMostFiles; entry.increment(failed)) {
        std::error_code unknown;
        if (entry->path().filename().string().starts_with('.')) {
            if (entry->is_directory(unknown)) entry.disable_recursion_pending();
            continue;
        }
        if (!entry->is_regular_file(unknown)) continue;
        const std::string path = entry->path().lexically_relative(folder_).generic_string();
        if (files_.contains(path)) continue;
        const State state = state_of(entry->path());
        files_[path] = {.seen = state, .told = are_new ? State{} : state};
    }
}

void FileWatch::expect(const std::string& path) {
    if (is_full() || files_.contains(path)) return;
    const State state = state_of(folder_ / path);
    files_[path] = {.seen = state, .told = state};
}

std::vector<std::string> FileWatch::changes(double now_s) {
    std::vector<std::string> paths;
    if (now_s < next_look_s_) return paths;
    next_look_s_ = now_s + kPeriod_s;
    for (auto& [path, file] : files_) {
        const State state = state_of(folder_ / path);
        const bool is_settled = state == file.seen;
        file.seen = state;
        // One that is gone for a moment is being replaced.
        if (!is_settled || state == file.told || state == State{}) continue;
        file.told = state;
        paths.push_back(path);
    }
    if (finds_new_files_ && now_s >= next_search_s_) {
        find_files(true);
        next_search_s_ = now_s + kSearchPeriod_s;
    }
    return paths;
}

}  // namespace cairn::scripting
