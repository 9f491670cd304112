// A row for each field: name, type, default, meaning.
#include "bridge/field_table.h"

namespace cairn::scripting {
namespace {

/// What its description says, and its range.
std::string meaning(const Field& field) {
    const std::string range = to_text(field.range);
    const std::string doc = field.doc;
    return doc + (doc.empty() || range.empty() ? "" : "; ") + range;
}

}  // namespace

std::string field_table(std::span<const Field* const> fields) {
    std::string out = "\n| field | type | default | |\n|---|---|---|---|\n";
    for (const Field* field : fields) {
        std::string default_text = field->default_text == nullptr ? "required" : field->default_text;
        if (default_text.empty()) {
            default_text = "nil";
        } else if (field->type == FieldType::String && field->default_text != nullptr) {
            default_text = '"' + default_text + '"';
        }
        out += std::string("| `") + field->name + "` | " + field_type_name(field->type) + " | " +
               default_text + " | " + meaning(*field) + " |\n";
    }
    return out;
}

}  // namespace cairn::scripting
