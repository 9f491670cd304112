// Text: measures, wrapping, alignment, and letters in the picture.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "engine/support/drawing.h"
#include "render/text_layout.h"
#include "support/source_path.h"

using namespace cairn::engine;

namespace {

constexpr const char* kSentence = "The quick brown fox jumps over the lazy dog.";

/// The box around all pixels that are not black; without area when there is none.
Rect ink(const Image& image) {
    int left = image.size.width, top = image.size.height, right = 0, bottom = 0;
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x)
            if (rgb(image, x, y) != 0) {
                left = std::min(left, x);
                right = std::max(right, x + 1);
                top = std::min(top, y);
                bottom = std::max(bottom, y + 1);
            }
    return {static_cast<float>(left), static_cast<float>(top), static_cast<float>(right - left),
            static_cast<float>(bottom - top)};
}

std::string as_text(const std::vector<TextLine>& lines) {
    std::string out;
    for (const TextLine& line : lines) {
        for (const PlacedCharacter& c : line.characters) out += static_cast<char>(c.character);
        out += '|';
    }
    return out;
}

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE_METHOD(Drawing, "a font whose folder is forgotten is read anew, and the old one still writes") {
    folder.put("mine/own.ttf", text_of(cairn::test::source_path("assets/fonts/default.ttf")));
    const FontId font = *renderer->load_font("mine/own.ttf", 16);
    const FontId other = *renderer->load_font("fonts/default.ttf", 16);
    folder.put("mine/own.ttf", "torn");
    CHECK(*renderer->load_font("mine/own.ttf", 16) == font);
    renderer->forget_files("mine");
    CHECK_FALSE(renderer->load_font("mine/own.ttf", 16));
    CHECK(*renderer->load_font("fonts/default.ttf", 16) == other);
    renderer->begin_frame({0, 0, 0, 1});
    renderer->draw_text(font, "still", {.position = {4, 4}});
    CHECK(ink(capture()).width > 10);
    renderer->end_frame();
}

TEST_CASE("text has the same measure in every renderer") {
    std::vector<Vec2> measures[2];
    for (const bool with_pixels : {false, true}) {
        Drawing d({64, 48}, with_pixels);
        for (const float size : {9.0f, 16.0f, 40.0f})
            for (const float wrap : {0.0f, 100.0f}) {
                const FontId font = d.font(size);
                measures[with_pixels].push_back(d.renderer->measure_text(font, kSentence, wrap));
            }
    }
    CHECK(measures[0] == measures[1]);
}

TEST_CASE_METHOD(Drawing, "a text's measure adds up from its lines") {
    const FontId f = font(20);
    const float line = renderer->line_height(f);
    CHECK(line >= 20);
    CHECK(renderer->measure_text(f, "") == Vec2{0, 0});
    const Vec2 one = renderer->measure_text(f, "wide line");
    CHECK(one.y == line);
    CHECK(renderer->measure_text(f, "wide line\nx").x == one.x);
    CHECK(renderer->measure_text(f, "x\nwide line\n").y == 3 * line);
    CHECK(renderer->measure_text(f, "mm").x == 2 * renderer->measure_text(f, "m").x);
}

TEST_CASE_METHOD(Drawing, "wrapped lines are no wider than they may be and lose no word") {
    const FontId f = font(16);
    for (float wrap = 50; wrap < 400; wrap += 35) {
        INFO("wrap width " << wrap);
        const Vec2 size = renderer->measure_text(f, kSentence, wrap);
        CHECK(size.x <= wrap);
        CHECK(size.y >= renderer->line_height(f) * std::ceil(renderer->measure_text(f, kSentence).x / wrap));
    }
}

TEST_CASE_METHOD(Drawing, "lines break at spaces, and words that are too wide break anywhere") {
    const auto bytes = files->read_bytes("fonts/default.ttf");
    REQUIRE(bytes);
    const auto face = FontFace::open(*bytes, 16, "default");
    REQUIRE(face);
    const auto width = [&](std::string_view text) { return layout_text(*face, text, 0)[0].width; };
    CHECK(as_text(layout_text(*face, "one two three", width("one two ") + 1)) == "one two|three|");
    CHECK(as_text(layout_text(*face, "one two three", width("one two three"))) == "one two three|");
    CHECK(as_text(layout_text(*face, "one two three", width("one two three") - 1)) == "one two|three|");
    CHECK(as_text(layout_text(*face, "one two", width("one"))) == "one|two|");
    CHECK(as_text(layout_text(*face, "iiiiii", width("iii"))) == "iii|iii|");
    CHECK(as_text(layout_text(*face, "a\n\nb\r\n", 0)) == "a||b||");
    CHECK(as_text(layout_text(*face, "m", 1)) == "m|");
    CHECK(layout_text(*face, "one two", width("one"))[0].width == width("one"));
}

