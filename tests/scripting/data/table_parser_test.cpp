#include "data/table_parser.h"

#include <catch2/catch.hpp>

#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

std::string error_of(std::string_view text) {
    const auto value = parse_table_text(text, "f.lua");
    return value ? "" : value.error().message;
}

TEST_CASE("with a list for faults, names and sums are told all at once and the rest is read") {
    std::vector<std::string> faults;
    const auto value = parse_faulty_table_text(R"lua({
    a = math.pi / 2, b = 1, c = 3 + 4 * (5, 6), d = f({ 1, 2 }, "},"), -- not, ]]
    { x, -y, "z" .. ")" }, e = -
        [[ , ]] --[[ , ]]; g = 7,
})lua",
                                               "f.lua", faults);
    REQUIRE(value);
    const auto name = [](const std::string& word) {
        return "\"" + word + "\" is a name, and this file is data: write a number, \"" + word +
               "\" in quotes, true, false or a table";
    };
    CHECK(faults == std::vector<std::string>{"f.lua:2:9: " + name("math"),
                                             "f.lua:2:35: expected , or } after a value, found '+'",
                                             "f.lua:2:53: " + name("f"), "f.lua:3:7: " + name("x"),
                                             "f.lua:3:10: \"-y\" is not a number",
                                             "f.lua:3:18: expected , or } after a value, found '.'",
                                             "f.lua:4:9: expected a number after -, found '['"});
    for (const char* key : {"a", "c", "d", "e"}) CHECK(value->find(key)->is_unreadable);
    CHECK(value->find("b")->number() == 1);
    CHECK(value->find("g")->number() == 7);
    CHECK(value->find("a")->line == 2);
    CHECK(value->entries()[4].value.entries().size() == 3);
    // What has no sure end is the last fault.
    for (const char* text :
         {"{ a = x, b = function() return 1, 2 end }", "{ a = x, [y] = 1, c = z }", "{ a = x, b = y",
          "{ a = x, b = 1 c = y }", "{ a = x('y }", "{ a = { [b] = 1 }, c = x }"}) {
        std::vector<std::string> before;
        CHECK_FALSE(parse_faulty_table_text(text, "f.lua", before));
        CHECK(before.size() <= 1);
    }
    // Nothing is passed over without the list.
    CHECK(error_of("{ a = x, b = y }") == "f.lua:1:7: " + name("x"));
}

TEST_CASE("a table of every kind of value is read") {
    const auto value = parse_table_text(R"(
-- a level
return {
    name = "One", 'first', ["with space"] = true; [7] = -3,
    pieces = { { x = 1.5, y = -.25e1 }, { x = 0x10, y = 0xA.8p0 } }, --[[ long
    comment ]] text = [==[
long ]] text]==], escapes = "a\n\t\\\"\65\x42\u{2605}\z
        end",
}
)",
                                        "f.lua");
    REQUIRE(value);
    CHECK(value->find("name")->text() == "One");
    CHECK(std::get<bool>(value->find("with space")->content));
    CHECK(value->find("text")->text() == "long ]] text");
    CHECK(value->find("escapes")->text() ==
          "a\n\t\\\"AB\xe2\x98\x85"
          "end");
    const Value& pieces = *value->find("pieces");
    CHECK(pieces.is_list());
    CHECK(pieces.entries()[0].value.find("y")->number() == -2.5);
    CHECK(std::get<std::int64_t>(pieces.entries()[1].value.find("x")->content) == 16);
    CHECK(pieces.entries()[1].value.find("y")->number() == 10.5);
    CHECK(std::get<std::string>(value->entries()[1].value.content) == "first");
    CHECK(std::get<std::int64_t>(value->entries()[1].key) == 1);
    CHECK(std::get<std::int64_t>(value->entries()[3].key) == 7);
}

TEST_CASE("every value knows its line and column") {
    const auto value = parse_table_text("{\n  a = 1,\n  b = {\n    true } }", "f.lua");
    REQUIRE(value);
    CHECK(value->find("a")->line == 2);
    CHECK(value->find("a")->column == 7);
    CHECK(value->find("b")->entries()[0].value.line == 4);
    CHECK(value->find("b")->entries()[0].value.column == 5);
}

TEST_CASE("integers and floats are those of Lua") {
    const auto value = parse_table_text(
        "{ 9223372036854775807, 9223372036854775808, -9223372036854775808, 3.0, 1e3, 0xffffffffffffffff }",
        "f");
    REQUIRE(value);
    const auto kind = [&](std::size_t i) { return value->entries()[i].value.kind(); };
    CHECK(kind(0) == Value::Kind::Integer);
    CHECK(kind(1) == Value::Kind::Number);
    CHECK(kind(2) == Value::Kind::Number);
    CHECK(kind(3) == Value::Kind::Number);
    CHECK(kind(4) == Value::Kind::Number);
    CHECK(std::get<std::int64_t>(value->entries()[5].value.content) == -1);
}

