#include "bridge/junit.h"

#include <catch2/catch.hpp>

namespace cairn::scripting::test {
namespace {

TEST_CASE("results become suites by file, with totals") {
    const std::string xml =
        junit_xml("crates", {{"tests/a.lua", "falls", 0.25, {}},
                             {"tests/a.lua", "stands", 0.5, ScriptError{"a.lua:3: no", {}}},
                             {"tests/b.lua", "rolls", 0.125, {}}});
    CHECK(xml ==
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<testsuites name=\"crates\" tests=\"3\" failures=\"1\" time=\"0.875\">\n"
          "  <testsuite name=\"tests/a.lua\" tests=\"2\" failures=\"1\" time=\"0.750\">\n"
          "    <testcase classname=\"crates.tests/a.lua\" name=\"falls\" time=\"0.250\"/>\n"
          "    <testcase classname=\"crates.tests/a.lua\" name=\"stands\" time=\"0.500\">\n"
          "      <failure message=\"a.lua:3: no\">a.lua:3: no</failure>\n"
          "    </testcase>\n"
          "  </testsuite>\n"
          "  <testsuite name=\"tests/b.lua\" tests=\"1\" failures=\"0\" time=\"0.125\">\n"
          "    <testcase classname=\"crates.tests/b.lua\" name=\"rolls\" time=\"0.125\"/>\n"
          "  </testsuite>\n"
          "</testsuites>\n");
}

TEST_CASE("what XML cannot hold is escaped or replaced") {
    const std::string xml =
        junit_xml("g", {{"t", "a < b & \"c\"\n\x01", 0, ScriptError{"x > 1", {"t:1: in function <main>"}}}});
    CHECK(xml.find("name=\"a &lt; b &amp; &quot;c&quot;&#10;?\"") != std::string::npos);
    CHECK(
        xml.find("<failure message=\"x &gt; 1\">x &gt; 1&#10;    t:1: in function &lt;main&gt;</failure>") !=
        std::string::npos);
}

TEST_CASE("bytes that are no UTF-8 become replacement characters, and others stay") {
    const std::string xml = junit_xml("g", {{"t", "\xff\xc3\xa9\xed\xa0\x80\xef\xbf\xbe", 0, std::nullopt}});
    // One for 0xff, three for the surrogate, and U+FFFE is refused by XML.
    const std::string bad = "\xef\xbf\xbd";
    CHECK(xml.find("name=\"" + bad + "\xc3\xa9" + bad + bad + bad + "?\"") != std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
