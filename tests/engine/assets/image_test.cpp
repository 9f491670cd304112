// Images: header sizes, round trips through PNG, and damaged files.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include <cairn/engine/image.h>

#include "engine/support/standard_error.h"
#include "engine/support/temporary_folder.h"
#include "render/backend.h"

using namespace cairn::engine;

namespace {

Image gradient(int width, int height) {
    Image image{{width, height}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x * 7, y * 11, x * y, 255 - x})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
    return image;
}

std::vector<std::byte> png_of(const Image& image) {
    auto png = encode_png(image);
    REQUIRE(png);
    return std::move(*png);
}

std::vector<std::byte> bytes(std::initializer_list<int> values) {
    std::vector<std::byte> out;
    for (const int v : values) out.push_back(static_cast<std::byte>(v));
    return out;
}

template <typename T>
std::string error_of(const Result<T>& result) {
    return result ? "" : result.error().message;
}

}  // namespace

TEST_CASE("an image written as PNG decodes to the same pixels") {
    const Image image = gradient(37, 23);
    const auto png = png_of(image);
    CHECK(*read_image_size(png, "a.png") == image.size);
    const auto decoded = decode_image(png, "a.png");
    REQUIRE(decoded);
    CHECK(decoded->size == image.size);
    CHECK(decoded->rgba == image.rgba);
}

TEST_CASE("a PNG of few or many bits, or with a palette, decodes to what its bytes say") {
    const auto decoded = [](std::string_view text) {
        const auto image = decode_image(std::as_bytes(std::span(text)), "a.png");
        REQUIRE(image);
        return image->rgba;
    };
    using namespace std::string_view_literals;
    // 4 x 1 of one bit: white, black, white, black.
    CHECK(decoded("\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00"
                  "\x00\x04\x00\x00\x00\x01\x01\x00\x00\x00\x00\xd1\x47\x32\x60\x00\x00\x00"
                  "\x0a\x49\x44\x41\x54\x78\x9c\x63\x58\x00\x00\x00\xa2\x00\xa1\xdc\x8d\xb1"
                  "\xcc\x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82"sv) ==
          std::vector<std::uint8_t>{255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255});
    // One of 16 bits a color, of which the upper halves are 0x12, 0x34 and 0x56.
    CHECK(decoded("\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00"
                  "\x00\x01\x00\x00\x00\x01\x10\x02\x00\x00\x00\xc0\xe7\x8f\x9d\x00\x00\x00"
                  "\x0f\x49\x44\x41\x54\x78\x9c\x63\x10\xfa\x6f\xd2\x10\xc6\x00\x00\x08\x6a"
                  "\x02\x1c\x83\xea\xf0\xa8\x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82"sv) ==
          std::vector<std::uint8_t>{0x12, 0x34, 0x56, 255});
    // The two colors of a palette, of which the first is nearly transparent.
    CHECK(decoded("\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00"
                  "\x00\x02\x00\x00\x00\x01\x08\x03\x00\x00\x00\xc3\xfc\x8f\xb8\x00\x00\x00"
                  "\x06\x50\x4c\x54\x45\x0a\x14\x1e\x28\x32\x3c\xd5\x1b\xb4\xe9\x00\x00\x00"
                  "\x01\x74\x52\x4e\x53\x07\xde\x82\x4d\xc5\x00\x00\x00\x0b\x49\x44\x41\x54"
                  "\x78\x9c\x63\x60\x60\x04\x00\x00\x04\x00\x02\xbf\x7a\x3f\x4a\x00\x00\x00"
                  "\x00\x49\x45\x4e\x44\xae\x42\x60\x82"sv) ==
          std::vector<std::uint8_t>{10, 20, 30, 7, 40, 50, 60, 255});
}

TEST_CASE("what the PNG library has to say stands in the error, with the name, and never on standard error") {
    const Image image = gradient(16, 16);
    const auto png = png_of(image);
    constexpr std::size_t kBehindHeader = 33;
    // A text whose checksum is wrong: the library warns of it, and the picture is whole.
    auto warned = png;
    const auto text = bytes({0, 0, 0, 3, 't', 'E', 'X', 't', 'a', 0, 'b', 0, 0, 0, 0});
    warned.insert(warned.begin() + kBehindHeader, text.begin(), text.end());
    // The header's own checksum.
    auto broken = png;
    broken[kBehindHeader - 1] ^= std::byte{1};
    const std::string written = written_to_standard_error([&] {
        const auto decoded = decode_image(warned, "warned.png");
        CHECK((decoded && decoded->rgba == image.rgba));
        CHECK_THAT(error_of(decode_image(broken, "broken.png")),
                   Catch::Contains("image 'broken.png': is damaged: ") && Catch::Contains("CRC"));
        CHECK_THAT(error_of(decode_image(std::span(png).first(60), "short.png")),
                   Catch::Contains("image 'short.png': is damaged: it ends too early"));
    });
    CHECK(written == "");
}

TEST_CASE("a saved PNG file holds the encoded image, and a path that cannot be written is named") {
    TemporaryFolder folder;
    const Image image = gradient(5, 4);
    const std::string path = (folder.path() / "a.png").string();
    REQUIRE(save_png(image, path));
    std::ifstream file(path, std::ios::binary);
    const std::string written((std::istreambuf_iterator<char>(file)), {});
    const auto png = png_of(image);
    CHECK(written == std::string(reinterpret_cast<const char*>(png.data()), png.size()));
    CHECK_THAT(error_of(save_png(image, "/no/such/folder/a.png")), Catch::Contains("/no/such/folder/a.png"));
}

