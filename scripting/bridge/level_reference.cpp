// Writes the format of levels from the descriptions by which levels are read and checked.
#include <cairn/scripting/reference.h>

#include "bind/joint_fields.h"
#include "bind/modules.h"
#include "bind/physics_fields.h"
#include "bridge/field_table.h"
#include "level/format.h"

namespace cairn::scripting {
namespace {

constexpr const char* kPreamble = R"(# The format of levels

A level is a file of Lua table text that says what stands where. It is read as data and nothing in it is ever run: numbers,
texts in quotes, `true`, `false`, tables and comments, no names, no calls, no sums. `cairn.level.load "levels/one.lua"` reads it,
`level:build(world)` makes what it says, `cairn check GAME` examines every file below `levels/`, whatever its ending (but for
assets, `.md`, `.txt` and what Tiled keeps beside its maps), and tells all faults, each with
file, line, column, the path of the field, the value and the rule:

    levels/one.lua:14:30: bodies[3].radius = -1: must be above 0 and at most 1000000
    levels/one.lua:15:22: bodies[4].template = "crat": no such template; did you mean "crate"? (crate, plank)

<!-- from: docs/examples/levels/yard.lua -->
```lua
return {
    name = "The yard",
    gravity_y = -10,
    camera = { x = 0, y = 4, height = 12 },

    materials = {
        wood = { density = 0.7, friction = 0.6 },
        ice = { density = 0.9, friction = 0.03 },
    },
    templates = {
        crate = { shape = "box", width = 1, height = 1, material = "wood", data = { kind = "crate" } },
    },

    bodies = {
        -- Ground: a chain runs from right to left.
        { name = "ground", type = "static", shape = "chain", points = { { 30, 0 }, { 0, 0 }, { -30, 3 } } },
        { template = "crate", x = 2, y = 0.5 },
        { template = "crate", x = 2, y = 1.5, material = "ice" },
        { name = "hammer", x = 6, y = 3, shapes = {
            { shape = "box", width = 2, height = 0.2 },
            { shape = "circle", x = 1, radius = 0.4, density = 4 },
        } },
    },
    prefabs = {
        { name = "bridge", prefab = "bridge", x = 8, y = 2, to_x = 14, to_y = 2 },
    },
    joints = {
        -- Without body_a it holds to the world; "bridge.3" is the third body of a prefab.
        { name = "hinge", joint = "revolute", body_b = "hammer", x = 5, y = 3 },
    },
    triggers = {
        { name = "goal", shape = "box", x = 16, y = 1, width = 2, height = 2 },
    },
    spawns = {
        { name = "player", x = -3, y = 2 },
    },
    data = { stars = { 10, 20, 30 } },
}
```

What is made is what a script would make with the same fields: `world:add_box{...}`, `world:add_revolute_joint{...}`,
`cairn.prefab.rope(world, {...})`. In the world it has the order of the file: bodies, triggers, prefabs, joints. A body's `data`
gets `name` and `material`, unless it says them itself.
A field of the type Body or Joint holds the name of one; `"bridge.3"` is the third body of a prefab that stands before. A level has
at most 100000 bodies.
)";

constexpr const char* kTiled = R"(
## Maps of Tiled

`cairn.level.load "levels/one.tmx"` reads a map of the editor Tiled as a level; `cairn.tilemap` draws it. One tile is one metre
wide unless `scale` says otherwise; the map's bottom left is (0, 0), y points up.

- **Tiles** are solid when their layer or the tile has the property `solid` = true. Each layer with some becomes a static body of
  chains along their outlines, on which nothing feels the joins between tiles; properties of the layer such as `friction`
  are those of the chains, `data.layer` is its name.
- **Objects** without a class, or with the class `body`, become bodies, static unless the property `type` says otherwise:
  rectangles, ellipses (those that are no circles as eight corners), polygons (as a chain when they are not convex or have more
  than eight corners), lines (as a chain that is solid from above). Properties that are fields of bodies are such; the
  others become `data`. A tile that is placed as an object becomes a box of its size with the class `body`, and is a picture alone
  without a class; a text or a point of class `body` is a fault.
- The **class** `trigger` makes a trigger, `spawn` a spawn, `camera` and `bounds` those of the level. `joint` and `prefab` make
  these at the object's place, with the properties as fields. Any other class is the name of a template.
- **Properties of the map**: `name`, `gravity_x`, `gravity_y`; `includes` names a file with materials and templates; the others become
  the level's `data`.

Faults have the line of the object in the file, what the object and its layer are called in the editor, and the value in the unit
that it has there; all that is wrong with a map, as a map and as a level, is told at once:

