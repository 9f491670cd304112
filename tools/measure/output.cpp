#include "output.h"

namespace cairn::measure {

void Output::Close::operator()(std::FILE* file) const {
    if (file != stdout) std::fclose(file);
}

Output::Output(const std::string& json) : table_(json == "-" ? stderr : stdout) {
    if (json == "-") {
        lines_.reset(stdout);
    } else if (!json.empty()) {
        lines_.reset(std::fopen(json.c_str(), "w"));
        failed_ = lines_ == nullptr;
    }
}

void Output::line(const std::string& text) {
    if (lines_ == nullptr) return;
    if (std::fprintf(lines_.get(), "%s\n", text.c_str()) < 0) failed_ = true;
}

void Output::row(const std::string& text) {
    std::fprintf(table_, "%s\n", text.c_str());
    std::fflush(table_);
}

bool Output::finish() {
    if (lines_ != nullptr && std::fflush(lines_.get()) != 0) failed_ = true;
    return !failed_;
}

}  // namespace cairn::measure