TEST_CASE("a damaged image gives an error that names it, wherever it is cut off") {
    const auto png = png_of(gradient(16, 16));
    for (std::size_t length = 0; length + 13 < png.size(); length += 7) {
        INFO("the first " << length << " bytes");
        CHECK_THAT(error_of(decode_image(std::span(png).first(length), "broken.png")),
                   Catch::Contains("'broken.png'"));
    }
}

TEST_CASE("a file that is no image gives an error that says what would be right") {
    CHECK_THAT(error_of(read_image_size(bytes({'G', 'I', 'F', '8', '9', 'a'}), "a.gif")),
               Catch::Contains("'a.gif'") && Catch::Contains("neither a PNG nor a JPEG"));
    CHECK_FALSE(read_image_size({}, "empty"));
}

TEST_CASE("an image whose header states too large a size is refused before it is decoded") {
    auto png = png_of(gradient(4, 4));
    png[16] = std::byte{0x7f};  // the most significant byte of the width
    CHECK_THAT(error_of(decode_image(png, "bomb.png")), Catch::Contains("8192"));
    png[16] = png[17] = png[18] = png[19] = std::byte{0};
    CHECK_FALSE(decode_image(png, "zero.png"));
}

TEST_CASE("the size of a JPEG is found behind its other segments") {
    // Start of image, an APP0 segment of 4 bytes, a DHT segment of 3 bytes, a fill byte, and a start of frame
    // of 300 x 200.
    const auto jpeg = bytes({0xff, 0xd8, 0xff, 0xe0, 0, 4, 1,   2, 0xff, 0xc4, 0, 3,    9, 0xff,
                             0xff, 0xc2, 0,    11,   8, 0, 200, 1, 44,   3,    1, 0x11, 0});
    CHECK(*read_image_size(jpeg, "a.jpg") == Size{300, 200});
    for (std::size_t length = 2; length < 23; ++length)
        CHECK_FALSE(read_image_size(std::span(jpeg).first(length), "a.jpg"));
}

TEST_CASE("a JPEG that ends in the middle is an error, and what stands behind its end is nobody's business") {
    std::vector<std::byte> jpeg;
    const auto append = [&](std::initializer_list<int> values, int count = 0, int value = 0) {
        for (const std::byte b : bytes(values)) jpeg.push_back(b);
        jpeg.insert(jpeg.end(), static_cast<std::size_t>(count), static_cast<std::byte>(value));
    };
    // Grey, 64 x 64: each of the 64 blocks is two bits, "as bright as the last" and "no more".
    append({0xff, 0xd8});
    append({0xff, 0xe1, 0, 10, 0xff, 0xd8, 0xff, 0xda, 0, 2, 0xff, 0xd9});  // a preview, which ends
    append({0xff, 0xdb, 0, 67, 0}, 64, 1);
    append({0xff, 0xc0, 0, 11, 8, 0, 64, 0, 64, 1, 1, 0x11, 0});
    append({0xff, 0xc4, 0, 20, 0, 1}, 16);
    append({0xff, 0xc4, 0, 20, 0x10, 1}, 16);
    append({0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0}, 16);
    append({0xff, 0xff, 0xd9});  // after a fill byte
    const auto whole = decode_image(jpeg, "a.jpg");
    REQUIRE(whole);
    CHECK(whole->size == Size{64, 64});
    CHECK(int(whole->pixel(63, 63)[0]) == 128);
    for (std::size_t length = 2; length < jpeg.size(); ++length) {
        INFO("the first " << length << " of " << jpeg.size() << " bytes");
        CHECK_THAT(error_of(decode_image(std::span(jpeg).first(length), "cut.jpg")),
                   Catch::Contains("image 'cut.jpg': is damaged"));
    }
    append({0, 0xff, 1, 2, 3});
    CHECK(decode_image(jpeg, "a.jpg"));
}

TEST_CASE("that a PNG is cut short is found without decoding it, and told as by decoding it") {
    auto png = png_of(gradient(16, 16));
    REQUIRE(check_image(png, "a.png"));
    CHECK(*check_image(png, "a.png") == Size{16, 16});
    for (std::size_t length = 0; length < png.size(); ++length) {
        INFO("the first " << length << " of " << png.size() << " bytes");
        const auto part = std::span(png).first(length);
        CHECK_THAT(error_of(check_image(part, "cut.png")), Catch::StartsWith("image 'cut.png': "));
        CHECK(error_of(check_image(part, "cut.png")) == error_of(decode_image(part, "cut.png")));
    }
    CHECK(error_of(check_image(std::span(png).first(png.size() - 1), "cut.png")) ==
          "image 'cut.png': is damaged: it ends too early");
    png.resize(png.size() + 7);  // what stands behind the end is nobody's business
    CHECK(check_image(png, "a.png"));
    CHECK(decode_image(png, "a.png"));
    png[33] = std::byte{0xff};  // the second chunk says that it is longer than any file
    CHECK_FALSE(check_image(png, "a.png"));
}

TEST_CASE("premultiplied colors are the colors times their alpha, rounded") {
    Image image{{3, 1}, {10, 20, 30, 255, 200, 100, 1, 51, 255, 255, 255, 0}};
    premultiply(image);
    CHECK(image.rgba == std::vector<std::uint8_t>{10, 20, 30, 255, 40, 20, 0, 51, 0, 0, 0, 0});
}
