// The files of a level, and the materials and templates that stand in them. Invariant: what a layer points at
// stays where it is as long as the definitions live.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <cairn/engine/files.h>

#include "level/check.h"
#include "level/reader.h"

namespace cairn::scripting {

class LevelDefinitions {
  public:
    LevelDefinitions(const engine::Files& files, const TiledImport& import, LevelChecker& check)
        : files_(files), import_(import), check_(check) {}

    /// Reads a level's file, which must stay where it is, and those that it includes, whose paths are added
    /// to `paths`. False when the level itself cannot be read.
    bool read(const std::string& path, Value& level, std::vector<std::string>& paths);

    [[nodiscard]] const std::map<std::string, Layer>& materials() const { return materials_; }
    [[nodiscard]] const std::map<std::string, Layer>& templates() const { return templates_; }
    /// Whether a file with some of them could not be read, which is told: then a name that is unknown may be
    /// one of these.
    [[nodiscard]] bool are_incomplete() const { return lacks_definitions_; }

    static std::vector<std::string> names_of(const std::map<std::string, Layer>& map);

  private:
    bool read_table(const std::string& path, Value& out);
    /// The materials and templates of a file.
    void read_definitions(const Layer& root);
    template <class Function>
    void for_each_named(const Layer& root, const char* section, Function&& function);
    void read_includes(const Layer& root);
    /// Whether its materials and templates are known now.
    bool read_include(const Layer& root, const Value& file, const std::string& path);
    void check_template(const Layer& layer);
    void check_material(const Layer& layer);

    const engine::Files& files_;
    TiledImport import_;
    LevelChecker& check_;
    std::vector<std::string> paths_;
    std::vector<Value> included_;
    std::map<std::string, Layer> materials_;
    std::map<std::string, Layer> templates_;
    std::vector<Layer> new_templates_;
    bool lacks_definitions_ = false;
};

}  // namespace cairn::scripting
