// Virtual files on top of PhysFS. Invariant: every path is checked by check_virtual_path before PhysFS sees
// it, and writing goes through PhysFS into the save folder, so that its refusal of symbolic links covers both
// directions.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <physfs.h>
#include <system_error>
#include <utility>

#include <cairn/engine/files.h>
#include <cairn/engine/played_saves.h>

namespace cairn::engine {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSaveMount = "save";

std::string physfs_reason() {
    const char* text = PHYSFS_getErrorByCode(PHYSFS_getLastErrorCode());
    return text ? text : "unknown reason";
}

Error path_error(std::string_view path, std::string_view reason) {
    return Error{"file '" + std::string(path) + "': " + std::string(reason)};
}

Result<std::string> default_save_root() {
#ifdef __linux__
    if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data == '/')
        return std::string(data) + "/cairn";
    if (const char* home = std::getenv("HOME"); home && *home == '/')
        return std::string(home) + "/.local/share/cairn";
    return Error{"no place for the save folder: neither XDG_DATA_HOME nor HOME is an absolute path"};
#else
    if (const char* folder = PHYSFS_getPrefDir("cairn", "cairn")) return std::string(folder);
    return Error{"no place for the save folder: " + physfs_reason()};
#endif
}

/// What is below "save/" in a path that may be written.
Result<std::string> save_relative(std::string_view path) {
    if (auto valid = check_virtual_path(path); !valid) return valid.error();
    if (path.starts_with(kSaveMount) && path.size() > kSaveMount.size() + 1 && path[kSaveMount.size()] == '/')
        return std::string(path.substr(kSaveMount.size() + 1));
    return path_error(path, "only files below 'save/' can be written or removed");
}

/// Beside the file, and no longer than a name may be.
std::string unfinished_name(const std::string& relative) {
    constexpr std::string_view kEnding = ".unfinished";
    const std::size_t start = relative.rfind('/') + 1;  // 0 without a folder
    return relative.substr(0, start + kMaxFileNameBytes - kEnding.size()).append(kEnding);
}

/// The folder or archive that provides a path, and the path inside it.
struct Origin {
    std::string root;
    std::string inner;
};

Result<Origin> find_origin(const std::string& path) {
    const char* root = PHYSFS_getRealDir(path.c_str());
    if (!root) return path_error(path, physfs_reason());
    // PhysFS gives "/" for the root and "folder/" for anything else.
    std::string_view mount_point = PHYSFS_getMountPoint(root);
    if (mount_point == "/") mount_point = "";
    return Origin{root, path.size() > mount_point.size() ? path.substr(mount_point.size()) : ""};
}

Result<PHYSFS_Stat> stat(std::string_view path) {
    if (auto valid = check_virtual_path(path); !valid) return valid.error();
    PHYSFS_Stat stat;
    if (!PHYSFS_stat(std::string(path).c_str(), &stat)) return path_error(path, physfs_reason());
    return stat;
}

/// Closes a PhysFS file whatever happens.
class OpenFile {
  public:
    explicit OpenFile(PHYSFS_File* file) : file_(file) {}
    ~OpenFile() {
        if (file_) PHYSFS_close(file_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    explicit operator bool() const { return file_ != nullptr; }
    PHYSFS_File* get() const { return file_; }
    /// Writing is only done when closing succeeds, because PhysFS may flush there.
    bool close() { return PHYSFS_close(std::exchange(file_, nullptr)) != 0; }

  private:
    PHYSFS_File* file_;
};

template <typename Buffer>
Result<Buffer> read_whole(std::string_view path, std::uint64_t max_bytes) {
    const Result<PHYSFS_Stat> info = stat(path);
    if (!info) return info.error();
    if (info->filetype == PHYSFS_FILETYPE_DIRECTORY) return path_error(path, "is a folder");
    if (info->filetype == PHYSFS_FILETYPE_SYMLINK) return path_error(path, "symbolic links are not followed");

    const OpenFile file(PHYSFS_openRead(std::string(path).c_str()));
    if (!file) return path_error(path, physfs_reason());
    const PHYSFS_sint64 size = PHYSFS_fileLength(file.get());
    if (size < 0) return path_error(path, "has no known length");
    if (static_cast<std::uint64_t>(size) > max_bytes)
        return path_error(path, "has " + std::to_string(size) + " bytes; at most " +
                                    std::to_string(max_bytes) + " are allowed");
    Buffer buffer(static_cast<std::size_t>(size), {});
    if (PHYSFS_readBytes(file.get(), buffer.data(), buffer.size()) != size)
        return path_error(path, physfs_reason());
    return buffer;
}

}  // namespace

bool is_save_identity(std::string_view identity) {
    const bool is_plain = std::all_of(identity.begin(), identity.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_' || c == '.';
    });
    return is_plain && !identity.starts_with('.') && identity.size() <= 64;
}

