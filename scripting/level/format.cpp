// One constant per field that only levels have.
#include "level/format.h"

#include <algorithm>
#include <set>

#include "bind/camera_object.h"
#include "bind/joint_fields.h"
#include "bind/modules.h"
#include "bind/physics_fields.h"

namespace cairn::scripting {
namespace {

constexpr Field kName = optional_field(
    level_fields::kName, FieldType::String,
    "by which scripts and joints find it; no two parts have the same; letters, digits, `_` and `-`");
constexpr Field kPartName =
    required_field(level_fields::kName, FieldType::String, "by which scripts find it");
constexpr Field kTemplate = optional_field(level_fields::kTemplate, FieldType::String,
                                           "one of `templates`: what is not said here is as there");
constexpr Field kMaterial =
    optional_field(level_fields::kMaterial, FieldType::String,
                   "one of `materials`: what is not said here is as there; becomes `data.material` too");
constexpr Field kShape =
    optional_field("shape", FieldType::String,
                   "of a body with one shape, whose fields stand beside it: \"box\", \"circle\", "
                   "\"capsule\", \"polygon\", \"segment\" or \"chain\"");
constexpr Field kShapeOfTrigger =
    required_field("shape", FieldType::String,
                   "\"box\", \"circle\", \"capsule\" or \"polygon\", with the fields of that shape");
constexpr Field kShapes =
    optional_field(level_fields::kShapes, FieldType::Table,
                   "of a body with several: a list of at least one; each has `shape`, the fields of "
                   "that shape, `x`, `y`, `angle` in the body, "
                   "and `material`");
constexpr Field kJoint = required_field("joint", FieldType::String, "the kind: \"revolute\", \"weld\", ...");
constexpr Field kPrefab = required_field("prefab", FieldType::String, "the kind: \"rope\", \"vehicle\", ...");

constexpr const Field* kBodyOwn[] = {&kName, &kTemplate, &kShape, &kShapes, &kMaterial};
constexpr const Field* kTriggerOwn[] = {&kPartName, &kShapeOfTrigger};
constexpr const Field* kPrefabOwn[] = {&kName, &kPrefab};
constexpr const Field* kJointOwn[] = {&kName, &kJoint};
constexpr const Field* kShapeOwn[] = {&kShape, &kMaterial};
constexpr FieldSet kBodyOwnFields{kBodyOwn};
constexpr FieldSet kTriggerOwnFields{kTriggerOwn};
constexpr FieldSet kPrefabOwnFields{kPrefabOwn};
constexpr FieldSet kJointOwnFields{kJointOwn};

// ---- The level itself
constexpr Field kLevelName = optional_field("name", FieldType::String, "what players call it");
constexpr Field kGravityX =
    optional_field("gravity_x", FieldType::Number, "m/s^2; absent: as the world has it");
constexpr Field kGravityY = optional_field("gravity_y", FieldType::Number, "m/s^2");
constexpr Field kIncludes =
    optional_field("includes", FieldType::Table,
                   "a list of files, from the game's folder: their `materials` and `templates` can be used");
constexpr Field kMaterials = optional_field("materials", FieldType::Table, "name -> material");
constexpr Field kTemplates =
    optional_field("templates", FieldType::Table, "name -> the fields that bodies of this template have");
constexpr Field kBodies = optional_field("bodies", FieldType::Table, "list");
constexpr Field kTriggers = optional_field("triggers", FieldType::Table, "list of places that notice bodies");
constexpr Field kPrefabs = optional_field("prefabs", FieldType::Table, "list");
constexpr Field kJoints = optional_field("joints", FieldType::Table, "list");
constexpr Field kSpawns = optional_field("spawns", FieldType::Table, "list of named places");
constexpr Field kDecorations = optional_field("decorations", FieldType::Table, "list of images");
constexpr Field kCamera = optional_field("camera", FieldType::Table, "where to look at first");
constexpr Field kBounds = optional_field("bounds", FieldType::Table, "what the camera or the game keeps to");
constexpr Field kData = optional_field("data", FieldType::Table, "whatever the game wants to know");
constexpr const Field* kLevelOwn[] = {&kLevelName, &kGravityX,    &kGravityY, &kIncludes, &kMaterials,
                                      &kTemplates, &kBodies,      &kTriggers, &kPrefabs,  &kJoints,
                                      &kSpawns,    &kDecorations, &kCamera,   &kBounds,   &kData};

constexpr Field place_field(const char* name, const char* doc = "m") {
    return within(required_field(name, FieldType::Number, doc), -physics::kFarthest_m, physics::kFarthest_m);
}
constexpr Field kX = place_field("x");
constexpr Field kY = place_field("y");
constexpr Field kAngle = number_field("angle", 0, "0", "rad");
constexpr Field kHeight =
    within(required_field("height", FieldType::Number, "m, of what the picture shows; 1e-6 to 1e9"),
           kLeastViewHeight_m, kMostViewHeight_m);
constexpr const Field* kCameraOwn[] = {&kX, &kY, &kHeight};

constexpr Field kLeft = place_field("left");
constexpr Field kBottom = place_field("bottom");
constexpr Field kRight = place_field("right", "m, above `left`");
constexpr Field kTop = place_field("top", "m, above `bottom`");
constexpr const Field* kBoundsOwn[] = {&kLeft, &kBottom, &kRight, &kTop};

constexpr Field kSpawnData = optional_field("data", FieldType::Table, "whatever the game wants to know");
constexpr const Field* kSpawnOwn[] = {&kPartName, &kX, &kY, &kAngle, &kSpawnData};

constexpr Field kImage = required_field("image", FieldType::String, "its file, from the game's folder");
constexpr Field kImageWidth = above(required_field("width", FieldType::Number, "m"), 0);
constexpr Field kImageHeight =
    above(optional_field("height", FieldType::Number, "m; absent: as the image is wide and high"), 0);
constexpr Field kLayer =
    choice_field("layer", "back", "back front", "\"back\" or \"front\": which call of `level:draw` shows it");
constexpr Field kOpacity = within(number_field("opacity", 1, "1", "0 to 1"), 0, 1);
constexpr const Field* kDecorationOwn[] = {&kImage,      &kX,           &kY,     &kAngle,
                                           &kImageWidth, &kImageHeight, &kLayer, &kOpacity};

// A trigger has a place, a geometry, and says whom it notices.
constexpr Field kTriggerData = optional_field("data", FieldType::Table, "becomes body.data");
constexpr const Field* kTriggerDataOwn[] = {&kTriggerData};

std::vector<const Field*> joined_fields(std::initializer_list<const FieldSet*> sets) {
    std::vector<const Field*> fields;
    for (const FieldSet* set : sets) {
        for (const Field* field : all_fields(*set)) {
            const bool is_known = std::any_of(fields.begin(), fields.end(), [&](const Field* known) {
                return std::string_view(known->name) == field->name;
            });
            if (!is_known) fields.push_back(field);
        }
    }
    return fields;
}

int index_in(const std::vector<std::string>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

}  // namespace

const PartSection kPartSections[kPartKinds] = {
    {"bodies", "body", "shape", &kBodyOwnFields},
    {"triggers", "trigger", "shape", &kTriggerOwnFields},
    {"prefabs", "prefab", "prefab", &kPrefabOwnFields},
    {"joints", "joint", "joint", &kJointOwnFields},
};

const FieldSet kLevelFields{kLevelOwn};
const FieldSet kCameraFields{kCameraOwn};
const FieldSet kBoundsFields{kBoundsOwn};
const FieldSet kSpawnFields{kSpawnOwn};
const FieldSet kDecorationFields{kDecorationOwn};
const FieldSet kLevelMaterialFields{{}, {&kMatterFields}};

const std::vector<std::string>& variants_of(PartKind kind) {
    static const std::vector<std::string> lists[kPartKinds] = {
        {"box", "circle", "capsule", "polygon", "segment", "chain"},
        {"box", "circle", "capsule", "polygon"},
        [] {
            std::vector<std::string> names;
            for (const Function& maker : kPrefabModule.functions) names.emplace_back(maker.name);
            return names;
        }(),
        [] {
            std::vector<std::string> names;
            for (const JointKindFields& joint : kJointKinds) names.emplace_back(joint.name);
            return names;
        }(),
    };
    return lists[static_cast<int>(kind)];
}

std::vector<const Field*> part_fields(PartKind kind, std::string_view variant) {
    const FieldSet* own = section_of(kind).own;
    const int index = index_in(variants_of(kind), variant);
    if (index < 0) return joined_fields({own, &kNewBodyFields});
    switch (kind) {
        case PartKind::Body:
            if (index < kGeometryKinds) return joined_fields({own, &kWorldAddFields[index]});
            return joined_fields({own, &kWorldAddChainFields});
        case PartKind::Trigger: {
            static constexpr FieldSet kDataFields{kTriggerDataOwn};
            return joined_fields({own, &kPlaceFields, &kGeometryFields[index], &kFilterFields, &kDataFields});
        }
        case PartKind::Prefab: {
            const FieldSet* made = kPrefabModule.functions[static_cast<std::size_t>(index)].fields;
            static constexpr const Field* kMaterialOwn[] = {&kMaterial};
            static constexpr FieldSet kOneOfMaterials{kMaterialOwn};
            const std::vector<const Field*> fields = all_fields(*made);
            const bool takes_material = std::any_of(fields.begin(), fields.end(), [](const Field* field) {
                return std::string_view(field->name) == level_fields::kMaterial;
            });
            // The level's own materials, and not those of scripts.
            return takes_material ? joined_fields({own, &kOneOfMaterials, made}) : joined_fields({own, made});
        }
        case PartKind::Joint:
            return joined_fields({own, &kJointKinds[index].making});
    }
    return {};
}

std::vector<const Field*> undisputed_fields(PartKind kind) {
    const auto agree = [](const Field& a, const Field& b) {
        return a.type == b.type && a.range == b.range && a.choices == b.choices;
    };
    std::vector<const Field*> fields;
    std::set<std::string_view> disputed;
    for (const std::string& variant : variants_of(kind)) {
        for (const Field* field : part_fields(kind, variant)) {
            const auto known = std::find_if(fields.begin(), fields.end(), [&](const Field* f) {
                return std::string_view(f->name) == field->name;
            });
            if (known == fields.end()) {
                fields.push_back(field);
            } else if (!agree(**known, *field)) {
                disputed.insert(field->name);
            }
        }
    }
    std::erase_if(fields, [&](const Field* field) { return disputed.contains(field->name); });
    return fields;
}

std::vector<const Field*> shape_fields(std::string_view variant) {
    static constexpr FieldSet kOwn{kShapeOwn};
    const int index = index_in(variants_of(PartKind::Body), variant);
    if (index >= 0 && index < kGeometryKinds) return joined_fields({&kOwn, &kBodyAddFields[index]});
    return joined_fields({&kOwn, &kBodyAddChainFields});
}

std::vector<const Field*> outline_fields(std::string_view variant) {
    const int index = index_in(variants_of(PartKind::Body), variant);
    return all_fields(index >= 0 && index < kGeometryKinds ? kGeometryFields[index] : kChainOutlineFields);
}

std::vector<const Field*> fields_of_any_body() {
    return joined_fields({&kBodyOwnFields, &kWorldAddFields[0], &kWorldAddFields[1], &kWorldAddFields[2],
                          &kWorldAddFields[3], &kWorldAddFields[4], &kWorldAddChainFields});
}

}  // namespace cairn::scripting
