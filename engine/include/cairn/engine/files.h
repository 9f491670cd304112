// The files that a game may see: read-only mounts and one save folder, under virtual paths with forward
// slashes. Invariant: no virtual path reaches outside the mounts: "..", ".", absolute paths, back-slashes,
// colons, control characters and symbolic links are refused. Only paths below "save/" can be written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/result.h>

namespace cairn::engine {

struct FilesDef {
    /// The program's argv[0], which PhysFS wants to see on some systems.
    std::string program_path = {};
    /// Names the save folder: letters, digits, '-', '_' and '.', not starting with '.'. Empty: there is no
    /// save folder.
    std::string identity = {};
    /// The native folder that holds the save folders; empty: the user's data folder, which is
    /// $XDG_DATA_HOME/cairn or ~/.local/share/cairn on Linux. The folder is made by the first write, which
    /// fails where there is no such place.
    std::string save_root = {};
    /// A larger file is refused, so that an archive that unpacks to gigabytes cannot fill the memory.
    std::uint64_t max_file_bytes = 256ull << 20;
};

/// Of a file's or folder's name; what nearly every file system allows.
inline constexpr std::size_t kMaxFileNameBytes = 255;

/// Whether a text can be FilesDef::identity, and what is said of one that cannot.
bool is_save_identity(std::string_view identity);
inline constexpr std::string_view kSaveIdentityRule =
    "names the save folder, so it must be at most 64 letters, digits, '-', '_' or '.', and not start with "
    "'.'";

/// Where in the order of mounts a new one goes; the first mount that has a path wins.
enum class MountOrder { First, Last };

enum class FileKind { File, Folder };

class PlayedSaves;

/// At most one may exist at a time, because PhysFS keeps one state per process; a second one is refused.
class Files {
  public:
    static Result<std::unique_ptr<Files>> create(const FilesDef& def);
    ~Files();
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;

    /// Makes the contents of a native folder or archive (.zip, .cairn) readable below `mount_point` ("" is
    /// the root).
    Result<void> mount(const std::string& native_path, std::string_view mount_point = "",
                       MountOrder order = MountOrder::Last);
    Result<void> unmount(const std::string& native_path);

    bool exists(std::string_view path) const;
    Result<FileKind> kind(std::string_view path) const;
    Result<std::string> read_text(std::string_view path) const;
    Result<std::vector<std::byte>> read_bytes(std::string_view path) const;

    /// Names, not paths, of what a folder holds, sorted by byte value; "" is the root.
    Result<std::vector<std::string>> list(std::string_view folder) const;

    /// Whether anybody has asked for the file, with or without success: read it, looked whether it is there,
    /// or listed its folder. What nobody asked for can be of no effect.
    bool was_asked_for(std::string_view path) const;
    /// The files and folders themselves, those that are not there too.
    const std::set<std::string, std::less<>>& asked_for() const { return asked_for_; }

    /// A number that changes whenever the file is saved: nanoseconds since some fixed time.
    Result<std::int64_t> modified_ns(std::string_view path) const;

    /// The native file behind a virtual path, for messages that a person's editor understands. A file inside
    /// an archive gives ARCHIVE/PATH.
    Result<std::string> native_path(std::string_view path) const;

    /// Replaces a file below "save/" in one stroke: if the program dies meanwhile, the old or the new
    /// contents are there, never a mix. Missing folders are made.
    Result<void> write(std::string_view path, std::string_view contents);
    Result<void> write(std::string_view path, std::span<const std::byte> contents);
    Result<void> remove(std::string_view path);

    /// The native save folder, empty without an identity or a place for it.
    const std::string& save_folder() const { return save_folder_; }

  private:
    friend class PlayedSaves;

    explicit Files(const FilesDef& def);
    /// What stands in for the save folder of a path; null: nothing does.
    PlayedSaves* played(std::string_view path) const;
    Result<void> open_save_folder();
    /// "save" before the first write: an empty folder to whoever looks.
    bool is_unmade_save_folder(std::string_view path) const;

    /// Of was_asked_for; more files than that is more than anybody edits, and all of them then count.
    static constexpr std::size_t kMostNoted = 65'536;
    void note(std::string_view path) const;

    mutable std::set<std::string, std::less<>> asked_for_;  ///< files and folders
    std::string save_folder_;
    std::string no_save_folder_;  ///< why there is none
    std::uint64_t max_file_bytes_;
    bool save_mounted_ = false;
    std::vector<PlayedSaves*> played_;  ///< those that live, the one that is used last
};

/// The rule about virtual paths, as used by every function of Files; the error names the path and the rule.
Result<void> check_virtual_path(std::string_view path);

}  // namespace cairn::engine
