// A faulty part is tried out with other values in place of its faulty fields: the default, low ones, high
// ones. What goes wrong with all of them, in the same words, is wrong whatever they will be.
#include "bind/level_trial.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bind/level_parts.h"
#include "bind/modules.h"

namespace cairn::scripting {
namespace {

/// Whether one of the parts that a part names could not be made.
bool refers_to_unmade(const Level& level, std::size_t part, const std::vector<bool>& is_made) {
    const auto& references = level.parts[part].references;
    return std::any_of(references.begin(), references.end(), [&](const PartReference& reference) {
        const auto named = level.find(split_part_name(reference.name).name);
        return named && !is_made[*named];
    });
}

/// What is wrong with the forms of a part's faulty shapes, each tried out on a body of its own.
std::vector<std::string> faults_of_outlines(lua_State* L, const LevelPart& part, int world) {
    Level level;
    for (const ShapePart& outline : part.outlines) {
        LevelPart body;
        body.fields.content = Entries{};
        body.shapes = {outline};
        level.parts.push_back(std::move(body));
    }
    lua_newtable(L);
    std::vector<std::string> faults;
    for (std::size_t body = 0; body < level.parts.size(); ++body) {
        const std::vector<std::string> found = make_part(L, level, body, world, lua_gettop(L));
        faults.insert(faults.end(), found.begin(), found.end());
    }
    lua_pop(L, 1);
    return faults;
}

/// Makes a world for trying out; pushed.
void push_scratch_world(lua_State* L) {
    push_function(L, kPhysicsModule, "new_world");
    lua_newtable(L);
    lua_call(L, 1, 1);
}

/// Far more than a level needs; prefabs could make so many that there is no memory for them.
constexpr lua_Integer kMaxBodies = 100'000;

lua_Integer count_bodies(lua_State* L, int world) {
    push_function(L, kWorldMethods, "body_count");
    lua_pushvalue(L, world);
    lua_call(L, 1, 1);
    const lua_Integer count = lua_tointeger(L, -1);
    lua_pop(L, 1);
    return count;
}

// ---- Faulty parts

constexpr int kTrialValues = 3;

/// Something that a field might have been; nothing: leave it out.
std::optional<Value> trial_value(const Field& field, int which) {
    const bool is_integer = field.type == FieldType::Integer;
    if (which == 0 || (field.type != FieldType::Number && !is_integer)) return std::nullopt;
    // Counts stay small, for all of them are made.
    const double reach = is_integer ? 16 : 1000;
    const double size = std::max(1.0, std::abs(field.default_number));
    const Range& range = field.range;
    double number = 0;
    if (which == 1) {
        number = !range.has_low() ? -reach * size : range.excludes_low ? range.low + size / reach : range.low;
    } else {
        number = range.has_low() ? range.low + reach * size : reach * size;
        if (range.has_high()) number = std::min(number, range.high);
    }
    Value value;
    if (is_integer)
        value.content = static_cast<std::int64_t>(number);
    else
        value.content = number;
    return value;
}

/// The part with other values in its faulty fields. `choice` has a digit for each, in base kTrialValues.
LevelPart with_other_values(const LevelPart& part, int choice) {
    LevelPart other = part;
    Entries& entries = std::get<Entries>(other.fields.content);
    for (const Field* field : part.faulty_fields) {
        std::erase_if(entries, [&](const Entry& entry) { return entry.key == Key(field->name); });
        std::erase_if(other.references, [&](const PartReference& r) { return r.field == field->name; });
        if (auto value = trial_value(*field, choice % kTrialValues))
            add_entry(other.fields, field->name, *std::move(value));
        choice /= kTrialValues;
    }
    return other;
}

bool can_be_tried(const LevelPart& part) {
    if (part.kind != PartKind::Prefab && part.kind != PartKind::Joint) return false;
    if (part.variant.empty() || part.lacks_fields) return false;
    // A joint is nothing without its bodies; a prefab's are what it may hang on.
    return part.kind == PartKind::Prefab ||
           std::none_of(part.faulty_fields.begin(), part.faulty_fields.end(), [](const Field* field) {
               return field->type == FieldType::Body || field->type == FieldType::Joint;
           });
}

/// What is wrong with a faulty part whatever its faulty fields will be. `level` is as before when it is done.
std::vector<std::string> faults_of_sound_fields(lua_State* L, Level& level, std::size_t part, int world,
                                                int objects) {
    if (!can_be_tried(level.parts[part])) return {};
    const LevelPart faulty = level.parts[part];
    // Of many faulty fields all are low or all high together; else their combinations would be too many.
    constexpr std::size_t kMostCombined = 3;
    const std::size_t fields = faulty.faulty_fields.size();
    int choices = 1, uniform = 0;
    for (std::size_t i = 0; i < std::min(fields, kMostCombined); ++i) choices *= kTrialValues;
    for (std::size_t i = 0; i < std::min<std::size_t>(fields, 16); ++i) uniform = uniform * kTrialValues + 1;
    if (fields > kMostCombined) choices = kTrialValues;
    std::vector<std::string> certain;
    for (int choice = 0; choice < choices && (choice == 0 || !certain.empty()); ++choice) {
        level.parts[part] = with_other_values(faulty, fields > kMostCombined ? choice * uniform : choice);
        const std::vector<std::string> faults = make_part(L, level, part, world, objects);
        if (choice == 0) certain = faults;
        std::erase_if(certain, [&](const std::string& fault) {
            return std::find(faults.begin(), faults.end(), fault) == faults.end();
        });
    }
    level.parts[part] = faulty;
    lua_pushnil(L);  // what was made of it is nothing for others to refer to
    lua_rawseti(L, objects, static_cast<lua_Integer>(part + 1));
    return certain;
}

}  // namespace

std::vector<std::string> faults_of_building(lua_State* L, const Level& level) {
    const int top = lua_gettop(L);
    push_scratch_world(L);
    lua_newtable(L);
    std::vector<std::string> faults;
    std::vector<bool> is_made(level.parts.size());
    std::optional<Level> trial;  // a copy, only for levels with faulty parts
    for (std::size_t part = 0; part < level.parts.size(); ++part) {
        const std::vector<std::string> wrong = faults_of_outlines(L, level.parts[part], top + 1);
        faults.insert(faults.end(), wrong.begin(), wrong.end());
        if (refers_to_unmade(level, part, is_made)) continue;  // the cause is told
        if (level.parts[part].is_faulty) {
            if (!trial) trial = level;
            const auto certain = faults_of_sound_fields(L, *trial, part, top + 1, top + 2);
            faults.insert(faults.end(), certain.begin(), certain.end());
            continue;
        }
        const std::vector<std::string> found = make_part(L, level, part, top + 1, top + 2);
        is_made[part] = found.empty() && !level.parts[part].has_faulty_shape;
        faults.insert(faults.end(), found.begin(), found.end());
        if (const lua_Integer count = count_bodies(L, top + 1); count > kMaxBodies) {
            faults.push_back(level.parts[part].place + ": with it the level has " + std::to_string(count) +
                             " bodies, but must have at most " + std::to_string(kMaxBodies));
            break;
        }
    }
    push_function(L, kWorldMethods, "destroy");
    lua_pushvalue(L, top + 1);
    lua_call(L, 1, 0);
    lua_settop(L, top);
    return faults;
}

}  // namespace cairn::scripting
