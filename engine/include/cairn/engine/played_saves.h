// A save folder in memory, for runs that must neither see nor change what a player saved. While it lives, all
// that Files does below "save/" is done to it. Invariant: it accepts what the save folder on disk accepts: a
// path is a file or a folder, never both.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/result.h>

namespace cairn::engine {

class Files;

class PlayedSaves {
  public:
    /// Where several live, the last one is used. The files must outlive it.
    explicit PlayedSaves(Files& files);
    ~PlayedSaves();
    PlayedSaves(const PlayedSaves&) = delete;
    PlayedSaves& operator=(const PlayedSaves&) = delete;

    /// Names and contents together; far more than a game saves, far less than a machine has.
    static constexpr std::size_t kMaxBytes = 64u << 20;

    /// Whether a path, which must be a valid virtual one, is "save" or below it.
    static bool covers(std::string_view path);

    Result<std::string> read(std::string_view path) const;
    Result<void> write(std::string_view path, std::string_view text);
    Result<void> remove(std::string_view path);
    bool exists(std::string_view path) const;
    bool is_folder(std::string_view path) const;
    /// Names, sorted.
    Result<std::vector<std::string>> list(std::string_view folder) const;

  private:
    Files& owner_;
    std::map<std::string, std::string, std::less<>> files_;  ///< by path, with "save/"
    std::size_t bytes_ = 0;
};

}  // namespace cairn::engine
