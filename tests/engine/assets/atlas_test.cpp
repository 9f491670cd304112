// Atlases from files of both forms, and everything that can be wrong with them.
#include <catch2/catch.hpp>

#include <cairn/engine/atlas.h>

#include "engine/support/temporary_folder.h"

using namespace cairn::engine;

namespace {

struct Folder {
    Folder() {
        auto made = Files::create({});
        REQUIRE(made);
        files = std::move(*made);
        REQUIRE(files->mount(folder.path().string()));
    }
    Result<Atlas> load(const std::string& text) {
        folder.put("art/atlas.json", text);
        return load_atlas(*files, "art/atlas.json");
    }
    TemporaryFolder folder;
    std::unique_ptr<Files> files;
};

TEST_CASE("what is meant to be an atlas has frames and meta, or is a damaged one") {
    CHECK(is_atlas_text(R"({"frames": {}, "meta": {}})"));
    CHECK(is_atlas_text(R"({"frames": {"a": {"fra)"));
    CHECK(is_atlas_text(R"({"meta": {"image": "a.png"}, )"));
    CHECK_FALSE(is_atlas_text(R"({"frames": 3})"));
    CHECK_FALSE(is_atlas_text(R"([{"frames": {}, "meta": {}}])"));
    CHECK_FALSE(is_atlas_text("{ 'a game may have a form of its own' }"));
    CHECK_FALSE(is_atlas_text(""));
}

}  // namespace

TEST_CASE_METHOD(Folder, "both forms of the format give the same atlas, in the order of the file") {
    const auto hash =
        load(R"({"frames": {"run": {"frame": {"x": 0, "y": 0, "w": 8, "h": 8}, "rotated": false},
        "jump": {"frame": {"x": 8, "y": 0, "w": 4, "h": 6}}}, "meta": {"image": "sheet.png"}})");
    const auto array = load(R"({"frames": [{"filename": "run", "frame": {"x": 0, "y": 0, "w": 8, "h": 8}},
        {"filename": "jump", "frame": {"x": 8, "y": 0, "w": 4, "h": 6}, "trimmed": false}],
        "meta": {"app": "x", "image": "sheet.png"}})");
    REQUIRE(hash);
    REQUIRE(array);
    CHECK(hash->frames == std::vector<AtlasFrame>{{"run", {0, 0, 8, 8}}, {"jump", {8, 0, 4, 6}}});
    CHECK(array->frames == hash->frames);
    CHECK(hash->image_path == "art/sheet.png");
    CHECK(check_atlas(*hash, {12, 8}, "a"));
    CHECK_THAT(check_atlas(*hash, {11, 8}, "a").error().message,
               Catch::Contains("'jump'") && Catch::Contains("11 x 8"));
}

TEST_CASE_METHOD(
    Folder, "an atlas with numbers beyond all or endless nesting is damaged, not the end of the program") {
    std::string deep = "{\"meta\": {\"image\": \"a.png\"}, \"frames\": " + std::string(100'000, '[');
    deep += std::string(100'000, ']') + "}";
    for (const auto& [text, reason] :
         {std::pair<std::string, const char*>{deep, "is nested more than 200 deep"},
          {"{\"frames\": {\"a\": {\"frame\": {\"x\": 1e999}}}, \"meta\": {}}",
           "art/atlas.json:1: is not JSON: column 38: number overflow"}}) {
        CHECK(is_atlas_text(text));

        CHECK_THAT(load(text).error().message, Catch::Contains(reason));
    }
}

TEST_CASE_METHOD(Folder, "a wrong atlas is an error that names the file, the frame and the rule") {
    const auto message = [&](const std::string& text) { return load(text).error().message; };
    CHECK_THAT(load_atlas(*files, "none.json").error().message, Catch::Contains("'none.json'"));
    CHECK_THAT(message("{"), Catch::Contains("art/atlas.json") && Catch::Contains("is not JSON"));
    CHECK_THAT(message("[]"), Catch::Contains("\"frames\" and \"meta\""));
    CHECK_THAT(message(R"({"frames": {}, "meta": {}})"), Catch::Contains("meta.image"));
    const auto with_frame = [&](const std::string& frame) {
        return message(R"({"frames": {"run": )" + frame + R"(}, "meta": {"image": "s.png"}})");
    };
    CHECK_THAT(with_frame("3"), Catch::Contains("'run'") && Catch::Contains("\"frame\""));
    CHECK_THAT(with_frame(R"({"frame": {"x": 0, "y": 0, "w": 8}})"), Catch::Contains("x, y, w and h"));
    CHECK_THAT(with_frame(R"({"frame": {"x": 0, "y": 0, "w": 0, "h": 2}})"), Catch::Contains("above 0"));
    CHECK_THAT(with_frame(R"({"frame": {"x": "a", "y": 0, "w": 0, "h": 2}})"), Catch::Contains("numbers"));
    CHECK_THAT(with_frame(R"({"frame": {}, "rotated": true})"), Catch::Contains("rotation"));
    CHECK_THAT(with_frame(R"({"frame": {}, "trimmed": true})"), Catch::Contains("trimming"));
    CHECK_THAT(message(R"({"frames": 3, "meta": {"image": "s.png"}})"), Catch::Contains("object or a list"));
    CHECK_THAT(message(R"({"frames": [{"frame": {}}], "meta": {"image": "s.png"}})"),
               Catch::Contains("\"filename\""));
    CHECK_THAT(message(R"({"frames": [{"filename": "a", "frame": {"x": 0, "y": 0, "w": 1, "h": 1}},
        {"filename": "a", "frame": {"x": 0, "y": 0, "w": 1, "h": 1}}], "meta": {"image": "s.png"}})"),
               Catch::Contains("two frames are called 'a'"));
}
