// Films a few frames where ffmpeg is installed, and asks for errors where it is not or cannot write.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <cairn/engine/video.h>

#include "engine/support/temporary_folder.h"

namespace cairn::engine {
namespace {

namespace fs = std::filesystem;

/// Sets $PATH as long as it exists.
class PathVariable {
  public:
    explicit PathVariable(const std::string& path) : before_(std::getenv("PATH")) {
        setenv("PATH", path.c_str(), 1);
    }
    ~PathVariable() { setenv("PATH", before_.c_str(), 1); }
    PathVariable(const PathVariable&) = delete;
    PathVariable& operator=(const PathVariable&) = delete;

  private:
    std::string before_;
};

/// A program called ffmpeg that does what a shell script says.
PathVariable stand_in(const TemporaryFolder& folder, const std::string& script) {
    folder.put("ffmpeg", "#!/bin/sh\n" + script + "\n");
    fs::permissions(folder.path() / "ffmpeg", fs::perms::owner_all);
    return PathVariable(folder.path().string() + ":/usr/bin:/bin");
}

Image plain(Size size, std::uint8_t value) {
    return {size, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * size.width * size.height), value)};
}

TEST_CASE("every byte of every frame goes into the program") {
    const TemporaryFolder folder;
    const std::string received = (folder.path() / "received").string();
    const PathVariable path =
        stand_in(folder, "cat > '" + received + "'; echo \"$@\" > '" + received + ".arguments'");
    auto video = VideoWriter::create((folder.path() / "a.mp4").string(), {64, 48}, 30);
    REQUIRE(video);
    for (std::uint8_t i = 1; i <= 20; ++i) REQUIRE((*video)->write(plain({64, 48}, i)));
    REQUIRE((*video)->finish());
    std::ifstream file(received, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    REQUIRE(bytes.size() == 20 * 4 * 64 * 48);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (bytes[i] != static_cast<char>(1 + i / (4 * 64 * 48))) FAIL("byte " << i);
    }
    std::ifstream arguments(received + ".arguments");
    const std::string line((std::istreambuf_iterator<char>(arguments)), {});
    CHECK(line.find("-s 64x48 -r 30") != std::string::npos);
}

TEST_CASE("a missing ffmpeg is named, with the way out") {
    const TemporaryFolder folder;
    const PathVariable path(folder.path().string());
    const auto video = VideoWriter::create("a.mp4", {64, 48}, 60);
    REQUIRE_FALSE(video);
    CHECK(video.error().message.find("ffmpeg, which is not installed") != std::string::npos);
}

TEST_CASE("a program that ends in the middle is an error, not the end of this one") {
    const TemporaryFolder folder;
    const PathVariable path = stand_in(folder, "head -c 100 >/dev/null; echo broken >&2; exit 1");
    auto video = VideoWriter::create((folder.path() / "a.mp4").string(), {256, 256}, 60);
    REQUIRE(video);
    std::string error;
    for (int i = 0; i < 50 && error.empty(); ++i) {
        const auto written = (*video)->write(plain({256, 256}, 7));
        if (!written) error = written.error().message;
    }
    CHECK_THAT(error, Catch::EndsWith("ffmpeg says: broken"));
}

TEST_CASE("what the program says is an error, though it ends as if all were well") {
    const TemporaryFolder folder;
    const PathVariable path = stand_in(folder, "cat >/dev/null; echo 'No space left' >&2; exit 0");
    auto video = VideoWriter::create((folder.path() / "a.mp4").string(), {64, 48}, 60);
    REQUIRE(video);
    REQUIRE((*video)->write(plain({64, 48}, 1)));
    const auto finished = (*video)->finish();
    REQUIRE_FALSE(finished);
    CHECK_THAT(finished.error().message, Catch::EndsWith("could not be written: ffmpeg says: No space left"));
}

TEST_CASE("frames of another size and folders that are not there are errors") {
    const TemporaryFolder folder;
    const PathVariable path = stand_in(folder, "cat >/dev/null");
    auto video = VideoWriter::create((folder.path() / "a.mp4").string(), {64, 48}, 60);
    REQUIRE(video);
    CHECK_FALSE((*video)->write(plain({48, 64}, 1)));
    CHECK_FALSE(VideoWriter::create((folder.path() / "none" / "a.mp4").string(), {64, 48}, 60));
}

}  // namespace
}  // namespace cairn::engine
