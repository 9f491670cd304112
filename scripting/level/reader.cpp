// Two passes over what the files hold: the parts, each merged from its layers (the entry itself, its
// template, its material); and then, when all names are known, what refers to them.
#include "level/reader.h"

#include <algorithm>
#include <map>
#include <set>

#include <cairn/engine/image.h>

#include "bind/convex_parts.h"
#include "data/nearest.h"
#include "level/check.h"
#include "level/definitions.h"
#include "level/references.h"
#include "level/tiled_level.h"

namespace cairn::scripting {
namespace {

using namespace level_fields;

/// Far more than a level needs; a file that has more was made by mistake or in order to hurt.
constexpr std::size_t kMaxParts = 100'000;

bool is_part_name(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    });
}

std::string member_path(const std::string& list, const Key& key) {
    if (const auto* name = std::get_if<std::string>(&key)) return list + '.' + *name;
    return list + '[' + std::to_string(std::get<std::int64_t>(key)) + ']';
}

class Reader {
  public:
    Reader(const engine::Files& files, const TiledImport& import)
        : files_(files), definitions_(files, import, check_) {}

    LevelReading read(const std::string& path) {
        level_.path = path;
        if (definitions_.read(path, level_.table, level_.files)) {
            root_ = {&level_.table, "", path};
            read_own();
            for (int kind = 0; kind < kPartKinds; ++kind) read_parts(static_cast<PartKind>(kind));
            read_spawns();
            read_decorations();
            references_.check(level_, check_);
        }
        return {std::move(level_), check_.faults()};
    }

  private:
    /// The members of a section that is a list of tables. What is not is a fault, and left out.
    std::vector<Layer> list_of(const char* section) {
        std::vector<Layer> items;
        const Value* list = level_.table.find(section);
        if (list == nullptr || list->kind() != Value::Kind::Table) return items;
        if (!list->is_list())
            check_.fault({list, section, level_.path}, "must be a list: { { ... }, { ... } }");
        if (list->entries().size() > kMaxParts) {
            check_.fault({list, section, level_.path},
                         "must have at most " + std::to_string(kMaxParts) + " entries");
            return items;
        }
        for (const Entry& entry : list->entries()) {
            const std::string path = member_path(section, entry.key);
            if (entry.value.kind() == Value::Kind::Table) {
                items.push_back({&entry.value, path, level_.path});
            } else {
                check_.fault(root_, entry.value, path, "must be a table");
            }
        }
        return items;
    }

    void read_own() {
        const auto number = [&](const char* name) -> std::optional<double> {
            const Value* value = level_.table.find(name);
            if (value == nullptr || !value->is_number()) return std::nullopt;
            return value->number();
        };
        level_.gravity_x = number("gravity_x");
        level_.gravity_y = number("gravity_y");
        if (const Value* name = level_.table.find(kName);
            name != nullptr && name->kind() == Value::Kind::String)
            level_.name = name->text();
        check_table("camera", kCameraFields);
        check_table("bounds", kBoundsFields);
        check_order("left", "right");
        check_order("bottom", "top");
    }

    /// Of the bounds.
    void check_order(const char* low, const char* high) {
        const Value* bounds = level_.table.find("bounds");
        if (bounds == nullptr || bounds->kind() != Value::Kind::Table) return;
        const Value* least = bounds->find(low);
        const Value* most = bounds->find(high);
        if (least == nullptr || most == nullptr || !least->is_number() || !most->is_number()) return;
        if (most->number() > least->number()) return;
        const Layer layer{bounds, "bounds", level_.path};
        if (most->origin == nullptr) {
            check_.fault(layer, *most, high,
                         std::string("must be above ") + low + ", which is " + to_short_text(*least));
        } else {  // of a rectangle of Tiled, which has a corner and a size
            const bool is_size = most->origin->member != "y";
            check_.fault(layer, is_size ? *most : *least, high, "must be above 0");
        }
    }

    void check_table(const char* section, const FieldSet& set) {
        const Value* table = level_.table.find(section);
        if (table == nullptr || table->kind() != Value::Kind::Table) return;
        const std::vector<const Field*> fields = all_fields(set);
        const Layer layer{table, section, level_.path};
        check_.check_fields(layer, fields);
        check_.check_missing({&layer, 1}, fields);
    }

