// The words of table text: white space and comments, strings, numbers, and where all of this stands.
// Invariant: after the first error nothing more is read; every function returns false, or nothing, as soon as
// `error_` is set.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "data/value.h"

namespace cairn::scripting {

class TableScanner {
  protected:
    TableScanner(std::string_view text, std::string_view name) : text_(text), name_(name) {}

    static bool is_digit(char c) { return c >= '0' && c <= '9'; }
    static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

    bool at_end() const { return position_ >= text_.size(); }
    char peek(std::size_t ahead = 0) const {
        return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
    }
    /// Line and column from 1, in bytes. Counts on from the last place that was asked for, so that marking
    /// every value costs one pass over the text.
    std::pair<int, int> place(std::size_t position) const;
    bool fail(const std::string& what);
    bool fail_at(std::size_t position, const std::string& what);
    std::string_view word_ahead() const;
    /// What stands at the position, for a message.
    std::string found() const;
    /// Skips white space and comments.
    void skip_space();
    /// The number of = in [==[ at the position, if one opens there.
    std::optional<std::size_t> long_bracket_level() const;
    bool long_text(std::string& out, std::size_t start, const char* what);
    /// Infinite when it is too large for a float.
    bool number(Value& out);
    bool quoted(std::string& out);

    std::string_view text_;
    std::string_view name_;
    std::size_t position_ = 0;
    std::optional<std::string> error_;
    bool is_passable_ = false;  ///< the error is about a value alone

  private:
    /// As Lua does: an integer that does not fit is a float when decimal, and wraps around when hexadecimal.
    static bool convert(const std::string& digits, bool is_hex, bool is_float, Value& out);
    /// What follows a back-slash inside quotes.
    bool escape(std::string& out);
    bool hex_escape(std::string& out, std::size_t start);
    bool unicode_escape(std::string& out, std::size_t start);

    mutable std::size_t counted_to_ = 0;
    mutable std::size_t line_start_ = 0;
    mutable int line_ = 1;
};

}  // namespace cairn::scripting