TEST_CASE("letters appear where the measure says, sharp and in their color") {
    Drawing d({200, 60});
    const FontId f = d.font(24);
    const Vec2 size = d.renderer->measure_text(f, "HIH");
    d.renderer->begin_frame({0, 0, 0, 1});
    d.renderer->draw_text(f, "HIH", {.position = {20, 10}, .color = {1, 0.5f, 0, 1}});
    const Image image = d.capture();
    const Rect box = ink(image);
    CHECK(box.x >= 20);
    CHECK(box.x <= 24);
    CHECK(box.x + box.width <= 20 + size.x + 1);
    CHECK(box.x + box.width >= 20 + size.x - 5);
    CHECK(box.y >= 10);
    CHECK(box.y + box.height <= 10 + size.y);
    CHECK(box.height == Approx(24 * 0.73).margin(2));  // a capital is about 0.73 of the size in this font
    int full = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 200; ++x) full += rgb(image, x, y) == 0xff8000u;
    CHECK(full > 100);  // the stems are drawn in the pure color
}

TEST_CASE("alignment puts the middle or the end of each line at the position") {
    Drawing d({200, 40});
    const FontId f = d.font(16);
    const auto box = [&](TextAlign align, float x, float wrap) {
        d.renderer->begin_frame({0, 0, 0, 1});
        d.renderer->draw_text(f, "HHH", {.position = {x, 5}, .align = align, .wrap_width = wrap});
        const Rect area = ink(d.capture());
        d.renderer->end_frame();
        return area;
    };
    const float width = d.renderer->measure_text(f, "HHH").x;
    const Rect left = box(TextAlign::Left, 100, 0);
    CHECK(box(TextAlign::Right, 100, 0).x == Approx(left.x - width).margin(1));
    CHECK(box(TextAlign::Center, 100, 0).x == Approx(left.x - width / 2).margin(1));
    CHECK(box(TextAlign::Center, 0, 200).x == Approx(left.x - width / 2).margin(1));
    CHECK(box(TextAlign::Right, 0, 100).x == Approx(left.x - width).margin(1));
}

TEST_CASE("magnified text is drawn anew in its larger size") {
    Drawing d({300, 80});
    const FontId f = d.font(12);
    d.renderer->begin_frame({0, 0, 0, 1});
    REQUIRE(d.renderer->push_transform());
    d.renderer->scale({4, 4});
    d.renderer->draw_text(f, "HIH", {});
    const Image image = d.capture();
    const Rect box = ink(image);
    CHECK(box.height == Approx(48 * 0.73).margin(3));
    CHECK(box.width == Approx(4 * d.renderer->measure_text(f, "HIH").x).margin(8));
    // Sharp: of the pixels with ink, most are full. A picture magnified four times would have wide soft
    // edges.
    int partial = 0;
    int full = 0;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 300; ++x) {
            const unsigned red = rgb(image, x, y) >> 16;
            full += red == 255;
            partial += red > 0 && red < 255;
        }
    CHECK(full > 2 * partial);
}

TEST_CASE_METHOD(Drawing, "thousands of different letters fit through the bounded cache") {
    renderer->begin_frame({0, 0, 0, 1});
    for (int size = 60; size < 200; size += 10) {
        const FontId f = font(static_cast<float>(size));
        std::string text;
        for (char c = '!'; c <= '~'; ++c) text += c;
        renderer->draw_text(f, text, {.position = {-500, 0}});
    }
    renderer->fill_rectangle({0, 0, 64, 48}, {0, 0, 0, 1});
    renderer->draw_text(font(30), "H", {.position = {10, 5}});
    CHECK(ink(capture()).width > 10);
    renderer->end_frame();
}

TEST_CASE_METHOD(Drawing, "text that is not UTF-8, or has no glyphs, or lies at no place, is survived") {
    const FontId f = font(16);
    renderer->begin_frame({0, 0, 0, 1});
    renderer->draw_text(f, std::string_view("\xff\xfe\0\x01\xe2\x82", 6), {.position = {1, 1}});
    renderer->draw_text(f, "\xf4\x8f\xbf\xbf\xe2\x80\x8b", {.position = {1, 20}});
    renderer->draw_text(f, "x", {.position = {std::numeric_limits<float>::quiet_NaN(), 0}});
    CHECK(renderer->measure_text(f, "\xff").x > 0);
    renderer->end_frame();
}