TEST_CASE("what is not plain data is refused with its place and never run") {
    CHECK(error_of("{ x = os.exit() }") ==
          "f.lua:1:7: \"os\" is a name, and this file is data: write a number, \"os\" in quotes, true, false "
          "or a table");
    CHECK(error_of("{ f = function() end }").find("f.lua:1:7: a function cannot stand here") == 0);
    CHECK(error_of("{ x = nil }").find("f.lua:1:7: nil") == 0);
    CHECK(error_of("{ 1 + 2 }") == "f.lua:1:5: expected , or } after a value, found '+'");
    CHECK(error_of("return { } print(1)") ==
          "f.lua:1:12: expected the end of the file after the table, found \"print\"");
    CHECK(error_of("local t = {}").find("expected a table") != std::string::npos);
    CHECK(error_of("").find("holds no table") != std::string::npos);
}

TEST_CASE("slips are named with line and column") {
    CHECK(error_of("{\n a = 1\n b = 2 }") == "f.lua:3:2: expected , or } after a value, found \"b\"");
    CHECK(error_of("{ a = 1, a = 2 }") == "f.lua:1:10: \"a\" is given twice");
    CHECK(error_of("{ 'x\n' }") == "f.lua:1:3: this string is never closed");
    CHECK(error_of("{ { 1, 2 }") == "f.lua:1:1: this table is never closed; expected }");
    CHECK(error_of("{ --[[ open }").find("comment is never closed") != std::string::npos);
    CHECK(error_of("{ [[ open }").find("string is never closed") != std::string::npos);
    CHECK(error_of("{ 12abc }") == "f.lua:1:3: \"12abc\" is not a number");
    CHECK(error_of("{ 1.2.3 }") == "f.lua:1:3: \"1.2.3\" is not a number");
    CHECK(error_of("{ 1e999 }") == "f.lua:1:3: [1] = 1e999: is too large for a number");
    CHECK(error_of("{ a = { 2, { b = -1e999 } } }") ==
          "f.lua:1:18: a[2].b = -1e999: is too large for a number");
    CHECK(error_of("{ - }").find("number") != std::string::npos);
    CHECK(error_of("{ '\\q' }") == "f.lua:1:4: unknown escape \\q in a string");
    CHECK(error_of("{ '\\999' }") == "f.lua:1:4: the escape \\999 is above 255");
    CHECK(error_of("{ '\\u{110000}' }").find("\\u needs") != std::string::npos);
    CHECK(error_of("{ [1.5] = 2 }").find("a key must be a string or an integer") != std::string::npos);
    CHECK(error_of("{ [1 = 2 }").find("expected ] after the key") != std::string::npos);
    CHECK(error_of(std::string("{ \0 }", 5)).find("the byte 0") != std::string::npos);
}

TEST_CASE("tables nested without end are refused before the stack suffers") {
    CHECK(error_of(std::string(100000, '{')).find("nested more than 64 deep") != std::string::npos);
    std::string brackets;
    for (int i = 0; i < 1000; ++i) brackets += "{[";
    CHECK(error_of(brackets) != "");
}

TEST_CASE("texts that are cut or damaged anywhere give a value or an error, and what Lua reads alike") {
    const std::string text =
        "return { a = 'x\\n', [3] = -0x1p4, { 1, 2.5e-3, true }, --[=[ c ]=] b = [[l]] }";
    State state;
    lua_State* L = state.get();
    int accepted = 0;
    const auto check = [&](const std::string& damaged) {
        const auto value = parse_table_text(damaged, "f");
        if (!value) {
            CHECK(value.error().message.find("f:1:") == 0);
            return;
        }
        ++accepted;
        // What we accept as data, Lua accepts as code, apart from the bare table that only data may be.
        const std::string code = damaged.find("return") == std::string::npos ? "return " + damaged : damaged;
        INFO(damaged);
        CHECK(luaL_loadstring(L, code.c_str()) == LUA_OK);
        lua_settop(L, 0);
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        check(text.substr(0, i));
        for (const char c : {'{', '}', '[', ']', '=', '\'', '\\', '-', 'x', '0', '.', ',', ' '}) {
            std::string damaged = text;
            damaged[i] = c;
            check(damaged);
        }
    }
    CHECK(accepted > 50);
}

}  // namespace
}  // namespace cairn::scripting
