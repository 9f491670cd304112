// The grammar of tables: a recursive-descent parser over the text itself; there is no separate list of
// tokens, because the grammar needs one character of look-ahead (two at comments, long strings and `name =`).
#include "data/table_parser.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "data/source_text.h"
#include "data/table_scanner.h"

namespace cairn::scripting {
namespace {

/// Parsing stops at the first error: every function returns false, or nothing, as soon as `error_` is set.
/// With a list for faults it goes on behind a value that is no data, because its end can be found.
class Parser : private TableScanner {
  public:
    Parser(std::string_view text, std::string_view name, std::vector<std::string>* faults)
        : TableScanner(text, name), faults_(faults) {}

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
    engine::Error fail_result(const std::string& what) {
        fail(what);
        return engine::Error{*error_};
    }

    void mark(Value& value) const {
        const auto [line, column] = place(position_);
        value.line = line;
        value.column = column;
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
        if (is_digit(c) || c == '-' || c == '.') return finite_number(out);
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

    bool finite_number(Value& out) {
        const std::size_t start = position_;
        if (!number(out)) return false;
        const auto* real = std::get_if<double>(&out.content);
        if (real == nullptr || std::isfinite(*real)) return true;
        is_passable_ = true;
        return fail_at(start, path() + " = " + std::string(text_.substr(start, position_ - start)) +
                                  ": is too large for a number");
    }

    /// Of the value that is read: "bodies[3].radius".
    [[nodiscard]] std::string path() const {
        std::string path;
        for (const Key* key : keys_) {
            if (const auto* name = std::get_if<std::string>(key)) {
                path += (path.empty() ? "" : ".") + *name;
            } else {
                path += '[' + std::to_string(std::get<std::int64_t>(*key)) + ']';
            }
        }
        return path;
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
            keys_.push_back(&entry.key);
            const bool is_read = value(entry.value, depth + 1);
            keys_.pop_back();
            if (!is_read && !pass_over(entry.value)) return false;
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

    std::vector<std::string>* faults_;
    std::vector<const Key*> keys_;  ///< of the tables around the value that is read, and its own
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
