#include "support/golden.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "support/source_path.h"

namespace cairn::test {
namespace {

constexpr char kHashField[] = "hash: ";

// `approve --from-run` names a file in this variable and reads there what the tests have computed.
void report_to_approve(const std::string& name, const std::string& actual) {
    const char* path = std::getenv("CAIRN_GOLDEN_REPORT");
    if (path != nullptr) std::ofstream(path, std::ios::app) << name << ' ' << actual << '\n';
}

}  // namespace

std::string golden_hash(const std::string& name) {
    std::ifstream file(source_path("tests/golden/" + name + ".txt"));
    std::string line;
    if (!std::getline(file, line) || line.rfind(kHashField, 0) != 0) return {};
    return line.substr(sizeof kHashField - 1);
}

std::string hash_text(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

MatchesGolden::MatchesGolden(std::string name) : name_(std::move(name)), approved_(golden_hash(name_)) {}

bool MatchesGolden::match(const std::string& actual) const {
    actual_ = actual;
    report_to_approve(name_, actual);
    return actual == approved_;
}

std::string MatchesGolden::describe() const {
    const std::string expected =
        approved_.empty() ? "has no approved value in tests/golden" : "was approved as " + approved_;
    return "matches the golden " + name_ + ", which " + expected +
           "\nIf the change is intended, approve it: tools/check/approve " + name_ + " " + actual_ +
           " --reason \"why it changed\"";
}

}  // namespace cairn::test
