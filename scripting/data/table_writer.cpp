// Invariant: to_table_text(v) parsed again equals v, to the last bit of each number.
#include "data/table_writer.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include <cairn/engine/printable.h>

namespace cairn::scripting {
namespace {

constexpr std::size_t kIndent = 4;

bool is_name(std::string_view text) {
    static constexpr std::string_view kReserved[] = {
        "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
        "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};
    if (text.empty() || (text[0] >= '0' && text[0] <= '9')) return false;
    for (const char c : text) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        if (!is_letter && !(c >= '0' && c <= '9')) return false;
    }
    for (const std::string_view word : kReserved) {
        if (word == text) return false;
    }
    return true;
}

std::string number_text(double number) {
    if (std::isnan(number)) return "0/0";  // not readable as data: a NaN must not travel unnoticed
    if (std::isinf(number)) return number > 0 ? "1e999" : "-1e999";
    char buffer[40];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
    std::string text(buffer, end);
    // 3.0 stays a float when it is read again.
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

bool is_plain_list(const Value& value) {
    if (!value.is_list()) return false;
    for (const Entry& entry : value.entries()) {
        if (entry.value.kind() == Value::Kind::Table) return false;
    }
    return true;
}

void write(const Value& value, std::size_t depth, std::string& out);

void write_entries(const Value& value, std::size_t depth, std::string& out) {
    const bool is_inline = is_plain_list(value);
    const bool is_list = value.is_list();
    out += '{';
    for (std::size_t i = 0; i < value.entries().size(); ++i) {
        const Entry& entry = value.entries()[i];
        if (is_inline) {
            out += i == 0 ? " " : ", ";
        } else {
            out += '\n' + std::string((depth + 1) * kIndent, ' ');
        }
        if (const auto* name = std::get_if<std::string>(&entry.key)) {
            out += (is_name(*name) ? *name : '[' + quote_text(*name) + ']') + " = ";
        } else if (!is_list || std::get<std::int64_t>(entry.key) != static_cast<std::int64_t>(i + 1)) {
            out += '[' + std::to_string(std::get<std::int64_t>(entry.key)) + "] = ";
        }
        write(entry.value, depth + 1, out);
        if (!is_inline) out += ',';
    }
    if (!value.entries().empty()) out += is_inline ? " " : '\n' + std::string(depth * kIndent, ' ');
    out += '}';
}

void write(const Value& value, std::size_t depth, std::string& out) {
    switch (value.kind()) {
        case Value::Kind::Boolean:
            out += std::get<bool>(value.content) ? "true" : "false";
            return;
        case Value::Kind::Integer: {
            const auto integer = std::get<std::int64_t>(value.content);
            // Lua reads the least integer in decimal as a float: its digits stand for a positive number
            // first.
            const bool is_least = integer == std::numeric_limits<std::int64_t>::min();
            out += is_least ? "0x8000000000000000" : std::to_string(integer);
            return;
        }
        case Value::Kind::Number:
            out += number_text(std::get<double>(value.content));
            return;
        case Value::Kind::String:
            out += quote_text(value.text());
            return;
        case Value::Kind::Table:
            write_entries(value, depth, out);
            return;
    }
}

}  // namespace

std::string shown_name(std::string_view name) {
    for (std::string_view rest = name; !rest.empty();) {
        if (!engine::take_shown(rest).is_printable) return quote_text(name);
    }
    return std::string(name);
}

std::string quote_text(std::string_view text) {
    std::string out = "\"";
    while (!text.empty()) {
        const engine::ShownCharacter c = engine::take_shown(text);
        if (c.bytes == "\"" || c.bytes == "\\") {
            out += '\\';
            out += c.bytes;
        } else if (c.bytes == "\n") {
            out += "\\n";
        } else if (c.is_printable) {
            out += c.bytes;
        } else {
            for (const char byte : c.bytes) {
                char escape[8];
                std::snprintf(escape, sizeof escape, "\\%03d", static_cast<unsigned char>(byte));
                out += escape;
            }
        }
    }
    return out + '"';
}

std::string to_table_text(const Value& value) {
    std::string out;
    write(value, 0, out);
    return out;
}

std::string to_table_file(const Value& value) {
    return "return " + to_table_text(value) + '\n';
}

}  // namespace cairn::scripting
