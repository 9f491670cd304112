// conf.lua by a schema, like any other data file.
#include "bridge/conf.h"

#include <cairn/engine/files.h>

#include "data/schema.h"
#include "data/table_parser.h"

namespace cairn::scripting {
namespace {

Schema schema_of(SchemaType type) {
    Schema schema;
    schema.type = type;
    return schema;
}

Schema side_schema() {
    Schema side = schema_of(SchemaType::Integer);
    side.min = 1;
    side.max = engine::kMaxWindowSide;
    return side;
}

Schema conf_schema() {
    Schema part = schema_of(SchemaType::Number);
    part.min = 0;
    part.max = 1;
    Schema color = schema_of(SchemaType::List);
    color.min_length = color.max_length = 3;
    color.items = std::make_unique<Schema>(std::move(part));
    Schema identity = schema_of(SchemaType::String);
    identity.min_length = 1;
    identity.check = [](const Value& value) -> std::optional<std::string> {
        if (engine::is_save_identity(value.text())) return std::nullopt;
        return std::string(engine::kSaveIdentityRule);
    };
    Schema scaling = schema_of(SchemaType::String);
    scaling.what = "scaling";
    scaling.one_of = {"fit", "follow"};

    Schema updates = schema_of(SchemaType::Integer);
    updates.min = kLeastUpdates;
    updates.max = kMostUpdates;

    Schema conf = schema_of(SchemaType::Table);
    conf.has_fields = true;
    conf.fields.push_back({"background", std::move(color)});
    conf.fields.push_back({"developer_keys", schema_of(SchemaType::Boolean)});
    conf.fields.push_back({"fullscreen", schema_of(SchemaType::Boolean)});
    conf.fields.push_back({"height", side_schema()});
    conf.fields.push_back({"high_dpi", schema_of(SchemaType::Boolean)});
    conf.fields.push_back({"identity", std::move(identity)});
    conf.fields.push_back({"resizable", schema_of(SchemaType::Boolean)});
    conf.fields.push_back({"scaling", std::move(scaling)});
    conf.fields.push_back({"title", schema_of(SchemaType::String)});
    conf.fields.push_back({"updates_per_second", std::move(updates)});
    conf.fields.push_back({"vsync", schema_of(SchemaType::Boolean)});
    conf.fields.push_back({"width", side_schema()});
    conf.fields.push_back({"window_height", side_schema()});
    conf.fields.push_back({"window_width", side_schema()});
    return conf;
}

void read(const Value& table, const char* name, bool& to) {
    if (const Value* value = table.find(name)) to = std::get<bool>(value->content);
}
void read(const Value& table, const char* name, int& to) {
    if (const Value* value = table.find(name)) to = static_cast<int>(value->number());
}
void read(const Value& table, const char* name, std::string& to) {
    if (const Value* value = table.find(name)) to = value->text();
}

/// What no field says alone.
void check_scaling(const Value& conf, const std::string& path, std::vector<std::string>& faults) {
    const Value* scaling = conf.find("scaling");
    const bool follows =
        scaling != nullptr && scaling->kind() == Value::Kind::String && scaling->text() == "follow";
    for (const char* field : {"window_width", "window_height"}) {
        const Value* value = follows ? conf.find(field) : nullptr;
        if (value == nullptr || value->is_unreadable) continue;
        faults.push_back(path + ':' + std::to_string(value->line) + ": " + field + " = " +
                         to_short_text(*value) +
                         ": is without meaning when scaling = \"follow\": the picture has the window's size, "
                         "which width and height give");
    }
}

std::vector<std::string> faults_of(const Value& conf, const std::string& path) {
    std::vector<std::string> faults = check_data(conf, conf_schema(), path);
    if (conf.kind() == Value::Kind::Table) check_scaling(conf, path, faults);
    return faults;
}

}  // namespace

Conf default_conf(const std::string& game_name) {
    Conf conf;
    conf.title = game_name;
    for (const char c : game_name) {
        const bool is_plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        conf.identity += is_plain ? c : '_';
    }
    return conf;
}

std::vector<std::string> faults_of_conf(std::string_view text, const std::string& path) {
    std::vector<std::string> faults;
    const auto value = parse_faulty_table_text(text, path, faults);
    const std::vector<std::string> more =
        value ? faults_of(*value, path) : std::vector<std::string>{value.error().message};
    faults.insert(faults.end(), more.begin(), more.end());
    return faults;
}

engine::Result<Conf> parse_conf(std::string_view text, const std::string& path,
                                const std::string& game_name) {
    const auto value = parse_table_text(text, path);
    if (!value) return value.error();
    if (const auto faults = faults_of(*value, path); !faults.empty()) return engine::Error{faults.front()};
    Conf conf = default_conf(game_name);
    read(*value, "title", conf.title);
    read(*value, "identity", conf.identity);
    read(*value, "width", conf.size.width);
    read(*value, "height", conf.size.height);
    read(*value, "resizable", conf.is_resizable);
    read(*value, "fullscreen", conf.is_fullscreen);
    read(*value, "high_dpi", conf.is_high_dpi);
    read(*value, "vsync", conf.has_vsync);
    read(*value, "updates_per_second", conf.updates_per_second);
    read(*value, "developer_keys", conf.has_developer_keys);
    engine::Size own = conf.size;
    read(*value, "window_width", own.width);
    read(*value, "window_height", own.height);
    if (own != conf.size) conf.window_size = own;
    std::string scaling;
    read(*value, "scaling", scaling);
    if (scaling == "follow") conf.scaling = engine::WindowScaling::Follow;
    if (const Value* background = value->find("background")) {
        float* const parts[] = {&conf.background.r, &conf.background.g, &conf.background.b};
        for (const Entry& entry : background->entries()) {
            *parts[std::get<std::int64_t>(entry.key) - 1] = static_cast<float>(entry.value.number());
        }
    }
    return conf;
}

engine::WindowDef Conf::window() const {
    return {.title = title,
            .size = size,
            .scaling = scaling,
            .window_size = window_size,
            .is_resizable = is_resizable,
            .is_fullscreen = is_fullscreen,
            .has_vsync = has_vsync,
            .is_high_dpi = is_high_dpi};
}

}  // namespace cairn::scripting