Result<std::unique_ptr<Files>> Files::create(const FilesDef& def) {
    if (PHYSFS_isInit()) return Error{"files: another Files object is alive; a process can have one"};
    if (!is_save_identity(def.identity))
        return Error{"identity '" + def.identity + "': " + std::string(kSaveIdentityRule)};
    if (!PHYSFS_init(def.program_path.empty() ? nullptr : def.program_path.c_str()))
        return Error{"files: PhysFS does not start: " + physfs_reason()};
    PHYSFS_permitSymbolicLinks(0);

    std::unique_ptr<Files> files(new Files(def));
    std::error_code ignored;
    if (!files->save_folder_.empty() && fs::is_directory(files->save_folder_, ignored))
        if (auto opened = files->open_save_folder(); !opened) return opened.error();
    return files;
}

Files::Files(const FilesDef& def) : max_file_bytes_(def.max_file_bytes) {
    if (def.identity.empty()) {
        no_save_folder_ = "this game has no save folder, because it has no identity";
        return;
    }
    const Result<std::string> root = def.save_root.empty() ? default_save_root() : Result(def.save_root);
    if (!root) {
        // Most runs never save: the first write says it.
        no_save_folder_ = root.error().message;
        return;
    }
    save_folder_ = (fs::absolute(*root) / def.identity).lexically_normal().string();
}

Files::~Files() {
    PHYSFS_deinit();
}

bool Files::is_unmade_save_folder(std::string_view path) const {
    return path == kSaveMount && !save_folder_.empty() && !save_mounted_;
}

Result<void> Files::open_save_folder() {
    std::error_code failure;
    fs::create_directories(save_folder_, failure);
    if (failure) return Error{"save folder '" + save_folder_ + "': " + failure.message()};
    if (!PHYSFS_setWriteDir(save_folder_.c_str()) ||
        !PHYSFS_mount(save_folder_.c_str(), std::string(kSaveMount).c_str(), /*appendToPath=*/0))
        return Error{"save folder '" + save_folder_ + "': " + physfs_reason()};
    save_mounted_ = true;
    return {};
}

Result<void> Files::mount(const std::string& native_path, std::string_view mount_point, MountOrder order) {
    if (auto valid = check_virtual_path(mount_point); !valid) return valid;
    const std::string point(mount_point);
    if (!PHYSFS_mount(native_path.c_str(), point.c_str(), order == MountOrder::Last ? 1 : 0))
        return Error{"cannot open '" + native_path + "' as a folder or an archive: " + physfs_reason()};
    return {};
}

Result<void> Files::unmount(const std::string& native_path) {
    if (!PHYSFS_unmount(native_path.c_str()))
        return Error{"cannot unmount '" + native_path + "': " + physfs_reason()};
    return {};
}

PlayedSaves* Files::played(std::string_view path) const {
    return !played_.empty() && check_virtual_path(path) && PlayedSaves::covers(path) ? played_.back()
                                                                                     : nullptr;
}

bool Files::exists(std::string_view path) const {
    return static_cast<bool>(kind(path));
}

void Files::note(std::string_view path) const {
    if (asked_for_.size() < kMostNoted && !asked_for_.contains(path)) asked_for_.emplace(path);
}

bool Files::was_asked_for(std::string_view path) const {
    const std::size_t slash = path.rfind('/');
    const std::string_view folder = slash == std::string_view::npos ? "" : path.substr(0, slash);
    return asked_for_.contains(path) || asked_for_.contains(folder) || asked_for_.size() >= kMostNoted;
}

Result<FileKind> Files::kind(std::string_view path) const {
    note(path);
    if (const PlayedSaves* saves = played(path)) {
        if (saves->is_folder(path)) return FileKind::Folder;
        if (saves->exists(path)) return FileKind::File;
        return path_error(path, "not found");
    }
    if (is_unmade_save_folder(path)) return FileKind::Folder;
    const Result<PHYSFS_Stat> info = stat(path);
    if (!info) return info.error();
    if (info->filetype == PHYSFS_FILETYPE_REGULAR) return FileKind::File;
    if (info->filetype == PHYSFS_FILETYPE_DIRECTORY) return FileKind::Folder;
    return path_error(path, "is neither a file nor a folder; symbolic links are not followed");
}

Result<std::string> Files::read_text(std::string_view path) const {
    note(path);
    if (const PlayedSaves* saves = played(path)) return saves->read(path);
    return read_whole<std::string>(path, max_file_bytes_);
}

