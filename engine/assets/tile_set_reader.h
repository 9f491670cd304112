// What maps and their tile sets have in common, and the reading of a tile set, which stands in a map or in a
// file of its own. Invariant: what is wrong is told with its place; one fault ends the reading of its part
// alone.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/tile_map.h>

#include "assets/tiled_node.h"

namespace cairn::engine {

/// Reads parts one by one and keeps what is wrong with each, as "FILE:LINE: PLACE is VALUE, but RULE".
class FaultList {
  public:
    explicit FaultList(std::string file) : file_(std::move(file)) {}

    /// Whether the part was without a fault.
    template <class Part>
    bool attempt(Part&& read) {
        try {
            read();
            return true;
        } catch (const Fault& fault) {
            // That a file cannot be read names it already.
            const bool names_file = fault.message.starts_with("file '" + file_);
            faults_.push_back((names_file ? "" : start(fault.line)) + fault.message);
            return false;
        }
    }
    /// "maps/one.tmx:12: ".
    [[nodiscard]] std::string start(int line) const {
        return file_ + (line > 0 ? ':' + std::to_string(line) : "") + ": ";
    }
    [[nodiscard]] std::size_t count() const { return faults_.size(); }
    std::vector<std::string> take() { return std::move(faults_); }
    /// Of a file that the file names.
    void add(const std::string& before, std::vector<std::string> faults) {
        for (const std::string& fault : faults) faults_.push_back(before + fault);
    }

  private:
    std::string file_;
    std::vector<std::string> faults_;
};

/// The path of what a file names, which is relative to that file; "a/../b" is written as "b".
std::string tiled_path_beside(std::string_view path, const std::string& name);

/// A file of the editor, in XML or JSON, as JSON; throws its Fault.
Json read_tiled_file(const Files& files, std::string_view path);

using Names = std::set<std::string, std::less<>>;

/// Those that are good; the others are told, and added to `unreadable` as "property NAME".
TileProperties read_tiled_properties(const Node& node, FaultList& faults, Names& unreadable);

/// The node called `WHAT 3 "name" WHERE`, with what it has of an id and a name; without both as it was.
Node called_by_name(const Node& node, const std::string& what, const std::string& where = "");

/// "#rrggbb" or "#aarrggbb", with or without its "#".
std::optional<Color> read_tiled_color(const Node& node, const char* field);

/// `path` is the file that the node is of; what the node is called is the set's place.
TileSet read_tile_set(const Node& node, std::uint32_t first_id, std::string_view path, FaultList& faults);

}  // namespace cairn::engine