    void check_list(const char* section, const FieldSet& set) {
        const std::vector<const Field*> fields = all_fields(set);
        for (const Layer& layer : list_of(section)) {
            check_.check_fields(layer, fields);
            check_.check_missing({&layer, 1}, fields);
            if (const Value* name = layer.table->find(kName)) take_name(layer, *name);
        }
    }
    void read_spawns() { check_list("spawns", kSpawnFields); }

    void read_decorations() {
        check_list("decorations", kDecorationFields);
        for (const Layer& layer : list_of("decorations")) {
            const Value* image = layer.table->find("image");
            if (image == nullptr || image->kind() != Value::Kind::String) continue;
            auto known = pictures_.find(image->text());
            if (known == pictures_.end())
                known = pictures_.emplace(image->text(), fault_of_picture(image->text())).first;
            if (!known->second.empty()) check_.fault(layer, *image, "image", known->second);
        }
    }

    /// By its header and its end; `cairn check` reads the rest of each picture too.
    [[nodiscard]] std::string fault_of_picture(const std::string& path) const {
        const auto kind = files_.kind(path);
        if (!kind) return "there is no such file";
        if (*kind == engine::FileKind::Folder) return "is a folder, and must be a picture";
        const auto bytes = files_.read_bytes(path);
        if (!bytes) return bytes.error().message;
        const auto size = engine::check_image(*bytes, path);
        return size ? "" : "must be a picture: " + size.error().message;
    }

    /// The text of a name that is good and new; else a fault, and nothing.
    std::string take_name(const Layer& layer, const Value& name) {
        if (name.is_unreadable) references_.note_lost_name();
        if (name.kind() != Value::Kind::String) return "";
        if (!is_part_name(name.text())) {
            references_.note_refused_name(name.text());
            check_.fault(layer, name, kName, "must be letters, digits, _ and -, and not empty");
            return "";
        }
        if (const auto [known, is_new] = names_.try_emplace(name.text(), told_name(layer)); !is_new) {
            check_.fault(layer, name, kName, "is the name of " + known->second + " already");
            return "";
        }
        return name.text();
    }

    // ---- Parts

    void read_parts(PartKind kind) {
        for (const Layer& layer : list_of(section_of(kind).list)) read_part(kind, layer);
    }

    /// Whether faults were told meanwhile.
    template <class Function>
    bool tells(Function&& check) {
        const std::size_t before = check_.count();
        check();
        return check_.count() > before;
    }

    void read_part(PartKind kind, const Layer& entry) {
        LevelPart part;
        part.kind = kind;
        part.place = place_of(entry);
        part.path = entry.path;
        if (const Value* name = entry.table->find(kName)) part.name = take_name(entry, *name);
        std::vector<Layer> layers = {entry};
        const bool has_all_layers =
            kind != PartKind::Body || add_named(layers, kTemplate, "template", definitions_.templates());
        part.is_faulty = !has_all_layers;
        if (!read_variant(part, layers)) {
            part.is_faulty = true;
            const std::vector<const Field*> fields = undisputed_fields(kind);
            check_.check_known_fields(entry, fields);
            references_.note(part, level_.parts.size(), entry, fields);
            level_.parts.push_back(std::move(part));
            return;
        }
        // A template that is not there may have been to say the shape.
        const bool has_open_shape = !has_all_layers && part.variant.empty();
        const std::vector<const Field*> fields =
            has_open_shape ? fields_of_any_body() : part_fields(kind, part.variant);
        part.is_faulty |= tells([&] { check_.check_fields(entry, fields); });
        const bool takes_material = std::any_of(fields.begin(), fields.end(), [](const Field* field) {
            return std::string_view(field->name) == kMaterial;
        });
        if (takes_material) add_named(layers, kMaterial, "material", definitions_.materials());
        // What is missing may stand in a template that is not there; that is told.
        if (has_all_layers)
            part.lacks_fields = tells([&] { check_.check_missing(layers, fields, "body_a"); });
        part.is_faulty |= part.lacks_fields;
        part.is_faulty |= tells([&] { check_outline(part.variant, layers); });
        for (const Layer& layer : layers)
            part.is_faulty |= check_.is_faulty(layer) && &layer != &layers.front();
        part.fields = merged(layers, fields);
        for (const Field* field : fields) {
            const Value* value = find_in(layers, field->name);
            if (value != nullptr && (value->is_unreadable || check_.is_faulty(*value)))
                part.faulty_fields.push_back(field);
        }
        if (part.is_faulty && is_shape(kind, part.variant)) note_outline(part, part.variant, layers);
        if (kind == PartKind::Body) read_shapes(part, layers);
        note_names(part, layers);
        references_.note(part, level_.parts.size(), entry, fields);
        level_.parts.push_back(std::move(part));
    }

