// Where a tool writes: lines of JSON, and a table for people that gives way to them.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

namespace cairn::measure {

/// Invariant: once something could not be written, `failed` stays true.
class Output {
  public:
    /// `json`: a file, "-" for standard output (the table then goes to standard error), or nothing.
    explicit Output(const std::string& json);

    void line(const std::string& text);  ///< of JSON
    void row(const std::string& text);   ///< of the table
    /// False when something could not be written.
    bool finish();
    [[nodiscard]] bool failed() const { return failed_; }

  private:
    struct Close {
        void operator()(std::FILE* file) const;
    };
    std::FILE* table_;
    std::unique_ptr<std::FILE, Close> lines_;
    bool failed_ = false;
};

}  // namespace cairn::measure
