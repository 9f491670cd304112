// Notices that files of a game were saved. Invariant: a file is told of when it has not changed between two
// looks, so that one that an editor is still writing is not read half-written; a change is told once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cairn::scripting {

class FileWatch {
  public:
    /// How often it looks, s: a change is told after one to two of these.
    static constexpr double kPeriod_s = 0.15;
    /// Of a folder with more files and folders the others are not watched.
    static constexpr std::size_t kMostFiles = 4096;

    /// Below a folder, hidden files aside. A folder that is not a game's own may hold anything: there it
    /// looks for files once, and not for new ones.
    explicit FileWatch(const std::string& folder, bool finds_new_files = true);

    /// Paths below the folder, with forward slashes, of files that were saved, or are new, since the last
    /// call. Cheap to call in every frame. `now_s` never goes back.
    std::vector<std::string> changes(double now_s);

    /// Looks at this file too, below the folder, although it may not be there yet: when it comes, that is
    /// told as soon as a change is. Cheap for one that it looks at anyway.
    void expect(const std::string& path);
    /// Expects no more.
    bool is_full() const { return files_.size() >= kMostFiles; }

  private:
    struct State {
        std::int64_t modified_ns = 0;
        std::uintmax_t size = 0;
        friend bool operator==(const State&, const State&) = default;
    };
    struct File {
        State seen;  ///< at the last look
        State told;  ///< when it was told of last, or found first
    };
    static State state_of(const std::filesystem::path& file);
    void find_files(bool are_new);

    std::filesystem::path folder_;
    bool finds_new_files_;
    std::map<std::string, File> files_;
    double next_look_s_ = 0;
    double next_search_s_ = 0;
};

}  // namespace cairn::scripting
