// A recursive-descent parser over the text itself; there is no separate list of tokens, because the grammar
// needs one character of look-ahead (two at comments, long strings and `name =`).
#include "data/table_parser.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "data/source_text.h"

namespace cairn::scripting {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_hex_digit(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
int hex_value(char c) {
    return is_digit(c) ? c - '0' : (c | 0x20) - 'a' + 10;
}

/// Appends a code point as UTF-8.
void append_utf8(std::string& out, std::uint32_t code) {
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xc0 | code >> 6);
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        out += static_cast<char>(0xe0 | code >> 12);
        out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        out += static_cast<char>(0xf0 | code >> 18);
        out += static_cast<char>(0x80 | (code >> 12 & 0x3f));
        out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    }
}

/// Parsing stops at the first error: every function returns false, or nothing, as soon as `error_` is set.
/// With a list for faults it goes on behind a value that is no data, because its end can be found.
class Parser {
  public:
    Parser(std::string_view text, std::string_view name, std::vector<std::string>* faults)
        : text_(text), name_(name), faults_(faults) {}

    engine::Result<Value> file() {
        skip_space();
        if (word_ahead() == "return") {
            position_ += 6;
            skip_space();
        }
        Value value;
        if (at_end()) return fail_result("the file holds no table; expected { ... } or return { ... }");
        if (peek() != '{') return fail_result("expected a table, { ... }, found " + found());
        if (!table(value, 1)) return engine::Error{*error_};
        skip_space();
        if (peek() == ';') ++position_;
        skip_space();
        if (error_) return engine::Error{*error_};
        if (!at_end()) return fail_result("expected the end of the file after the table, found " + found());
        return value;
    }

  private:
    bool at_end() const { return position_ >= text_.size(); }
    char peek(std::size_t ahead = 0) const {
        return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
    }
    void mark(Value& value) const {
        const auto [line, column] = place(position_);
        value.line = line;
        value.column = column;
    }

    /// Line and column from 1, in bytes. Counts on from the last place that was asked for, so that marking
    /// every value costs one pass over the text.
    std::pair<int, int> place(std::size_t position) const {
        if (position < counted_to_) {
            counted_to_ = 0;
            line_ = 1;
            line_start_ = 0;
        }
        for (; counted_to_ < position; ++counted_to_) {
            if (text_[counted_to_] == '\n') {
                ++line_;
                line_start_ = counted_to_ + 1;
            }
        }
        return {line_, static_cast<int>(position - line_start_) + 1};
    }

    bool fail(const std::string& what) { return fail_at(position_, what); }
    bool fail_at(std::size_t position, const std::string& what) {
        if (error_) return false;
        const auto [line, column] = place(std::min(position, text_.size()));
        error_ = std::string(name_) + ':' + std::to_string(line) + ':' + std::to_string(column) + ": " + what;
        return false;
    }
    engine::Error fail_result(const std::string& what) {
        fail(what);
        return engine::Error{*error_};
    }

    std::string_view word_ahead() const {
        std::size_t length = 0;
        while (is_letter(peek(length)) || (length > 0 && is_digit(peek(length)))) ++length;
        return text_.substr(position_, length);
    }