    levels/one.tmx:12: object 3 "crate" in layer "things": width = -16 pixels: must be above 0 and at most 32000000 pixels
    levels/one.tmx:13: object 4 in layer "things": class = "triger": no such class or template; did you mean "trigger"? (...)
    levels/one.tmx:14: object 5 "ball" in layer "things": x is "nan", but must be a number
)";

/// Without those that stand in `known`.
std::vector<const Field*> without(std::vector<const Field*> fields, const FieldSet& known) {
    const std::vector<const Field*> left_out = all_fields(known);
    std::erase_if(fields, [&](const Field* field) {
        for (const Field* other : left_out) {
            if (std::string_view(other->name) == field->name) return true;
        }
        return false;
    });
    return fields;
}

void add(std::string& out, const std::string& heading, const std::string& text,
         std::span<const Field* const> fields) {
    out += '\n' + heading + '\n';
    if (!text.empty()) out += '\n' + text + '\n';
    if (!fields.empty()) out += field_table(fields);
}

void add(std::string& out, const std::string& heading, const std::string& text, const FieldSet& set) {
    add(out, heading, text, all_fields(set));
}

}  // namespace

std::string level_reference_markdown() {
    std::string out = kPreamble;
    add(out, "## The level", "Every field may be left out.", kLevelFields);
    add(out, "### materials",
        "A level knows those of its file and of the files that it includes, and no script is asked; scripts "
        "give "
        "names to theirs with `cairn.physics.define_material`, whose fields are the same.",
        kLevelMaterialFields);
    add(out, "### camera", "", kCameraFields);
    add(out, "### bounds", "", kBoundsFields);
    add(out, "### spawns", "", kSpawnFields);
    add(out, "### decorations", "Drawn by `level:draw(layer)`.", kDecorationFields);

    add(out, "## bodies",
        "With one shape, its fields stand beside those of the body; with several, in `shapes`.",
        *section_of(PartKind::Body).own);
    add(out, "### Of every body", "", kNewBodyFields);
    add(out, "### Of every shape but chains", "", without(all_fields(kShapeFields), kMaterialNameFields));
    for (int kind = 0; kind < kGeometryKinds; ++kind)
        add(out, std::string("### `shape = \"") + kGeometryNames[kind] + "\"`", "", kGeometryFields[kind]);
    add(out, "### `shape = \"chain\"`",
        "Instead of the fields of every shape:", without(all_fields(kChainShapeFields), kMaterialNameFields));

    add(out, "## triggers",
        "Places that notice bodies: `world:sensor_events()` tells who comes and goes, and "
        "`level:trigger(name)` is the "
        "body to compare with. Besides these fields they have those of their shape.",
        without(part_fields(PartKind::Trigger, "box"), kGeometryFields[0]));

    add(out, "## prefabs", "", *section_of(PartKind::Prefab).own);
    for (const Function& maker : kPrefabModule.functions)
        add(out, std::string("### `prefab = \"") + maker.name + "\"`", maker.doc,
            without(part_fields(PartKind::Prefab, maker.name), *section_of(PartKind::Prefab).own));

    add(out, "## joints", "`body_a` may be left out: the world.", *section_of(PartKind::Joint).own);
    for (const JointKindFields& joint : kJointKinds)
        add(out, std::string("### `joint = \"") + joint.name + "\"`", "", joint.making);
    return out + kTiled;
}

}  // namespace cairn::scripting
