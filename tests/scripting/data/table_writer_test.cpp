#include "data/table_writer.h"

#include <catch2/catch.hpp>

#include "data/table_parser.h"

namespace cairn::scripting {
namespace {

Value parsed(const std::string& text) {
    auto value = parse_table_text(text, "f");
    if (!value) FAIL(value.error().message);
    return *std::move(value);
}

TEST_CASE("a written table is read back as it was") {
    for (const char* text : {
             "{}",
             "{ 1, 2, 3 }",
             "{ a = 1, b = 'two', c = { true, false }, [9] = 0.1, ['not a name'] = 1e300, ['end'] = 3.0 }",
             "{ text = 'quotes \" and \\\\ and \\n and \\0 and \\u{2605}', deep = { { { x = -1 } } } }",
             "{ [2] = 'b', [1] = 'a' }",
         }) {
        INFO(text);
        const std::string once = to_table_file(parsed(text));
        CHECK(to_table_file(parsed(once)) == once);
    }
}

TEST_CASE("numbers keep every bit and their kind") {
    const Value value = parsed(to_table_text(parsed("{ 0.1, 3.0, 3, -0.0, 1e-320, 123456789012345678 }")));
    CHECK(value.entries()[0].value.number() == 0.1);
    CHECK(value.entries()[1].value.kind() == Value::Kind::Number);
    CHECK(value.entries()[2].value.kind() == Value::Kind::Integer);
    CHECK(value.entries()[4].value.number() == 1e-320);
    CHECK(value.entries()[5].value.kind() == Value::Kind::Integer);
}

TEST_CASE("tables are written to be read by people") {
    CHECK(to_table_file(parsed("{ name = 'One', size = { 1, 2 } }")) ==
          "return {\n    name = \"One\",\n    size = { 1, 2 },\n}\n");
}

}  // namespace
}  // namespace cairn::scripting
