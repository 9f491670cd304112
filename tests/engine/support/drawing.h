// A headless platform with a renderer, a folder for the test's own files and the shared assets.
// Invariant: nothing of it needs a display.
#pragma once

#include <catch2/catch.hpp>
#include <cstring>

#include <cairn/engine/files.h>
#include <cairn/engine/platform.h>
#include <cairn/engine/renderer.h>

#include "engine/support/temporary_folder.h"
#include "support/source_path.h"

struct Drawing {
    /// With pixels: into memory; without: the null renderer.
    explicit Drawing(cairn::engine::Size size = {64, 48}, bool with_pixels = true) {
        using namespace cairn::engine;
        auto made_files = Files::create({});
        REQUIRE(made_files);
        files = std::move(*made_files);
        REQUIRE(files->mount(folder.path().string()));
        REQUIRE(files->mount(cairn::test::source_path("assets")));
        PlatformDef def;
        def.headless = true;
        def.headless_drawing = with_pixels;
        def.window.size = size;
        auto made_platform = Platform::create(def);
        REQUIRE(made_platform);
        platform = std::move(*made_platform);
        auto made_renderer = platform->create_renderer(*files);
        REQUIRE(made_renderer);
        renderer = std::move(*made_renderer);
    }

    /// The frame as drawn so far.
    cairn::engine::Image capture() {
        auto image = renderer->capture();
        REQUIRE(image);
        return std::move(*image);
    }

    cairn::engine::FontId font(float size) {
        auto loaded = renderer->load_font("fonts/default.ttf", size);
        REQUIRE(loaded);
        return *loaded;
    }

    void put_png(const std::string& name, const cairn::engine::Image& image) {
        const auto png = cairn::engine::encode_png(image);
        REQUIRE(png);
        folder.put(name, std::string_view(reinterpret_cast<const char*>(png->data()), png->size()));
    }

    TemporaryFolder folder;
    std::unique_ptr<cairn::engine::Files> files;
    std::unique_ptr<cairn::engine::Platform> platform;
    std::unique_ptr<cairn::engine::Renderer> renderer;
};

/// Red, green and blue of a pixel as one number, 0xRRGGBB, which prints and compares well.
inline unsigned rgb(const cairn::engine::Image& image, int x, int y) {
    const std::uint8_t* p = image.pixel(x, y);
    return static_cast<unsigned>(p[0]) << 16 | static_cast<unsigned>(p[1]) << 8 | p[2];
}
