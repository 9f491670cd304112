// Golden hashes: the approved state hash of a scene or a replay, one file each in tests/golden.
// Invariant: only tools/check/approve writes those files, with a reason; a test reads and compares.
// A test case that compares with a golden carries the tag [golden], so that `approve --from-run` finds it.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

namespace cairn::test {

// The approved hash of `name` as 16 hexadecimal digits; empty when nothing has been approved yet.
std::string golden_hash(const std::string& name);

// A state hash in the form that goldens have: 16 lower-case hexadecimal digits.
std::string hash_text(std::uint64_t hash);

// REQUIRE_THAT(hash_text(world.state_hash()), MatchesGolden("pyramid")): on a mismatch the report holds the
// command that would approve the new value.
class MatchesGolden : public Catch::MatcherBase<std::string> {
  public:
    explicit MatchesGolden(std::string name);
    bool match(const std::string& actual) const override;
    std::string describe() const override;

  private:
    std::string name_;
    std::string approved_;
    mutable std::string actual_;  // Catch describes a matcher without the value that it has matched.
};

}  // namespace cairn::test
