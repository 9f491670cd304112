// Images: header sizes, round trips through PNG, and damaged files.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include <cairn/engine/image.h>

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

TEST_CASE("premultiplied colors are the colors times their alpha, rounded") {
    Image image{{3, 1}, {10, 20, 30, 255, 200, 100, 1, 51, 255, 255, 255, 0}};
    premultiply(image);
    CHECK(image.rgba == std::vector<std::uint8_t>{10, 20, 30, 255, 40, 20, 0, 51, 0, 0, 0, 0});
}
