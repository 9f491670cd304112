// Folders are not kept: a folder is there as long as a file's path leads through it, as each was made by a
// write.
#include <cairn/engine/files.h>
#include <cairn/engine/played_saves.h>

namespace cairn::engine {
namespace {

constexpr std::string_view kRoot = "save";

Error path_error(std::string_view path, const std::string& reason) {
    return {"file '" + std::string(path) + "': " + reason};
}

std::string as_prefix(std::string_view folder) {
    return std::string(folder) + '/';
}

}  // namespace

PlayedSaves::PlayedSaves(Files& files) : owner_(files) {
    owner_.played_.push_back(this);
}

PlayedSaves::~PlayedSaves() {
    std::erase(owner_.played_, this);
}

bool PlayedSaves::covers(std::string_view path) {
    return path == kRoot || path.starts_with("save/");
}

bool PlayedSaves::is_folder(std::string_view path) const {
    if (path == kRoot) return true;
    const std::string prefix = as_prefix(path);
    const auto first = files_.lower_bound(prefix);
    return first != files_.end() && first->first.starts_with(prefix);
}

Result<std::string> PlayedSaves::read(std::string_view path) const {
    if (const auto found = files_.find(path); found != files_.end()) return found->second;
    return path_error(path, is_folder(path) ? "is a folder" : "not found");
}

Result<void> PlayedSaves::write(std::string_view path, std::string_view text) {
    if (is_folder(path)) return path_error(path, "is a folder");
    for (std::size_t slash = path.find('/'); slash != std::string_view::npos;
         slash = path.find('/', slash + 1)) {
        const std::string_view above = path.substr(0, slash);
        if (files_.contains(above))
            return path_error(path, "'" + std::string(above) + "' is a file, not a folder");
    }
    const auto old = files_.find(path);
    const std::size_t before = old == files_.end() ? 0 : path.size() + old->second.size();
    const std::size_t after = bytes_ - before + path.size() + text.size();
    if (after > kMaxBytes)
        return path_error(path, "the save folder would hold " + std::to_string(after) +
                                    " bytes; a run that keeps it in memory may have at most " +
                                    std::to_string(kMaxBytes));
    files_.insert_or_assign(std::string(path), std::string(text));
    bytes_ = after;
    return {};
}

Result<void> PlayedSaves::remove(std::string_view path) {
    const auto found = files_.find(path);
    if (found == files_.end()) return path_error(path, is_folder(path) ? "is a folder" : "not found");
    bytes_ -= found->first.size() + found->second.size();
    files_.erase(found);
    return {};
}

bool PlayedSaves::exists(std::string_view path) const {
    return files_.contains(path) || is_folder(path);
}

Result<std::vector<std::string>> PlayedSaves::list(std::string_view folder) const {
    if (!is_folder(folder))
        return path_error(folder, files_.contains(folder) ? "is not a folder" : "not found");
    std::vector<std::string> names;
    const std::string prefix = as_prefix(folder);
    for (auto file = files_.lower_bound(prefix); file != files_.end() && file->first.starts_with(prefix);
         ++file) {
        const std::string_view below = std::string_view(file->first).substr(prefix.size());
        const std::string_view name = below.substr(0, below.find('/'));
        if (names.empty() || names.back() != name) names.emplace_back(name);
    }
    return names;
}

}  // namespace cairn::engine
