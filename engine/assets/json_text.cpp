// Reads JSON. The parser needs no stack for what is nested, but whoever walks the result does: so brackets
// are counted before.
#include "assets/json_text.h"

namespace cairn::engine {
namespace {

using Json = nlohmann::ordered_json;

bool is_nested_too_deep(std::string_view text) {
    int depth = 0;
    bool is_in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (is_in_string) {
            if (c == '\\') ++i;
            if (c == '"') is_in_string = false;
        } else if (c == '"') {
            is_in_string = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kMaxNesting) return true;
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return false;
}

}  // namespace

Result<Json> json_from_text(std::string_view text) {
    if (is_nested_too_deep(text))
        return Error{"is nested more than " + std::to_string(kMaxNesting) + " deep"};
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {  // not of parsing alone: of numbers that are too large too
        std::string_view reason = error.what();
        // "[json.exception.parse_error.101] parse error at line 1, ..."
        if (const std::size_t end = reason.find("] ");
            reason.starts_with('[') && end != std::string_view::npos)
            reason.remove_prefix(end + 2);
        return Error{"is not JSON: " + std::string(reason)};
    }
}

std::string excerpt(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 40);
}

}  // namespace cairn::engine
