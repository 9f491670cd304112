// UTF-8 decoding against the examples of the Unicode standard and the usual forgeries.
#include <catch2/catch.hpp>
#include <string>

#include <cairn/engine/utf8.h>

namespace {

std::u32string decode(std::string_view text) {
    std::u32string out;
    while (!text.empty()) out += cairn::engine::take_character(text);
    return out;
}

}  // namespace

TEST_CASE("UTF-8 of one to four bytes is decoded") {
    CHECK(decode("a\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80z") == U"a\u00e4\u20ac\U0001f600z");
}

TEST_CASE("each byte that is not UTF-8 becomes one replacement character") {
    CHECK(decode("\x80") == U"\ufffd");
    CHECK(decode("\xc0\xaf") == U"\ufffd\ufffd");            // overlong '/'
    CHECK(decode("\xed\xa0\x80") == U"\ufffd\ufffd\ufffd");  // a surrogate
    CHECK(decode("\xf4\x90\x80\x80").size() == 4);           // above U+10FFFF
    CHECK(decode("\xe2\x82") == U"\ufffd\ufffd");            // cut off
    CHECK(decode("\xe2"
                 "bc") ==
          U"\ufffd"
          U"bc");  // what follows is kept
}
