// The software rasterizer: exact coverage, no seams, exact blending.
#include "render/surface/rasterizer.h"

#include <catch2/catch.hpp>

#include <cairn/engine/random.h>

#include "engine/support/drawing.h"

using namespace cairn::engine;

namespace {

Image black(int width, int height) {
    Image image{{width, height}, {}};
    image.rgba.assign(4 * static_cast<std::size_t>(width) * height, 0);
    return image;
}

PixelRect all_of(const Image& image) {
    return {0, 0, image.size.width, image.size.height};
}

RenderVertex at(float x, float y, Rgba8 color, Vec2 uv = {}) {
    return {{x, y}, color, uv};
}

constexpr Rgba8 kWhite = {255, 255, 255, 255};

void draw(const RenderVertex& a, const RenderVertex& b, const RenderVertex& c, const Paint& paint,
          const PixelRect& clip, Image& target) {
    rasterize_triangle({&a, &b, &c}, {to_fixed(a.position), to_fixed(b.position), to_fixed(c.position)},
                       paint, clip, target);
}

}  // namespace

TEST_CASE("a triangle covers the pixels whose middles lie inside") {
    Image image = black(10, 10);
    draw(at(0, 0, kWhite), at(8, 0, kWhite), at(0, 8, kWhite), {}, all_of(image), image);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) {
            INFO(x << ", " << y);
            // Middles on the slanted edge (x + y == 7) lie on a right edge and are not covered.
            CHECK(rgb(image, x, y) == (x + y < 7 ? 0xffffffu : 0u));
        }
}

TEST_CASE("triangles that share corners cover each pixel exactly once") {
    // A fan around a random middle: adding light of 1 counts how often a pixel is covered.
    constexpr Rgba8 kOne = {1, 1, 1, 255};
    Random random(11);
    for (int round = 0; round < 50; ++round) {
        Image image = black(32, 32);
        const RenderVertex middle =
            at(static_cast<float>(random.uniform(1, 31)), static_cast<float>(random.uniform(1, 31)), kOne);
        std::vector<RenderVertex> rim;
        for (int i = 0; i < 32; i += 4) rim.push_back(at(static_cast<float>(i), 0, kOne));
        for (int i = 0; i < 32; i += 4) rim.push_back(at(32, static_cast<float>(i), kOne));
        for (int i = 32; i > 0; i -= 4) rim.push_back(at(static_cast<float>(i), 32, kOne));
        for (int i = 32; i > 0; i -= 4) rim.push_back(at(0, static_cast<float>(i), kOne));
        for (std::size_t i = 0; i < rim.size(); ++i)
            draw(middle, rim[i], rim[(i + 1) % rim.size()], {.blend = BlendMode::Add}, all_of(image), image);
        bool exactly_once = true;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) exactly_once = exactly_once && rgb(image, x, y) == 0x010101u;
        REQUIRE(exactly_once);
    }
}

TEST_CASE("the winding of a triangle does not matter") {
    Image a = black(16, 16);
    Image b = black(16, 16);
    const RenderVertex p = at(1.3f, 2.1f, {255, 0, 0, 200});
    const RenderVertex q = at(14.2f, 5.7f, {0, 255, 0, 255});
    const RenderVertex r = at(4.9f, 15.5f, {0, 0, 255, 30});
    draw(p, q, r, {}, all_of(a), a);
    draw(p, r, q, {}, all_of(b), b);
    CHECK(a.rgba == b.rgba);
}

TEST_CASE("nothing is drawn outside of the clip, even by huge triangles") {
    Image image = black(16, 16);
    const float far = 1 << 20;
    draw(at(-far, -far, kWhite), at(far, -far, kWhite), at(0, far, kWhite), {}, {4, 5, 6, 7}, image);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            CHECK(rgb(image, x, y) == (x >= 4 && x < 10 && y >= 5 && y < 12 ? 0xffffffu : 0u));
}

TEST_CASE("alpha covers and light adds") {
    Image image = black(1, 1);
    const auto cover = [&](Rgba8 color, BlendMode mode) {
        draw(at(-4, -4, color), at(9, -4, color), at(-4, 9, color), {.blend = mode}, all_of(image), image);
    };
    cover({100, 200, 50, 255}, BlendMode::Alpha);
    CHECK(rgb(image, 0, 0) == 0x64c832u);
    cover({40, 0, 10, 51}, BlendMode::Alpha);  // a fifth of 200, 0, 50
    CHECK(rgb(image, 0, 0) == 0x78a032u);      // 100 + 100/5, 200 - 200/5, 50
    cover({255, 100, 0, 255}, BlendMode::Add);
    CHECK(rgb(image, 0, 0) == 0xffff32u);  // 120 + 255 and 160 + 100, both cut off at 255
}

TEST_CASE("a texture is shown pixel by pixel at its own size and mixed in between") {
    Image texture{{2, 1}, {255, 0, 0, 255, 0, 0, 255, 255}};
    Image image = black(4, 1);
    const auto corner = [&](float x, float y, float u, float v) { return at(x, y, kWhite, {u, v}); };
    draw(corner(0, 0, 0, 0), corner(4, 0, 1, 0), corner(4, 1, 1, 1), {.texture = &texture}, all_of(image),
         image);
    draw(corner(0, 0, 0, 0), corner(4, 1, 1, 1), corner(0, 1, 0, 1), {.texture = &texture}, all_of(image),
         image);
    // Texel middles lie at 1 and 3; pixel middles at 0.5, 1.5, 2.5, 3.5.
    CHECK(rgb(image, 0, 0) == 0xff0000u);
    CHECK(rgb(image, 1, 0) == 0xbf0040u);
    CHECK(rgb(image, 2, 0) == 0x4000bfu);
    CHECK(rgb(image, 3, 0) == 0x0000ffu);
}

TEST_CASE("the nearest filter shows texels as they are, at any size") {
    Image texture{{2, 2}, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
    Image image = black(10, 10);
    const auto corner = [&](float x, float y, float u, float v) { return at(x, y, kWhite, {u, v}); };
    draw(corner(0, 0, 0, 0), corner(10, 0, 1, 0), corner(10, 10, 1, 1),
         {.texture = &texture, .filter = TextureFilter::Nearest}, all_of(image), image);
    draw(corner(0, 0, 0, 0), corner(10, 10, 1, 1), corner(0, 10, 0, 1),
         {.texture = &texture, .filter = TextureFilter::Nearest}, all_of(image), image);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) REQUIRE(rgb(image, x, y) == rgb(texture, x / 5, y / 5));
}