    /// Which variant it is; false, after telling so, when there is no such one.
    bool read_variant(LevelPart& part, std::span<const Layer> layers) {
        const PartSection& section = section_of(part.kind);
        const Layer* layer = nullptr;
        const Value* variant = find_in(layers, section.variant, &layer);
        if (variant == nullptr) {
            if (part.kind == PartKind::Body) return true;
            check_.missing(layers.front(), section.variant, suggestion("", variants_of(part.kind)));
            return false;
        }
        if (variant->kind() != Value::Kind::String) {
            check_.fault(*layer, *variant, section.variant,
                         "must be a string, is " + std::string(kind_with_article(variant->kind())));
            return false;
        }
        const bool is_unknown = tells([&] {
            check_.check_one_of(*layer, *variant, section.variant,
                                part.kind == PartKind::Trigger ? "shape of a trigger" : section.variant,
                                variants_of(part.kind));
        });
        if (!is_unknown) part.variant = variant->text();
        return !is_unknown;
    }

    /// Adds the template or material that the layers name. False when they name one that there is not.
    bool add_named(std::vector<Layer>& layers, const char* field, const std::string& what,
                   const std::map<std::string, Layer>& known) {
        const Layer* layer = nullptr;
        const Value* name = find_in(layers, field, &layer);
        if (name == nullptr) return true;
        if (name->kind() != Value::Kind::String) return false;
        const auto found = known.find(name->text());
        if (found != known.end()) {
            layers.push_back(found->second);
        } else if (!definitions_.are_incomplete()) {
            std::vector<std::string> names = LevelDefinitions::names_of(known);
            const bool is_class = name->origin != nullptr && name->origin->member == kTiledClass;
            if (is_class) names.insert(names.end(), tiled_classes().begin(), tiled_classes().end());
            check_.check_one_of(*layer, *name, field, is_class ? "class or template" : what, names);
        }
        return found != known.end();
    }

    /// Of a polygon: whether it can be made of what was drawn.
    void check_outline(const std::string& variant, std::span<const Layer> layers) {
        constexpr const char* kPoints = "points";
        const Layer* layer = nullptr;
        const Value* points = variant == "polygon" ? find_in(layers, kPoints, &layer) : nullptr;
        if (points == nullptr || !points->is_list()) return;
        std::vector<physics::Vec2> outline;
        for (const Entry& entry : points->entries()) {
            if (!is_point(entry.value)) return;  // told already
            const Entries& pair = entry.value.entries();
            outline.push_back(
                {static_cast<float>(pair[0].value.number()), static_cast<float>(pair[1].value.number())});
        }
        if (const auto parts = convex_parts(outline); !parts)
            check_.fault(*layer, *points, "", parts.error().message);
    }

    static bool is_shape(PartKind kind, const std::string& variant) {
        return (kind == PartKind::Body || kind == PartKind::Trigger) && !variant.empty();
    }

    /// Keeps the form of a faulty shape, unless it is faulty itself: its rules need nothing else.
    void note_outline(LevelPart& part, const std::string& variant, std::span<const Layer> layers) const {
        const std::vector<const Field*> fields = outline_fields(variant);
        for (const Field* field : fields) {
            const Value* value = find_in(layers, field->name);
            const bool is_missing = value == nullptr && field->default_text == nullptr;
            if (is_missing || (value != nullptr && check_.is_faulty(*value))) return;
        }
        part.outlines.push_back({variant, merged(layers, fields), place_of(layers.front())});
    }

    /// One table of all layers, without what only levels know. In the order of the fields, so that equal
    /// parts are equal however they were written.
    static Value merged(std::span<const Layer> layers, std::span<const Field* const> fields) {
        static const std::set<std::string_view> own = {kName,   kTemplate, kMaterial, kShapes,
                                                       "shape", "joint",   "prefab"};
        Value table;
        table.content = Entries{};
        for (const Field* field : fields) {
            if (own.contains(field->name)) continue;
            if (const Value* value = find_in(layers, field->name)) add_entry(table, field->name, *value);
        }
        return table;
    }

