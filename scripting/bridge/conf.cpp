// conf.lua by a schema, like any other data file. The schema is that of the described fields.
#include "bridge/conf.h"

#include <algorithm>

#include <cairn/engine/files.h>

#include "data/schema.h"
#include "data/table_parser.h"

namespace cairn::scripting {
namespace {

constexpr Range kSides{1, engine::kMaxWindowSide};
constexpr Field kTitle = optional_field("title", FieldType::String, "of the window; absent: the game's name");
constexpr Field kIdentity =
    optional_field("identity", FieldType::String, "name of the save folder; absent: the game's name");
constexpr Field kWidth =
    within(integer_field("width", 1280, "1280",
                         "logical pixels: what the game draws in, whatever the window's size"),
           kSides);
constexpr Field kHeight = within(integer_field("height", 720, "720", "logical pixels"), kSides);
constexpr Field kWindowWidth =
    within(optional_field("window_width", FieldType::Integer,
                          "of the window itself, in the desktop's points; absent: `width`"),
           kSides);
constexpr Field kWindowHeight =
    within(optional_field("window_height", FieldType::Integer, "absent: `height`"), kSides);
constexpr Field kScaling =
    choice_field("scaling", "fit", "fit follow",
                 "the picture is scaled to fit the window; \"follow\": width and height follow it instead");
constexpr Field kResizable =
    boolean_field("resizable", true, "whether the player can change the window's size");
constexpr Field kFullscreen = boolean_field("fullscreen", false, "over the whole display from the start");
constexpr Field kHighDpi = boolean_field(
    "high_dpi", true, "every pixel of a dense display is drawn; false: one for each point of the desktop");
constexpr Field kVsync = boolean_field("vsync", true, "pictures wait for the display");
constexpr Field kUpdates =
    within(integer_field("updates_per_second", 60, "60", "the fixed step is one of these parts of a second"),
           kLeastUpdates, kMostUpdates);
constexpr Field kBackground{"background", FieldType::Table, "{0, 0, 0}",
                            "color of the picture before cairn.draw"};
constexpr Field kDeveloperKeys = boolean_field(
    "developer_keys", true,
    "whether F1 to F10 open the [tools](games.md#tools-in-every-game); false gives them to the game");
constexpr const Field* kConfFields[] = {
    &kTitle,     &kIdentity,   &kWidth,   &kHeight, &kWindowWidth, &kWindowHeight, &kScaling,
    &kResizable, &kFullscreen, &kHighDpi, &kVsync,  &kUpdates,     &kBackground,   &kDeveloperKeys};

SchemaType schema_type(FieldType type) {
    if (type == FieldType::Integer) return SchemaType::Integer;
    if (type == FieldType::Boolean) return SchemaType::Boolean;
    return type == FieldType::String ? SchemaType::String : SchemaType::Any;
}

Schema color_schema() {
    Schema part;
    part.type = SchemaType::Number;
    part.min = 0;
    part.max = 1;
    Schema color;
    color.type = SchemaType::List;
    color.min_length = color.max_length = 3;
    color.items = std::make_unique<Schema>(std::move(part));
    return color;
}

Schema schema_of(const Field& field) {
    if (&field == &kBackground) return color_schema();
    Schema schema;
    schema.type = schema_type(field.type);
    if (schema.type == SchemaType::Integer) {
        schema.min = field.range.low;
        schema.max = field.range.high;
    }
    if (!field.choices.empty()) {
        schema.what = field.name;
        schema.one_of = words_of(field.choices);
    }
    if (&field == &kIdentity) {
        schema.min_length = 1;
        schema.check = [](const Value& value) -> std::optional<std::string> {
            if (engine::is_save_identity(value.text())) return std::nullopt;
            return std::string(engine::kSaveIdentityRule);
        };
    }
    return schema;
}

Schema conf_schema() {
    Schema conf;
    conf.type = SchemaType::Table;
    conf.has_fields = true;
    for (const Field* field : kConfFields) conf.fields.push_back({field->name, schema_of(*field)});
    std::sort(conf.fields.begin(), conf.fields.end(),
              [](const SchemaField& a, const SchemaField& b) { return a.name < b.name; });
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

std::span<const Field* const> conf_fields() {
    return kConfFields;
}

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
