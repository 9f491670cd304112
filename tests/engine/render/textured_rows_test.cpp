// Textured pixels in SIMD lanes: what the formulas give, at every width the same bytes.
#include "render/surface/textured_rows.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <hwy/highway.h>
#include <vector>

#include <cairn/engine/random.h>

using namespace cairn::engine;

namespace {

struct Scene {
    Image texture;
    std::vector<std::uint8_t> under;
    TexturedRow row;  ///< of no pixels yet
    RowSteps steps;
    Paint paint;
};

float number(Random& random, double low, double high) {
    return static_cast<float>(random.uniform(low, high));
}

/// Premultiplied.
void append_color(Random& random, std::vector<std::uint8_t>& to) {
    const double kind = random.uniform(0, 3);
    const double alpha = kind < 1 ? 0 : kind < 2 ? 255 : random.uniform(0, 255);
    for (int k = 0; k < 3; ++k) to.push_back(static_cast<std::uint8_t>(random.uniform(0, alpha + 0.9)));
    to.push_back(static_cast<std::uint8_t>(alpha));
}

/// Of any size and slant, with parts outside of the texture; in half of them v is the same all along.
Scene random_scene(Random& random) {
    Scene scene;
    scene.texture.size = {static_cast<int>(random.range(1, 60)), static_cast<int>(random.range(1, 9))};
    const bool is_hollow = random.uniform(0, 1) < 0.3;  // long parts are transparent
    for (int i = 0; i < scene.texture.size.width * scene.texture.size.height; ++i) {
        if (is_hollow && i % scene.texture.size.width < 40)
            scene.texture.rgba.insert(scene.texture.rgba.end(), 4, 0);
        else
            append_color(random, scene.texture.rgba);
    }
    scene.row.count = static_cast<int>(random.range(1, 70));
    for (int i = 0; i < scene.row.count + 2; ++i) append_color(random, scene.under);
    const bool is_level = random.uniform(0, 1) < 0.5;
    scene.row.uv = {number(random, -0.2, 1.2), number(random, -0.1, 1.1)};
    scene.steps.uv = {number(random, -3, 3) / static_cast<float>(scene.texture.size.width),
                      is_level ? 0 : number(random, -0.1, 0.1)};
    for (std::size_t k = 0; k < 4; ++k) {
        scene.row.color[k] = number(random, 0, 255);
        const float last = number(random, 0, 255);
        scene.steps.color[k] = (last - scene.row.color[k]) / static_cast<float>(scene.row.count);
    }
    scene.paint.filter = random.uniform(0, 1) < 0.7 ? TextureFilter::Linear : TextureFilter::Nearest;
    constexpr BlendMode kModes[] = {BlendMode::Alpha, BlendMode::Add, BlendMode::Multiply, BlendMode::Screen,
                                    BlendMode::Replace};
    scene.paint.blend = kModes[static_cast<int>(random.range(0, 4))];
    return scene;
}

/// The pixels with one before and one behind, which must stay as they are.
std::vector<std::uint8_t> shade(const Scene& scene) {
    std::vector<std::uint8_t> pixels = scene.under;
    TexturedRow row = scene.row;
    row.pixels = pixels.data() + 4;
    Paint paint = scene.paint;
    paint.texture = &scene.texture;
    shade_textured_rows({&row, 1}, scene.steps, paint);
    return pixels;
}

using Exact = std::array<double, 4>;

Exact texel(const Image& texture, double column, double row) {
    const int x = static_cast<int>(std::clamp(column, 0.0, texture.size.width - 1.0));
    const int y = static_cast<int>(std::clamp(row, 0.0, texture.size.height - 1.0));
    const std::uint8_t* p = texture.pixel(x, y);
    return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0, p[3] / 255.0};
}

Exact sample(const Scene& scene, double u, double v) {
    const Image& texture = scene.texture;
    const double x = u * texture.size.width;
    const double y = v * texture.size.height;
    if (scene.paint.filter == TextureFilter::Nearest) return texel(texture, std::floor(x), std::floor(y));
    const double left = std::floor(std::clamp(x, 0.0, 1.0 * texture.size.width) - 0.5);
    const double top = std::floor(std::clamp(y, 0.0, 1.0 * texture.size.height) - 0.5);
    const double share_x = std::clamp(x, 0.0, 1.0 * texture.size.width) - 0.5 - left;
    const double share_y = std::clamp(y, 0.0, 1.0 * texture.size.height) - 0.5 - top;
    Exact mix{};
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        const Exact part = texel(texture, left + dx, top + dy);
        const double share = (dx == 1 ? share_x : 1 - share_x) * (dy == 1 ? share_y : 1 - share_y);
        for (std::size_t k = 0; k < 4; ++k) mix[k] += share * part[k];
    }
    return mix;
}

