#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <cairn/engine/native_file.h>

#include "engine/support/file_size_limit.h"
#include "engine/support/temporary_folder.h"

using namespace cairn::engine;

namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ostringstream out;
    out << std::ifstream(path).rdbuf();
    return out.str();
}

std::size_t files_in(const std::filesystem::path& folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

}  // namespace

TEST_CASE("a written file has exactly the new contents") {
    TemporaryFolder folder;
    const auto path = folder.path() / "out";
    REQUIRE(write_native_file(path.string(), "first and longer"));
    REQUIRE(write_native_file(path.string(), "second"));
    CHECK(text_of(path) == "second");
    CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("a full disk keeps the old file, leaves no new one, and is the reason given") {
    TemporaryFolder folder;
    const auto old = folder.path() / "old";
    REQUIRE(write_native_file(old.string(), "precious"));
    const std::string large(100'000, 'x');
    {
        const FileSizeLimit full(4096);
        const auto again = write_native_file(old.string(), large);
        const auto fresh = write_native_file((folder.path() / "fresh").string(), large);
        REQUIRE_FALSE(again);
        CHECK_FALSE(fresh);
        CHECK_THAT(again.error().message, Catch::Contains("cannot write") && Catch::Contains(old.string()) &&
                                              Catch::Contains("large"));
    }
    CHECK(text_of(old) == "precious");
    CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("whether a file could be written is told without touching what is there") {
    TemporaryFolder folder;
    folder.put("old", "precious");
    const auto in = [&](const std::string& name) { return (folder.path() / name).string(); };
    CHECK(check_native_file(in("old")));
    CHECK(check_native_file(in("fresh")));
    CHECK(check_native_file("/dev/null"));
    CHECK(text_of(in("old")) == "precious");
    CHECK(files_in(folder.path()) == 1);
    CHECK_THAT(check_native_file(in("no/such")).error().message,
               Catch::Contains("cannot write \"" + in("no/such") + "\": No such file"));
    CHECK_THAT(check_native_file(folder.path().string()).error().message, Catch::Contains("Is a directory"));
}

TEST_CASE("a link stays a link, and its target gets the contents") {
    TemporaryFolder folder;
    folder.put("target", "old");
    std::filesystem::create_symlink("target", folder.path() / "link");
    REQUIRE(write_native_file((folder.path() / "link").string(), "new"));
    CHECK(std::filesystem::is_symlink(folder.path() / "link"));
    CHECK(text_of(folder.path() / "target") == "new");
}

TEST_CASE("a device is written to and stays what it is") {
    REQUIRE(write_native_file("/dev/null", "gone"));
    CHECK(std::filesystem::is_character_file("/dev/null"));
    CHECK_FALSE(write_native_file("/dev/full", "refused"));
}

TEST_CASE("a folder or a missing one is an error that names the path") {
    TemporaryFolder folder;
    for (const auto& path : {folder.path().string(), (folder.path() / "no/such").string()}) {
        const auto written = write_native_file(path, "x");
        REQUIRE_FALSE(written);
        CHECK_THAT(written.error().message, Catch::Contains('"' + path + '"'));
    }
}
