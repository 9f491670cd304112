// Reads files, includes, materials and templates.
#include "level/definitions.h"

#include <algorithm>

#include "data/nearest.h"
#include "data/table_parser.h"
#include "level/tiled_level.h"

namespace cairn::scripting {

using namespace level_fields;

bool LevelDefinitions::read(const std::string& path, Value& level, std::vector<std::string>& paths) {
    check_.begin(path);
    const bool is_read = read_table(path, level);
    if (is_read) {
        const Layer root{&level, "", path};
        check_.check_fields(root, all_fields(kLevelFields));
        read_definitions(root);
        read_includes(root);
    }
    paths = paths_;
    return is_read;
}

bool LevelDefinitions::read_table(const std::string& path, Value& out) {
    paths_.push_back(path);
    if (is_tiled_file(path)) {
        std::vector<TiledFault> faults;
        auto level = tiled_level(files_, path, import_.scale, faults);
        for (const TiledFault& fault : faults) {
            if (fault.line > 0) {
                check_.fault_of_line(path, fault.line, fault.text);
            } else {
                check_.fault_of_file(path, fault.text);
            }
        }
        if (!level) return false;
        out = *std::move(level);
        return true;
    }
    const auto text = files_.read_text(path);
    if (!text) return check_.fault_of_file(path, text.error().message), false;
    std::vector<std::string> faults;
    auto parsed = parse_faulty_table_text(*text, path, faults);
    for (const std::string& fault : faults) check_.fault_of_file(path, fault);
    if (!parsed) return check_.fault_of_file(path, parsed.error().message), false;
    out = *std::move(parsed);
    return true;
}

template <class Function>
void LevelDefinitions::for_each_named(const Layer& root, const char* section, Function&& function) {
    const Value* table = root.table->find(section);
    if (table != nullptr && table->is_unreadable) lacks_definitions_ = true;
    if (table == nullptr || table->kind() != Value::Kind::Table) return;
    for (const Entry& entry : table->entries()) {
        if (entry.value.is_unreadable) lacks_definitions_ = true;
        const auto* name = std::get_if<std::string>(&entry.key);
        if (name == nullptr) {
            check_.fault({&entry.value, section, root.file},
                         "has an entry without a name; expected name = { ... }");
        } else if (entry.value.kind() != Value::Kind::Table) {
            check_.fault(root, entry.value, std::string(section) + '.' + *name, "must be a table");
        } else {
            function(*name, Layer{&entry.value, std::string(section) + '.' + *name, root.file});
        }
    }
}

void LevelDefinitions::read_definitions(const Layer& root) {
    const std::vector<const Field*> matter = all_fields(kLevelMaterialFields);
    for_each_named(root, "materials", [&](const std::string& name, const Layer& layer) {
        check_.check_fields(layer, matter);
        materials_.try_emplace(name, layer);
    });
    for_each_named(root, "templates", [&](const std::string& name, const Layer& layer) {
        templates_.try_emplace(name, layer);
        new_templates_.push_back(layer);
    });
    // A template may use materials of a file that is included later.
}

void LevelDefinitions::read_includes(const Layer& root) {
    const Value* list = root.table->find("includes");
    if (list != nullptr && list->is_unreadable) lacks_definitions_ = true;
    if (list != nullptr && list->kind() == Value::Kind::Table) {
        if (!list->is_list()) check_.fault({list, "includes", root.file}, "must be a list of files");
        // Values must not move while layers point at them.
        included_.reserve(list->entries().size());
        for (std::size_t i = 0; list->is_list() && i < list->entries().size(); ++i) {
            const Value& file = list->entries()[i].value;
            if (!read_include(root, file, item_path("includes", i))) lacks_definitions_ = true;
        }
    }
    for (const Layer& layer : new_templates_) check_template(layer);
}

bool LevelDefinitions::read_include(const Layer& root, const Value& file, const std::string& path) {
    const auto refuse = [&](const char* rule) { check_.fault(root, file, path, rule); };
    if (file.kind() != Value::Kind::String) return refuse("must be the path of a file, in quotes"), false;
    if (file.text() == root.file) return refuse("is this file itself"), true;
    const bool is_known = std::find(paths_.begin(), paths_.end(), file.text()) != paths_.end();
    if (is_known) return refuse("is included already"), true;
    if (!files_.exists(file.text())) return refuse("there is no such file"), false;
    Value table;
    if (!read_table(file.text(), table)) return false;
    included_.push_back(std::move(table));
    const Layer layer{&included_.back(), "", file.text()};
    const std::vector<const Field*> fields = all_fields(kLevelFields);
    check_.check_fields(layer, fields);
    for (const Field* field : fields) {
        const std::string_view name = field->name;
        if (name == "materials" || name == "templates") continue;
        if (const Value* value = layer.table->find(name)) {
            check_.fault(layer, *value, field->name,
                         "has no effect here: of a file that is included, materials and templates are taken");
        }
    }
    read_definitions(layer);
    return true;
}

void LevelDefinitions::check_template(const Layer& layer) {
    std::vector<const Field*> fields;
    const Value* shape = layer.table->find("shape");
    if (shape != nullptr && shape->kind() == Value::Kind::String) {
        check_.check_one_of(layer, *shape, "shape", "shape", variants_of(PartKind::Body));
        fields = part_fields(PartKind::Body, shape->text());
    } else {
        fields = fields_of_any_body();
    }
    if (const Value* other = layer.table->find(kTemplate))
        check_.fault(layer, *other, kTemplate, "a template cannot have a template of its own");
    check_.check_fields(layer, fields);
    check_material(layer);
}

void LevelDefinitions::check_material(const Layer& layer) {
    const Value* material = layer.table->find(kMaterial);
    if (material != nullptr && !lacks_definitions_)
        check_.check_one_of(layer, *material, kMaterial, "material", names_of(materials_));
}

std::vector<std::string> LevelDefinitions::names_of(const std::map<std::string, Layer>& map) {
    std::vector<std::string> names;
    for (const auto& [name, layer] : map) names.push_back(name);
    return names;
}

}  // namespace cairn::scripting
