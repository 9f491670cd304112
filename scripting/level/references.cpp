// What a name must lead to, by the type of the field: a joint, a body, or one of a prefab's bodies.
#include "level/references.h"

#include <algorithm>

#include "data/nearest.h"

namespace cairn::scripting {

void PartReferences::note(LevelPart& part, std::size_t number, const Layer& entry,
                          std::span<const Field* const> fields) {
    for (const Field* field : fields) {
        if (field->type != FieldType::Body && field->type != FieldType::Joint) continue;
        const Value* name = entry.table->find(field->name);
        if (name == nullptr || name->kind() != Value::Kind::String) continue;
        part.references.push_back({field->name, name->text(),
                                   place_of(entry, *name, field->name) + " = " + as_written(*name) + ": "});
        waiting_.push_back({entry, field, *name, number});
    }
}

void PartReferences::check(Level& level, LevelChecker& check) const {
    for (const Waiting& waiting : waiting_) {
        if (check_one(waiting, level, check)) continue;
        LevelPart& part = level.parts[waiting.part];
        part.is_faulty = true;
        const bool is_known = std::find(part.faulty_fields.begin(), part.faulty_fields.end(),
                                        waiting.field) != part.faulty_fields.end();
        if (!is_known) part.faulty_fields.push_back(waiting.field);
    }
}

bool PartReferences::check_one(const Waiting& waiting, const Level& level, LevelChecker& check) const {
    const bool wants_joint = waiting.field->type == FieldType::Joint;
    PartName name = split_part_name(waiting.name.text());
    if (wants_joint) name = {waiting.name.text(), 0};  // joints have no parts
    const PartKind wanted = wants_joint      ? PartKind::Joint
                            : name.index > 0 ? PartKind::Prefab
                                             : PartKind::Body;
    const std::string what = section_of(wanted).one;
    const auto refuse = [&](const std::string& rule) {
        check.fault(waiting.layer, waiting.name, waiting.field->name, rule);
        return false;
    };
    if (refused_names_.contains(name.name)) return false;
    const auto part = level.find(name.name);
    if (!part) {
        if (lacks_names_) return false;
        std::vector<std::string> names = level.names(wanted);
        if (wanted == PartKind::Body) {
            for (const std::string& trigger : level.names(PartKind::Trigger)) names.push_back(trigger);
        }
        return refuse("no such " + what + suggestion(name.name, names));
    }
    const PartKind kind = level.parts[*part].kind;
    const bool is_body = kind == PartKind::Body || kind == PartKind::Trigger;
    if (wanted == PartKind::Body && is_body) return true;
    if (wanted == PartKind::Body && kind == PartKind::Prefab)
        return refuse("is a prefab; \"" + name.name + ".1\" is its first body");
    if (kind != wanted)
        return refuse('"' + name.name + "\" is a " + section_of(kind).one + ", not a " + what);
    if (*part < waiting.part) return true;
    return refuse("must be " + std::string(wants_joint ? "a joint" : "of a prefab") +
                  " that stands before this one");
}

}  // namespace cairn::scripting
