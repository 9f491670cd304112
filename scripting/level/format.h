// The format of levels: which sections a file has, and which fields the entries of each. Bodies, joints and
// prefabs have the fields of `world:add_box` and its like, so that a level says what a script would; only
// what is the level's own is described here. Invariant: the reader, the validator and
// docs/reference/levels.md all come from these descriptions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bind/fields.h"

namespace cairn::scripting {

/// What a level makes in a world, in the order in which it is made.
enum class PartKind { Body, Trigger, Prefab, Joint };
inline constexpr int kPartKinds = 4;

struct PartSection {
    const char* list;     ///< "bodies": the field of the level
    const char* one;      ///< "body"
    const char* variant;  ///< "shape": the field that says of which variant an entry is
    const FieldSet* own;  ///< the fields that every entry may have besides those of its variant
};
/// By PartKind.
extern const PartSection kPartSections[kPartKinds];
constexpr const PartSection& section_of(PartKind kind) {
    return kPartSections[static_cast<int>(kind)];
}

/// "box", "chain", ...; "revolute", ...; "rope", ...
const std::vector<std::string>& variants_of(PartKind kind);

/// The fields of an entry of a variant, those of `section_of(kind).own` included. A body without a variant
/// has those of a body without shapes, and `shapes`.
std::vector<const Field*> part_fields(PartKind kind, std::string_view variant);
/// Those that mean the same for every variant that has them: of an entry whose variant is not known.
std::vector<const Field*> undisputed_fields(PartKind kind);
/// The fields of an entry of a body's `shapes`.
std::vector<const Field*> shape_fields(std::string_view variant);
/// Those of them that say what form it has.
std::vector<const Field*> outline_fields(std::string_view variant);
/// Every field that an entry of some variant may have: of templates that leave the variant open.
std::vector<const Field*> fields_of_any_body();

/// Of the level itself: name, gravity, and the names of the sections.
extern const FieldSet kLevelFields;
extern const FieldSet kCameraFields;
extern const FieldSet kBoundsFields;
extern const FieldSet kSpawnFields;
extern const FieldSet kDecorationFields;
/// Of one of `materials`.
extern const FieldSet kLevelMaterialFields;

/// Fields that the reader takes out of an entry itself.
namespace level_fields {
inline constexpr const char* kName = "name";
inline constexpr const char* kTemplate = "template";
inline constexpr const char* kMaterial = "material";
inline constexpr const char* kShapes = "shapes";
}  // namespace level_fields

}  // namespace cairn::scripting
