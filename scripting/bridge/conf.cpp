// conf.lua by a schema, like any other data file.
#include "bridge/conf.h"

#include "data/schema.h"
#include "data/table_parser.h"

namespace cairn::scripting {
namespace {

Schema schema_of(SchemaType type) {
    Schema schema;
    schema.type = type;
    return schema;
}

Schema conf_schema() {
    constexpr double kLargestSide = 8192;  // of a window, as the engine has it
    Schema side = schema_of(SchemaType::Integer);
    side.min = 1;
    side.max = kLargestSide;
    Schema part = schema_of(SchemaType::Number);
    part.min = 0;
    part.max = 1;
    Schema color = schema_of(SchemaType::List);
    color.min_length = color.max_length = 3;
    color.items = std::make_unique<Schema>(std::move(part));
    Schema identity = schema_of(SchemaType::String);
    identity.min_length = 1;

    Schema conf = schema_of(SchemaType::Table);
    conf.has_fields = true;
    conf.fields.push_back({"background", std::move(color)});
    conf.fields.push_back({"developer_keys", schema_of(SchemaType::Boolean)});
    Schema height = schema_of(SchemaType::Integer);
    height.min = side.min;
    height.max = side.max;
    conf.fields.push_back({"height", std::move(height)});
    conf.fields.push_back({"identity", std::move(identity)});
    conf.fields.push_back({"resizable", schema_of(SchemaType::Boolean)});
    conf.fields.push_back({"title", schema_of(SchemaType::String)});
    conf.fields.push_back({"width", std::move(side)});
    return conf;
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
    const auto value = parse_table_text(text, path);
    if (!value) return {value.error().message};
    return check_data(*value, conf_schema(), path);
}

engine::Result<Conf> parse_conf(std::string_view text, const std::string& path,
                                const std::string& game_name) {
    const auto value = parse_table_text(text, path);
    if (!value) return value.error();
    if (const auto faults = check_data(*value, conf_schema(), path); !faults.empty())
        return engine::Error{faults.front()};
    Conf conf = default_conf(game_name);
    if (const Value* title = value->find("title")) conf.title = title->text();
    if (const Value* identity = value->find("identity")) conf.identity = identity->text();
    if (const Value* width = value->find("width")) conf.size.width = static_cast<int>(width->number());
    if (const Value* height = value->find("height")) conf.size.height = static_cast<int>(height->number());
    if (const Value* resizable = value->find("resizable"))
        conf.is_resizable = std::get<bool>(resizable->content);
    if (const Value* keys = value->find("developer_keys"))
        conf.has_developer_keys = std::get<bool>(keys->content);
    if (const Value* background = value->find("background")) {
        float* const parts[] = {&conf.background.r, &conf.background.g, &conf.background.b};
        for (const Entry& entry : background->entries()) {
            *parts[std::get<std::int64_t>(entry.key) - 1] = static_cast<float>(entry.value.number());
        }
    }
    return conf;
}

}  // namespace cairn::scripting
