// The slingshot from outside: its recorded run wins with the approved hash, and its picture shows the level.
// Oracles: the golden hash; the level file's places, projected by its camera, and the palette of the
// textures.
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <unistd.h>
#include <vector>

#include <cairn/engine/camera.h>
#include <cairn/engine/image.h>

#include "engine/support/temporary_folder.h"
#include "games/support/program.h"
#include "support/golden.h"
#include "support/source_path.h"

using cairn::test::MatchesGolden;
using cairn::test::ProgramRun;
using cairn::test::run_cairn;
using cairn::test::source_path;

namespace {

const std::string kReplay = "'" + source_path("games/slingshot/replays/level-01.replay") + "'";

struct Pixel {
    int r, g, b;
};

bool is_sky(Pixel p) {
    return p.b > p.r + 20 && p.g > p.r + 10;
}
bool is_hill(Pixel p) {
    return p.g > p.r + 15 && p.g > p.b + 5;
}
bool is_earth(Pixel p) {
    return p.r > p.g + 25 && p.g > p.b + 10 && p.r < 185;
}
bool is_wood(Pixel p) {
    return p.r > p.g + 25 && p.g > p.b + 30 && p.r > 190;
}
bool is_stone(Pixel p) {
    return std::abs(p.r - p.g) < 14 && p.b >= p.g && p.b < p.g + 26 && p.r > 110 && p.r < 215;
}
bool is_ice(Pixel p) {
    return p.b > 215 && p.b >= p.g && p.g > p.r + 4;
}

// Places in the world where one thing and nothing else can be seen before the first shot.
struct Sample {
    const char* what;
    float x_m, y_m;
    bool (*matches)(Pixel);
};

constexpr Sample kSamples[] = {
    {"left tower, left post", 8.60f, 0.85f, is_wood},
    {"left tower, right post", 10.20f, 0.85f, is_wood},
    {"left tower, floor", 9.00f, 1.89f, is_wood},
    {"left tower, icy wall", 10.20f, 2.90f, is_ice},
    {"left tower, roof", 8.90f, 4.10f, is_wood},
    {"right tower, left pillar", 13.00f, 0.85f, is_stone},
    {"right tower, right pillar", 14.60f, 0.85f, is_stone},
    {"right tower, upper wall", 14.60f, 2.78f, is_wood},
    {"bridge", 10.90f, 4.00f, is_wood},
    {"cairn on the bridge", 11.60f, 4.41f, is_stone},
    {"under the left tower's floor", 9.40f, 1.10f, is_hill},
    {"between the right tower's pillars", 13.80f, 0.90f, is_hill},
    {"above the slingshot", 4.20f, 6.30f, is_sky},
    {"under the grass", 6.00f, -1.05f, is_earth},
};

std::string quoted(const std::filesystem::path& path) {
    return "'" + path.string() + "'";
}

void require_level_in(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
    REQUIRE_FALSE(bytes.empty());
    const auto picture = cairn::engine::decode_image(std::as_bytes(std::span(bytes)), file.string());
    REQUIRE(picture);
    REQUIRE(picture->size.width == 1280);
    REQUIRE(picture->size.height == 720);

    // As the level says: view = { x = 6.6, y = 4.15, height = 10.8 }.
    cairn::engine::Camera2D camera(10.8f, {1280, 720});
    camera.position_m = {6.6f, 4.15f};
    for (const Sample& sample : kSamples) {
        const auto place = camera.to_screen({sample.x_m, sample.y_m});
        // The mean of a few pixels, so that one speckle of a texture does not decide.
        Pixel mean{};
        constexpr int kReach = 2;
        constexpr int kCount = (2 * kReach + 1) * (2 * kReach + 1);
        for (int dy = -kReach; dy <= kReach; ++dy) {
            for (int dx = -kReach; dx <= kReach; ++dx) {
                const std::uint8_t* rgba =
                    picture->pixel(static_cast<int>(place.x) + dx, static_cast<int>(place.y) + dy);
                mean.r += rgba[0];
                mean.g += rgba[1];
                mean.b += rgba[2];
            }
        }
        mean = {mean.r / kCount, mean.g / kCount, mean.b / kCount};
        INFO(sample.what << ": color " << mean.r << " " << mean.g << " " << mean.b);
        CHECK(sample.matches(mean));
    }
}

}  // namespace

TEST_CASE("The recorded run of level 1 wins, twice with the approved hash", "[golden]") {
    const std::string arguments = "play slingshot --headless --hash --replay " + kReplay;
    const ProgramRun first = run_cairn(arguments);
    INFO(first.output);
    REQUIRE(first.exit_status == 0);
    CHECK(first.field("result: ") == "won");
    CHECK(first.field("level: ") == "level-01");
    CHECK(std::atoi(first.field("score: ").c_str()) >= 10000);
    CHECK(std::atoi(first.field("stars: ").c_str()) >= 1);

    const ProgramRun second = run_cairn(arguments);
    CHECK(second.output == first.output);
    CHECK_THAT(first.field("hash: "), MatchesGolden("slingshot-level-01"));
}

TEST_CASE("A picture drawn without a display shows the level") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "picture.png";
    const ProgramRun run = run_cairn("play slingshot --headless --frames 60 --screenshot " + quoted(file));
    INFO(run.output);
    REQUIRE(run.exit_status == 0);
    require_level_in(file);
}

TEST_CASE("A window shows the level") {
    if (std::getenv("DISPLAY") == nullptr) {
        WARN("skipped: there is no DISPLAY; run it under xvfb-run");
        return;
    }
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "picture.png";
    const ProgramRun run = run_cairn("play slingshot --frames 60 --screenshot " + quoted(file));
    INFO(run.output);
    REQUIRE(run.exit_status == 0);
    require_level_in(file);
}
