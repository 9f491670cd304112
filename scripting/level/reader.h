// Reads a level file: from text to parts in which templates and materials have been filled in. Invariant:
// nothing is executed; every fault of the file is found, not only the first; a level with faults is for
// finding more of them, and for nothing else.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <cairn/engine/files.h>

#include "data/value.h"
#include "level/format.h"

namespace cairn::scripting {

/// One of a body's several shapes.
struct ShapePart {
    std::string variant;
    Value fields;
    std::string place;  ///< "levels/one.lua:12:5: bodies[3].shapes[1]": for messages
};

/// A field that names another part of the level.
struct PartReference {
    std::string field;
    std::string name;   ///< "crate", or "rope.3": the third body of a prefab
    std::string place;  ///< `levels/one.lua:12:30: joints[1].body_b = "crate": `, for messages
};

/// What a level makes in a world.
struct LevelPart {
    PartKind kind = PartKind::Body;
    std::string name;     ///< empty: none
    std::string variant;  ///< "box", "revolute", "rope"; empty: a body with `shapes`
    Value fields;         ///< as the function of the Lua API takes them, but for references
    std::vector<ShapePart> shapes;
    /// The forms alone of shapes that have faults elsewhere: what of these can still be tried out.
    std::vector<ShapePart> outlines;
    std::vector<PartReference> references;
    std::string place;       ///< "levels/one.lua:12:5: bodies[3]": for messages
    std::string path;        ///< "bodies[3]"
    bool is_faulty = false;  ///< it cannot be tried out as it is
    /// Those whose values are faulty: what does not depend on them can still be tried out.
    std::vector<const Field*> faulty_fields;
    bool lacks_fields = false;      ///< that it must have
    bool has_faulty_shape = false;  ///< of `shapes`, which then lacks it
};

struct Level {
    std::string path;
    std::string name;
    std::vector<std::string> files;  ///< the level's own and those that it includes
    std::optional<double> gravity_x;
    std::optional<double> gravity_y;
    std::vector<LevelPart>
        parts;    ///< bodies, triggers, prefabs, joints; of each kind in the order of the file
    Value table;  ///< all of the file as it stands, for the rest: spawns, camera, data, ...

    /// The section of that name in the table, or null.
    [[nodiscard]] const Value* section(std::string_view wanted) const { return table.find(wanted); }
    /// The part of that name, or nothing.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view wanted) const;
    [[nodiscard]] std::optional<std::size_t> find(PartKind kind, std::string_view wanted) const;
    /// Of the parts of a kind that have one.
    [[nodiscard]] std::vector<std::string> names(PartKind kind) const;
};

struct LevelReading {
    Level level;
    /// Empty: the level is good, as far as can be told without building it. Else its parts that are not
    /// faulty can still be tried out.
    std::vector<std::string> faults;
};

/// How a map of Tiled becomes a level.
struct TiledImport {
    double scale = 0;  ///< metres per pixel; 0: one tile is one metre wide
};

/// A level file, or a map of Tiled (.tmx, .tmj, .json).
LevelReading read_level(const engine::Files& files, const std::string& path, const TiledImport& import = {});

/// Whether a file is one of Tiled's, by its name.
bool is_tiled_file(std::string_view path);

/// "rope.3" as "rope" and 3; without a number 0.
struct PartName {
    std::string name;
    int index = 0;
};
PartName split_part_name(const std::string& name);

/// Equal texts, equal parts: what live reload compares.
std::string signature_of(const LevelPart& part);

}  // namespace cairn::scripting