    /// What stands at the position, for a message.
    std::string found() const {
        if (at_end()) return "the end of the file";
        if (const std::string_view word = word_ahead(); !word.empty()) return '"' + std::string(word) + '"';
        const char c = peek();
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            return "the byte " + std::to_string(static_cast<unsigned char>(c));
        }
        return std::string("'") + c + "'";
    }

    /// Skips white space and comments.
    void skip_space() {
        while (!at_end()) {
            const char c = peek();
            if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v') {
                ++position_;
            } else if (c == '-' && peek(1) == '-') {
                const std::size_t start = position_;
                position_ += 2;
                std::string ignored;
                if (long_bracket_level()) {
                    if (!long_text(ignored, start, "comment")) return;
                } else {
                    while (!at_end() && peek() != '\n') ++position_;
                }
            } else {
                return;
            }
        }
    }

    /// The number of = in [==[ at the position, if one opens there.
    std::optional<std::size_t> long_bracket_level() const {
        if (peek() != '[') return std::nullopt;
        std::size_t level = 0;
        while (peek(1 + level) == '=') ++level;
        return peek(1 + level) == '[' ? std::optional(level) : std::nullopt;
    }

    bool long_text(std::string& out, std::size_t start, const char* what) {
        const std::size_t level = *long_bracket_level();
        const std::string close = ']' + std::string(level, '=') + ']';
        position_ += level + 2;
        if (peek() == '\r' && peek(1) == '\n') ++position_;
        if (peek() == '\n') ++position_;
        const std::size_t end = text_.find(close, position_);
        if (end == std::string_view::npos) {
            return fail_at(start, std::string("this long ") + what + " is never closed; expected " + close);
        }
        out = text_.substr(position_, end - position_);
        position_ = end + close.size();
        return true;
    }

    bool value(Value& out, int depth) {
        mark(out);
        const char c = peek();
        if (c == '{') return table(out, depth);
        if (c == '"' || c == '\'') {
            std::string text;
            if (!quoted(text)) return false;
            out.content = std::move(text);
            return true;
        }
        if (long_bracket_level()) {
            std::string text;
            if (!long_text(text, position_, "string")) return false;
            out.content = std::move(text);
            return true;
        }
        if (is_digit(c) || c == '-' || c == '.') return number(out);
        const std::string_view word = word_ahead();
        if (word == "true" || word == "false") {
            out.content = word == "true";
            position_ += word.size();
            return true;
        }
        if (word == "nil") return fail("nil cannot be a value here; leave the entry out");
        if (word == "function")
            return fail("a function cannot stand here: this file is data and is never run");
        if (!word.empty()) {
            is_passable_ = true;
            return fail("\"" + std::string(word) + "\" is a name, and this file is data: write a number, \"" +
                        std::string(word) + "\" in quotes, true, false or a table");
        }
        return fail("expected a value (a number, a string, true, false or a table), found " + found());
    }

    bool table(Value& out, int depth) {
        mark(out);
        if (depth > kMaxTableDepth) {
            return fail("tables are nested more than " + std::to_string(kMaxTableDepth) + " deep");
        }
        const std::size_t start = position_++;
        Entries entries;
        std::set<Key> keys;
        std::int64_t next_index = 1;
        while (true) {
            skip_space();
            if (error_) return false;
            if (at_end()) return fail_at(start, "this table is never closed; expected }");
            if (peek() == '}') break;
            const std::size_t entry_start = position_;
            Entry entry;
            if (!key(entry.key, next_index)) return is_passable_ = false;
            if (!value(entry.value, depth + 1) && !pass_over(entry.value)) return false;
            if (!keys.insert(entry.key).second)
                return fail_at(entry_start, key_name(entry.key) + " is given twice");
            entries.push_back(std::move(entry));
            skip_space();
            if (error_) return false;
            if (peek() != ',' && peek() != ';' && peek() != '}' && !at_end()) {
                fail("expected , or } after a value, found " + found());
                is_passable_ = !is_letter(peek());  // "1 / 2"; "1 width = 2" lacks a comma
                if (!pass_over(entries.back().value)) return false;
            }
            if (peek() == ',' || peek() == ';') {
                ++position_;
            } else if (at_end()) {
                return fail_at(start, "this table is never closed; expected }");
            }
        }
        ++position_;
        out.content = std::move(entries);
        return true;
    }

    /// After an error in a value: to the end of the entry, where that is sure to be found. The error is a
    /// fault then and the value unreadable.
    bool pass_over(Value& value) {
        if (faults_ == nullptr || !std::exchange(is_passable_, false)) return false;
        const std::string error = *std::exchange(error_, std::nullopt);
        for (std::string closers; !at_end();) {
            const char c = peek();
            std::string text;
            if (c == '-' && peek(1) == '-') {
                skip_space();
            } else if (c == '"' || c == '\'') {
                quoted(text);
            } else if (long_bracket_level()) {
                long_text(text, position_, "string");
            } else if (word_ahead() == "function") {
                break;  // its end is one of several that stand in it
            } else if (closers.empty() && (c == ',' || c == ';' || c == '}')) {
                faults_->push_back(error);
                value.content = false;
                value.is_unreadable = true;
                return true;
            } else {
                if (c == '(') closers += ')';
                if (c == '[') closers += ']';
                if (c == '{') closers += '}';
                if (!closers.empty() && c == closers.back()) closers.pop_back();
                position_ += std::max<std::size_t>(1, word_ahead().size());
            }
            if (error_) break;
        }
        error_ = error;
        return false;
    }

    static std::string key_name(const Key& key) {
        if (const auto* name = std::get_if<std::string>(&key)) return '"' + *name + '"';
        return '[' + std::to_string(std::get<std::int64_t>(key)) + ']';
    }

    /// `name =`, `[key] =`, or nothing: then the next index is the key.
    bool key(Key& out, std::int64_t& next_index) {
        if (peek() == '[' && !long_bracket_level()) {
            const std::size_t start = position_++;
            skip_space();
            Value content;
            if (!value(content, kMaxTableDepth)) return false;
            if (content.kind() == Value::Kind::Integer) {
                out = std::get<std::int64_t>(content.content);
            } else if (content.kind() == Value::Kind::String) {
                out = content.text();
            } else {
                return fail_at(start, "a key must be a string or an integer");
            }
            skip_space();
            if (peek() != ']') return fail("expected ] after the key, found " + found());
            ++position_;
            return equals_sign();
        }
        const std::string_view word = word_ahead();
        if (!word.empty()) {
            const std::size_t start = position_;
            position_ += word.size();
            skip_space();
            if (peek() == '=' && peek(1) != '=') {
                out = std::string(word);
                return equals_sign();
            }
            position_ = start;
        }
        out = next_index++;
        return true;
    }

    bool equals_sign() {
        skip_space();
        if (peek() != '=') return fail("expected = after the key, found " + found());
        ++position_;
        skip_space();
        return !error_;
    }

    bool number(Value& out) {
        const std::size_t start = position_;
        const bool is_negative = peek() == '-';
        if (is_negative) {
            ++position_;
            skip_space();
        }
        const std::size_t digits_start = position_;
        const bool is_hex = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
        if (is_hex) position_ += 2;
        const std::size_t body = position_;
        bool is_float = false;
        while (!at_end()) {
            const char c = peek();
            const bool is_exponent = is_hex ? (c == 'p' || c == 'P') : (c == 'e' || c == 'E');
            if (is_exponent || c == '.') {
                is_float = true;
                ++position_;
                if (is_exponent && (peek() == '+' || peek() == '-')) ++position_;
            } else if (is_hex ? is_hex_digit(c) : is_digit(c)) {
                ++position_;
            } else {
                break;
            }
        }
        const bool runs_on = is_letter(peek()) || is_digit(peek());
        const std::string digits(text_.substr(body, position_ - body));
        if (runs_on || !convert(digits, is_hex, is_float, out)) {
            while (is_letter(peek()) || is_digit(peek()) || peek() == '.') ++position_;
            is_passable_ = true;
            if (position_ == digits_start) return fail("expected a number after -, found " + found());
            const std::string word(text_.substr(start, position_ - start));
            return fail_at(start, "\"" + word + "\" is not a number");
        }
        if (is_negative) {
            if (auto* integer = std::get_if<std::int64_t>(&out.content)) {
                *integer = static_cast<std::int64_t>(-static_cast<std::uint64_t>(*integer));
            } else {
                out.content = -std::get<double>(out.content);
            }
        }
        if (const auto* real = std::get_if<double>(&out.content); real != nullptr && !std::isfinite(*real)) {
            return fail_at(start, "the number is too large");
        }
        return true;
    }

    /// As Lua does: an integer that does not fit is a float when decimal, and wraps around when hexadecimal.
    static bool convert(const std::string& digits, bool is_hex, bool is_float, Value& out) {
        if (digits.empty()) return false;
        const char* end = digits.data() + digits.size();
        if (!is_float && is_hex) {
            std::uint64_t bits = 0;
            for (const char c : digits) bits = bits << 4 | static_cast<std::uint64_t>(hex_value(c));
            out.content = static_cast<std::int64_t>(bits);
            return true;
        }
        if (!is_float) {
            std::int64_t integer = 0;
            const auto [stop, status] = std::from_chars(digits.data(), end, integer);
            if (status == std::errc{} && stop == end) {
                out.content = integer;
                return true;
            }
        }
        double real = 0;
        const auto format = is_hex ? std::chars_format::hex : std::chars_format::general;
        const auto [stop, status] = std::from_chars(digits.data(), end, real, format);
        if (stop != end || status == std::errc::invalid_argument) return false;
        // Out of range is left at 0 by from_chars; only an overflow is an error, which an exponent sign tells
        // apart.
        if (status == std::errc::result_out_of_range && digits.find('-') == std::string::npos)
            real = HUGE_VAL;
        out.content = real;
        return true;
    }

    bool quoted(std::string& out) {
        const std::size_t start = position_;
        const char quote = text_[position_++];
        while (true) {
            if (at_end() || peek() == '\n') return fail_at(start, "this string is never closed");
            const char c = text_[position_++];
            if (c == quote) return true;
            if (c != '\\') {
                out += c;
            } else if (!escape(out)) {
                return false;
            }
        }
    }

    /// What follows a back-slash inside quotes.
    bool escape(std::string& out) {
        const std::size_t start = position_ - 1;
        if (at_end()) return fail_at(start, "this string is never closed");
        const char c = text_[position_++];
        switch (c) {
            case 'a':
                out += '\a';
                return true;
            case 'b':
                out += '\b';
                return true;
            case 'f':
                out += '\f';
                return true;
            case 'n':
                out += '\n';
                return true;
            case 'r':
                out += '\r';
                return true;
            case 't':
                out += '\t';
                return true;
            case 'v':
                out += '\v';
                return true;
            case '\\':
            case '"':
            case '\'':
            case '\n':
                out += c;
                return true;
            case 'x':
                return hex_escape(out, start);
            case 'u':
                return unicode_escape(out, start);
            case 'z':
                while (!at_end() && std::string_view(" \t\r\n\f\v").find(peek()) != std::string_view::npos)
                    ++position_;
                return true;
            default:
                break;
        }
        if (!is_digit(c)) return fail_at(start, std::string("unknown escape \\") + c + " in a string");
        int code = c - '0';
        for (int i = 0; i < 2 && is_digit(peek()); ++i) code = code * 10 + (text_[position_++] - '0');
        if (code > 255) return fail_at(start, "the escape \\" + std::to_string(code) + " is above 255");
        out += static_cast<char>(code);
        return true;
    }

    bool hex_escape(std::string& out, std::size_t start) {
        if (!is_hex_digit(peek()) || !is_hex_digit(peek(1)))
            return fail_at(start, "\\x needs two hexadecimal digits");
        out += static_cast<char>(hex_value(peek()) * 16 + hex_value(peek(1)));
        position_ += 2;
        return true;
    }

    bool unicode_escape(std::string& out, std::size_t start) {
        std::uint32_t code = 0;
        int digits = 0;
        if (peek() == '{') {
            ++position_;
            for (; is_hex_digit(peek()) && code <= 0x10ffff; ++digits) {
                code = code * 16 + static_cast<std::uint32_t>(hex_value(text_[position_++]));
            }
        }
        if (digits == 0 || peek() != '}' || code > 0x10ffff) {
            return fail_at(start, "\\u needs a code point up to 10FFFF in braces, such as \\u{2605}");
        }
        ++position_;
        append_utf8(out, code);
        return true;
    }

    std::string_view text_;
    std::string_view name_;
    std::size_t position_ = 0;
    std::optional<std::string> error_;
    std::vector<std::string>* faults_;
    bool is_passable_ = false;  ///< the error is about a value alone
    mutable std::size_t counted_to_ = 0;
    mutable std::size_t line_start_ = 0;
    mutable int line_ = 1;
};

}  // namespace

engine::Result<Value> parse_table_text(std::string_view text, std::string_view name) {
    return Parser(code_of(text), name, nullptr).file();
}

engine::Result<Value> parse_faulty_table_text(std::string_view text, std::string_view name,
                                              std::vector<std::string>& faults) {
    return Parser(code_of(text), name, &faults).file();
}

}  // namespace cairn::scripting
