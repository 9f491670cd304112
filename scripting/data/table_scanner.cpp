// The lexical conventions of Lua, as far as data needs them. Source: Lua 5.4 Reference Manual, 3.1.
#include "data/table_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace cairn::scripting {
namespace {

bool is_hex_digit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
int hex_value(char c) {
    return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
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

}  // namespace

std::pair<int, int> TableScanner::place(std::size_t position) const {
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

bool TableScanner::fail(const std::string& what) {
    return fail_at(position_, what);
}

bool TableScanner::fail_at(std::size_t position, const std::string& what) {
    if (error_) return false;
    const auto [line, column] = place(std::min(position, text_.size()));
    error_ = std::string(name_) + ':' + std::to_string(line) + ':' + std::to_string(column) + ": " + what;
    return false;
}

std::string_view TableScanner::word_ahead() const {
    std::size_t length = 0;
    while (is_letter(peek(length)) || (length > 0 && is_digit(peek(length)))) ++length;
    return text_.substr(position_, length);
}

std::string TableScanner::found() const {
    if (at_end()) return "the end of the file";
    if (const std::string_view word = word_ahead(); !word.empty()) return '"' + std::string(word) + '"';
    const char c = peek();
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
        return "the byte " + std::to_string(static_cast<unsigned char>(c));
    }
    return std::string("'") + c + "'";
}

void TableScanner::skip_space() {
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

std::optional<std::size_t> TableScanner::long_bracket_level() const {
    if (peek() != '[') return std::nullopt;
    std::size_t level = 0;
    while (peek(1 + level) == '=') ++level;
    return peek(1 + level) == '[' ? std::optional(level) : std::nullopt;
}

bool TableScanner::long_text(std::string& out, std::size_t start, const char* what) {
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

bool TableScanner::number(Value& out) {
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
    return true;
}

bool TableScanner::convert(const std::string& digits, bool is_hex, bool is_float, Value& out) {
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
    if (status == std::errc::result_out_of_range && digits.find('-') == std::string::npos) real = HUGE_VAL;
    out.content = real;
    return true;
}

bool TableScanner::quoted(std::string& out) {
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

bool TableScanner::escape(std::string& out) {
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

bool TableScanner::hex_escape(std::string& out, std::size_t start) {
    if (!is_hex_digit(peek()) || !is_hex_digit(peek(1)))
        return fail_at(start, "\\x needs two hexadecimal digits");
    out += static_cast<char>(hex_value(peek()) * 16 + hex_value(peek(1)));
    position_ += 2;
    return true;
}

bool TableScanner::unicode_escape(std::string& out, std::size_t start) {
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

}  // namespace cairn::scripting
