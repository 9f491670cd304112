// What maps and their tile sets have in common, and the reading of a tile set, which stands in a map or in a
// file of its own. Invariant: what is wrong is told with its place; one fault ends the reading of its part
// alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/tile_map.h>

#include "assets/tiled_node.h"

namespace cairn::engine {

/// Reads parts one by one and keeps what is wrong with each.
class FaultList {
  public:
    explicit FaultList(std::string prefix) : prefix_(std::move(prefix)) {}

    /// Whether the part was without a fault.
    template <class Part>
    bool attempt(Part&& read) {
        try {
            read();
            return true;
        } catch (const Fault& fault) {
            faults_.push_back(prefix_ + fault.message);
            return false;
        }
    }
    [[nodiscard]] std::size_t count() const { return faults_.size(); }
    std::vector<std::string> take() { return std::move(faults_); }
    /// Of a file that the file names.
    void add(std::vector<std::string> faults) {
        for (std::string& fault : faults) faults_.push_back(prefix_ + std::move(fault));
    }

  private:
    std::string prefix_;
    std::vector<std::string> faults_;
};

/// The path of what a file names, which is relative to that file; "a/../b" is written as "b".
std::string tiled_path_beside(std::string_view path, const std::string& name);

/// A file of the editor, in XML or JSON, as JSON; throws its Fault.
Json read_tiled_file(const Files& files, std::string_view path);

TileProperties read_tiled_properties(const Node& node);

/// "#rrggbb" or "#aarrggbb", with or without its "#".
std::optional<Color> read_tiled_color(const Node& node, const char* field);

/// `path` is the file that the node is of.
TileSet read_tile_set(const Node& node, std::uint32_t first_id, std::string_view path, FaultList& faults);

}  // namespace cairn::engine