    void read_shapes(LevelPart& part, const std::vector<Layer>& layers) {
        const Layer* layer = nullptr;
        const Value* list = find_in(layers, kShapes, &layer);
        if (list == nullptr || list->kind() != Value::Kind::Table) {
            if (part.variant.empty()) {
                // Its template may have been to give it one: one that is not there, or that hopes to have
                // it from another, which is told.
                const bool has_template = layers.front().table->find(kTemplate) != nullptr;
                const bool has_lost_it =
                    has_template && (layers.size() == 1 || layers[1].table->find(kTemplate) != nullptr);
                if (!has_lost_it)
                    check_.fault(layers.front(),
                                 "has neither \"shape\" nor \"shapes\"; one of them is expected" +
                                     suggestion("", variants_of(PartKind::Body)));
            }
            return;
        }
        if (!part.variant.empty()) {
            check_.fault(*layer, *list, kShapes, "stands beside \"shape\"; one or the other is expected");
            return;
        }
        if (!list->is_list()) {
            check_.fault(*layer, *list, kShapes, "must be a list: { { ... }, { ... } }");
            return;
        }
        if (list->entries().empty())
            check_.fault(*layer, *list, kShapes + std::string(" = {}"), "must hold at least one shape");
        for (std::size_t i = 0; i < list->entries().size(); ++i) {
            const Value& shape = list->entries()[i].value;
            const std::string path = item_path(kShapes, i);
            part.has_faulty_shape |= tells([&] {
                if (shape.kind() != Value::Kind::Table) {
                    check_.fault(*layer, shape, path, "must be a table");
                } else {
                    read_shape(part, layers, {&shape, layer->path + '.' + path, layer->file});
                }
            });
        }
    }

    void read_shape(LevelPart& part, const std::vector<Layer>& body, const Layer& entry) {
        const Value* variant = entry.table->find("shape");
        if (variant == nullptr) {
            check_.fault(entry, "\"shape\" is missing" + suggestion("", variants_of(PartKind::Body)));
            return;
        }
        if (variant->kind() != Value::Kind::String) {
            check_.fault(entry, *variant, "shape", "must be a string");
            return;
        }
        const bool is_unknown = tells(
            [&] { check_.check_one_of(entry, *variant, "shape", "shape", variants_of(PartKind::Body)); });
        if (is_unknown) return;
        const std::vector<const Field*> fields = shape_fields(variant->text());
        bool is_faulty = tells([&] { check_.check_fields(entry, fields); });
        std::vector<Layer> layers = {entry};
        add_named(layers, kMaterial, "material", definitions_.materials());
        if (layers.size() == 1) {  // without a material of its own it has that of the body
            std::vector<Layer> all = body;
            add_named(all, kMaterial, "material", definitions_.materials());
            if (all.size() > body.size()) layers.push_back(all.back());
        }
        is_faulty |= tells([&] { check_.check_missing(layers, fields); });
        is_faulty |= tells([&] { check_outline(variant->text(), layers); });
        if (!is_faulty) part.shapes.push_back({variant->text(), merged(layers, fields), place_of(entry)});
        if (is_faulty || part.is_faulty) note_outline(part, variant->text(), layers);
    }

    /// What scripts want to know of a body: its name and material, in its data.
    void note_names(LevelPart& part, const std::vector<Layer>& layers) const {
        if (part.kind == PartKind::Joint) return;
        const Value* material = find_in(layers, kMaterial);
        const bool has_material =
            part.kind != PartKind::Trigger && material != nullptr && material->kind() == Value::Kind::String;
        if (part.name.empty() && !has_material) return;
        if (part.fields.find("data") == nullptr) {
            Value empty;
            empty.content = Entries{};
            add_entry(part.fields, "data", std::move(empty));
        }
        Value* data = nullptr;
        for (Entry& entry : std::get<Entries>(part.fields.content)) {
            if (entry.key == Key("data")) data = &entry.value;
        }
        if (data->kind() != Value::Kind::Table) return;  // a fault already
        const auto note = [&](const char* key, const std::string& text) {
            if (data->find(key) != nullptr) return;
            Value value;
            value.content = text;
            add_entry(*data, key, std::move(value));
        };
        if (!part.name.empty()) note(kName, part.name);
        if (has_material) note(kMaterial, material->text());
    }

    const engine::Files& files_;
    Level level_;
    LevelChecker check_;
    LevelDefinitions definitions_;
    Layer root_;
    std::map<std::string, std::string> names_;     ///< name -> path of what has it
    std::map<std::string, std::string> pictures_;  ///< path -> its fault, or empty
    PartReferences references_;
};

}  // namespace

LevelReading read_level(const engine::Files& files, const std::string& path, const TiledImport& import) {
    return Reader(files, import).read(path);
}

}  // namespace cairn::scripting
