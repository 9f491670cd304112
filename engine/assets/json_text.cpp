// Reads JSON. The parser needs no stack for what is nested, but whoever walks the result does: so brackets
// are counted before.
#include "assets/json_text.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

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

Error nested_too_deep() {
    return Error{"is nested more than " + std::to_string(kMaxNesting) + " deep"};
}

/// Of parsing, or of a number that is too large: without "[json.exception.parse_error.101] ".
std::string_view reason_of(const Json::exception& error) {
    std::string_view reason = error.what();
    if (const std::size_t end = reason.find("] "); reason.starts_with('[') && end != std::string_view::npos)
        reason.remove_prefix(end + 2);
    return reason;
}
Error not_json(const Json::exception& error) {
    return Error{"is not JSON: " + std::string(reason_of(error))};
}
/// Of a fault whose line is told.
Error not_json_in_column(std::size_t column, const Json::exception& error) {
    // "parse error at line 1, column 2: ..."
    std::string_view reason = reason_of(error);
    if (const std::size_t end = reason.find(": "); reason.starts_with("parse error at "))
        reason.remove_prefix(end == std::string_view::npos ? 0 : end + 2);
    return Error{"is not JSON: column " + std::to_string(column) + ": " + std::string(reason)};
}

/// Walks over a text and counts its lines: the parser takes no character before it needs it, so that the
/// count is right where an object begins.
struct CountingCursor {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at;
    int* line;

    reference operator*() const { return *at; }
    CountingCursor& operator++() {
        *line += *at == '\n' ? 1 : 0;
        ++at;
        return *this;
    }
    CountingCursor operator++(int) {
        const CountingCursor before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingCursor& a, const CountingCursor& b) { return a.at == b.at; }
};

/// Makes what the parser tells of. Pointers into unfinished values stay good: only the innermost one grows.
class LinedBuilder : public nlohmann::json_sax<Json> {
  public:
    LinedBuilder(std::string_view text, const int& line) : text_(text), line_(line) {}

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t& value) override { return add(std::move(value)); }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool key(string_t& name) override {
        key_ = std::move(name);
        return true;
    }
    bool end_object() override {
        (*open_.back().value)[kLineMember] = open_.back().line;
        return end_array();
    }
    bool end_array() override {
        open_.pop_back();
        return true;
    }
    bool parse_error(std::size_t read, const std::string&, const Json::exception& error) override {
        // The last character that was read is the wrong one.
        const std::string_view before = text_.substr(0, read > 0 ? read - 1 : 0);
        fault_line_ = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
        const std::size_t line_start = before.rfind('\n') + 1;  // 0 on the first line
        error_ = not_json_in_column(before.size() - line_start + 1, error);
        return false;
    }
    int fault_line() const { return fault_line_; }
    Result<Json> take() {
        if (error_) return *error_;
        return std::move(root_);
    }

  private:
    Json* place(Json value) {
        if (open_.empty()) return &(root_ = std::move(value));
        Json& around = *open_.back().value;
        if (around.is_object()) return &(around[key_] = std::move(value));
        around.push_back(std::move(value));
        return &around.back();
    }
    bool add(Json value) {
        place(std::move(value));
        return true;
    }
    bool open(Json value) {
        const int line = line_;
        open_.push_back({place(std::move(value)), line});
        return true;
    }

    struct Open {
        Json* value;
        int line;
    };
    std::string_view text_;
    const int& line_;
    int fault_line_ = 0;
    Json root_;
    std::vector<Open> open_;
    std::string key_;
    std::optional<Error> error_;
};

}  // namespace

Result<Json> json_from_text(std::string_view text) {
    if (is_nested_too_deep(text)) return nested_too_deep();
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {
        return not_json(error);
    }
}

Result<Json> json_with_lines(std::string_view text, int& fault_line) {
    fault_line = 0;
    if (is_nested_too_deep(text)) return nested_too_deep();
    int line = 1;
    LinedBuilder builder(text, line);
    Json::sax_parse(CountingCursor{text.data(), &line}, CountingCursor{text.data() + text.size(), &line},
                    &builder);
    fault_line = builder.fault_line();
    return builder.take();
}

std::string excerpt(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list";
    return value.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 40);
}

}  // namespace cairn::engine