/// The formulas, in shares of white.
Exact expected(const Scene& scene, int pixel, const std::uint8_t* under) {
    const double d = pixel;
    const Exact picture = sample(scene, scene.row.uv.x + d * static_cast<double>(scene.steps.uv.x),
                                 scene.row.uv.y + d * static_cast<double>(scene.steps.uv.y));
    Exact color{};
    for (std::size_t k = 0; k < 4; ++k)
        color[k] = (scene.row.color[k] + d * static_cast<double>(scene.steps.color[k])) / 255 * picture[k];
    Exact result{};
    for (std::size_t k = 0; k < 4; ++k) {
        const double c = color[k];
        const double below = under[k] / 255.0;
        switch (scene.paint.blend) {
            case BlendMode::Alpha:
                result[k] = c + below * (1 - color[3]);
                break;
            case BlendMode::Add:
                result[k] = k == 3 ? below : below + c;
                break;
            case BlendMode::Multiply:
                result[k] = k == 3 ? below : below * (c + 1 - color[3]);
                break;
            case BlendMode::Screen:
                result[k] = c + below - c * below;
                break;
            case BlendMode::Replace:
                result[k] = c;
                break;
        }
        result[k] = std::clamp(result[k], 0.0, 1.0);
    }
    return result;
}

/// Beside a step of the nearest filter, rounding decides which texel it is.
bool is_beside_step(const Scene& scene, int pixel) {
    if (scene.paint.filter != TextureFilter::Nearest) return false;
    const auto is_near_whole = [](double place) { return std::abs(place - std::round(place)) < 1e-4; };
    const double u = scene.row.uv.x + pixel * static_cast<double>(scene.steps.uv.x);
    const double v = scene.row.uv.y + pixel * static_cast<double>(scene.steps.uv.y);
    return is_near_whole(u * scene.texture.size.width) || is_near_whole(v * scene.texture.size.height);
}

}  // namespace

TEST_CASE("each textured pixel has what the formulas of filter, tint and blend mode give") {
    Random random(21);
    for (int round = 0; round < 4000; ++round) {
        const Scene scene = random_scene(random);
        const std::vector<std::uint8_t> pixels = shade(scene);
        const int count = scene.row.count;
        CAPTURE(round, count, scene.texture.size.width, scene.steps.uv.x, scene.steps.uv.y);
        for (const std::size_t outside : {std::size_t{0}, 4 * static_cast<std::size_t>(count + 1)})
            REQUIRE(std::equal(pixels.begin() + outside, pixels.begin() + outside + 4,
                               scene.under.begin() + outside));
        double farthest = 0;
        for (int pixel = 0; pixel < count; ++pixel) {
            if (is_beside_step(scene, pixel)) continue;
            const std::size_t at = 4 * static_cast<std::size_t>(pixel + 1);
            const Exact right = expected(scene, pixel, &scene.under[at]);
            for (std::size_t k = 0; k < 4; ++k)
                farthest = std::max(farthest, std::abs(pixels[at + k] - 255 * right[k]));
        }
        REQUIRE(farthest < 0.51);  // half a step, and what floats lose
    }
}

TEST_CASE("textured pixels are the same bytes with the instructions of any processor") {
    const auto pictures = [] {
        Random random(22);
        std::vector<std::uint8_t> all;
        for (int round = 0; round < 3000; ++round) {
            const std::vector<std::uint8_t> pixels = shade(random_scene(random));
            all.insert(all.end(), pixels.begin(), pixels.end());
        }
        return all;
    };
    const std::int64_t all_targets = hwy::SupportedTargets() & HWY_TARGETS;
    const auto use = [](std::int64_t targets) {
        hwy::SetSupportedTargetsForTest(targets);
        hwy::GetChosenTarget().Update(targets);
    };
    const std::vector<std::uint8_t> best = pictures();
    int levels = 0;
    for (std::int64_t left = all_targets; left != 0; left &= left - 1, ++levels) {
        use(left & -left);
        CAPTURE(hwy::TargetName(left & -left));
        CHECK((pictures() == best));
    }
    use(all_targets);
    CHECK(levels >= 1);
}