TEST_CASE_METHOD(
    Drawing, "a font that is cut off anywhere is refused by name, or what is left of it can be drawn with") {
    const auto whole = files->read_bytes("fonts/default.ttf");
    REQUIRE(whole);
    int refused = 0;
    constexpr std::size_t kParts = 16;
    for (std::size_t part = 0; part < kParts; ++part) {
        const std::string name = "cut" + std::to_string(part) + ".ttf";
        folder.put(name, std::string_view(reinterpret_cast<const char*>(whole->data()),
                                          whole->size() * part / kParts));
        const auto cut = renderer->load_font(name, 16);
        if (!cut) {
            CHECK_THAT(cut.error().message, Catch::Contains(name));
            ++refused;
            continue;
        }
        renderer->begin_frame({0, 0, 0, 1});
        renderer->draw_text(*cut, "Cairn \u00e4\u03a9\u2026", {.position = {2, 2}});
        renderer->end_frame();
    }
    CHECK(refused > 1);
}

TEST_CASE_METHOD(Drawing, "a missing or damaged font, and a size out of range, are errors that say so") {
    folder.put("broken.ttf", "this is no font");
    CHECK_THAT(renderer->load_font("nosuch.ttf", 16).error().message,
               Catch::Contains("'nosuch.ttf'") && Catch::Contains("not found"));
    CHECK_THAT(renderer->load_font("broken.ttf", 16).error().message, Catch::Contains("'broken.ttf'"));
    CHECK_THAT(renderer->load_font("fonts/default.ttf", 1000).error().message, Catch::Contains("256"));
    CHECK_FALSE(renderer->load_font("fonts/default.ttf", std::numeric_limits<float>::quiet_NaN()));
    CHECK(*renderer->load_font("fonts/default.ttf", 16) == font(16));
}

TEST_CASE_METHOD(Drawing, "wrapped lines are the text again, character for character") {
    const FontId f = font(20);
    const std::string text = "One two  three\n\nfo\xc3\xbcr five";
    const float width = renderer->measure_text(f, "three").x + 1;
    const std::vector<std::string> lines = renderer->wrap_text(f, text, width);
    CHECK(lines == std::vector<std::string>{"One", "two", "three", "", "fo\xc3\xbcr", "five"});
    for (const std::string& line : lines) CHECK(renderer->measure_text(f, line).x <= width);
    CHECK(renderer->wrap_text(f, text, 0) ==
          std::vector<std::string>{"One two  three", "", "fo\xc3\xbcr five"});
    CHECK(renderer->wrap_text(f, "", 0) == std::vector<std::string>{""});
    CHECK(renderer->wrap_text({}, text, 0).empty());
}

TEST_CASE("text in several colors stands where text in one color stands") {
    Drawing d({160, 40});
    const FontId f = d.font(24);
    const auto picture = [&](const TextDraw& draw) {
        d.renderer->begin_frame({0, 0, 0, 1});
        d.renderer->draw_text(f, "ab cd", draw);
        Image image = d.capture();
        d.renderer->end_frame();
        return image;
    };
    const Image plain = picture({.position = {5, 5}});
    const TextSpan spans[] = {{1, {1, 0, 0, 1}}, {3, {0, 1, 0, 1}}};
    const Image colored = picture({.position = {5, 5}, .spans = spans});
    const float b = 5 + d.renderer->measure_text(f, "a").x;
    const float c = 5 + d.renderer->measure_text(f, "ab ").x;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 160; ++x) {
            const int light = plain.pixel(x, y)[2];
            const std::uint8_t* p = colored.pixel(x, y);
            const auto at = static_cast<float>(x) + 0.5f;
            // Two pixels around each border are left out: letters reach over their places.
            if (std::abs(at - b) < 2 || std::abs(at - c) < 2) continue;
            REQUIRE(static_cast<int>(p[0]) == (at < c ? light : 0));
            REQUIRE(static_cast<int>(p[1]) == (at < b || at > c ? light : 0));
            REQUIRE(static_cast<int>(p[2]) == (at < b ? light : 0));
        }
}

TEST_CASE("text that is shown in part shows its first characters where they will stand") {
    Drawing d({200, 100});
    const FontId f = d.font(24);
    const auto picture = [&](std::string_view text, int shown, float spacing = 1) {
        d.renderer->begin_frame({0, 0, 0, 1});
        d.renderer->draw_text(
            f, text,
            {.position = {100, 5}, .align = TextAlign::Center, .line_spacing = spacing, .shown = shown});
        Image image = d.capture();
        d.renderer->end_frame();
        return image;
    };
    const Image all = picture("abc\ndef", -1);
    CHECK(picture("abc\ndef", 7).rgba == all.rgba);
    CHECK(picture("abc\ndef", 3).rgba == picture("abc", -1).rgba);
    CHECK(ink(picture("abc\ndef", 0)).width <= 0);
    // Wider spacing moves the second line and no other.
    const float line = d.renderer->line_height(f);
    CHECK(ink(picture("\ndef", -1, 2)).y - ink(picture("\ndef", -1)).y == Approx(line).margin(1));
    CHECK(d.renderer->measure_text(f, "a\nb\nc", 0, 1.5f).y == Approx(4 * line));
}