Result<std::vector<std::byte>> Files::read_bytes(std::string_view path) const {
    note(path);
    if (const PlayedSaves* saves = played(path)) {
        const Result<std::string> text = saves->read(path);
        if (!text) return text.error();
        const auto bytes = std::as_bytes(std::span(*text));
        return std::vector<std::byte>(bytes.begin(), bytes.end());
    }
    return read_whole<std::vector<std::byte>>(path, max_file_bytes_);
}

Result<std::vector<std::string>> Files::list(std::string_view folder) const {
    if (const PlayedSaves* saves = played(folder)) {
        note(folder);
        return saves->list(folder);
    }
    const Result<FileKind> found = kind(folder);
    if (!found) return found.error();
    if (*found != FileKind::Folder) return path_error(folder, "is not a folder");
    if (is_unmade_save_folder(folder)) return std::vector<std::string>{};
    char** names = PHYSFS_enumerateFiles(std::string(folder).c_str());
    if (!names) return path_error(folder, physfs_reason());
    std::vector<std::string> sorted;
    for (char** name = names; *name; ++name) sorted.emplace_back(*name);
    PHYSFS_freeList(names);
    if (folder.empty() && !played_.empty()) {  // the root has the folder that is played, not the one on disk
        std::erase(sorted, kSaveMount);
        const auto saves = played_.back()->list(kSaveMount);
        if (saves && !saves->empty()) sorted.emplace_back(kSaveMount);
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

Result<std::int64_t> Files::modified_ns(std::string_view path) const {
    if (played(path) != nullptr) return path_error(path, "is kept in memory");
    const Result<PHYSFS_Stat> info = stat(path);
    if (!info) return info.error();
    // PhysFS counts whole seconds; an editor can save twice in one. The folder's own file system knows
    // better.
    if (const Result<Origin> origin = find_origin(std::string(path))) {
        std::error_code failure;
        const auto time = fs::last_write_time(fs::path(origin->root) / origin->inner, failure);
        if (!failure)
            return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
    }
    return info->modtime * 1'000'000'000;
}

Result<std::string> Files::native_path(std::string_view path) const {
    if (played(path) != nullptr) return path_error(path, "is kept in memory");
    const Result<PHYSFS_Stat> info = stat(path);
    if (!info) return info.error();
    const Result<Origin> origin = find_origin(std::string(path));
    if (!origin) return origin.error();
    return origin->inner.empty() ? origin->root : (fs::path(origin->root) / origin->inner).string();
}

Result<void> Files::write(std::string_view path, std::span<const std::byte> contents) {
    const Result<std::string> relative = save_relative(path);
    if (!relative) return relative.error();
    if (PlayedSaves* saves = played(path))
        return saves->write(path, {reinterpret_cast<const char*>(contents.data()), contents.size()});
    if (save_folder_.empty()) return path_error(path, no_save_folder_);
    if (!save_mounted_)
        if (auto opened = open_save_folder(); !opened) return opened;
    if (const std::size_t slash = relative->rfind('/'); slash != std::string::npos)
        if (!PHYSFS_mkdir(relative->substr(0, slash).c_str())) return path_error(path, physfs_reason());

    const std::string unfinished = unfinished_name(*relative);
    OpenFile file(PHYSFS_openWrite(unfinished.c_str()));
    if (!file) return path_error(path, physfs_reason());
    const PHYSFS_sint64 written = PHYSFS_writeBytes(file.get(), contents.data(), contents.size());
    // A part that fits is no error to PhysFS, whose last one is then about something else.
    const bool complete = written == static_cast<PHYSFS_sint64>(contents.size());
    std::string reason;
    if (written < 0) {
        reason = physfs_reason();
    } else if (!complete) {
        reason = "only " + std::to_string(written) + " of " + std::to_string(contents.size()) +
                 " bytes were written; is the disk full?";
    }
    if (!file.close() && complete) reason = physfs_reason();
    if (!reason.empty()) {
        PHYSFS_delete(unfinished.c_str());
        return path_error(path, reason);
    }
    std::error_code failure;
    fs::rename(fs::path(save_folder_) / unfinished, fs::path(save_folder_) / *relative, failure);
    if (failure) {
        PHYSFS_delete(unfinished.c_str());
        return path_error(path, failure.message());
    }
    return {};
}

Result<void> Files::write(std::string_view path, std::string_view contents) {
    return write(path, std::as_bytes(std::span(contents)));
}

Result<void> Files::remove(std::string_view path) {
    const Result<std::string> relative = save_relative(path);
    if (!relative) return relative.error();
    if (PlayedSaves* saves = played(path)) return saves->remove(path);
    if (!save_mounted_ || !PHYSFS_delete(relative->c_str()))
        return path_error(path, save_mounted_ ? physfs_reason() : "not found");
    return {};
}

}  // namespace cairn::engine
