// Drawing into memory on several threads: the same bytes as on one.
#include "render/surface/surface_backend.h"

#include <atomic>
#include <catch2/catch.hpp>

#include <cairn/engine/random.h>

using namespace cairn::engine;

namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 150;

struct Triangles {
    std::vector<RenderVertex> vertices;
    std::vector<int> indices;
};

/// Of all sizes, colors and places, some of them outside.
Triangles random_triangles(Random& random, int count) {
    Triangles made;
    const auto number = [&](double low, double high) {
        return static_cast<float>(random.uniform(low, high));
    };
    const auto byte = [&] { return static_cast<std::uint8_t>(random.uniform(0, 255.9)); };
    for (int i = 0; i < 3 * count; ++i) {
        if (i % 3 == 0)
            made.vertices.push_back({{number(-40, 240), number(-40, 190)}, {}, {}});
        else
            made.vertices.push_back({made.vertices[static_cast<std::size_t>(i - i % 3)].position, {}, {}});
        RenderVertex& vertex = made.vertices.back();
        const float size = i % 2 == 0 ? 60 : 8;
        vertex.position = {vertex.position.x + number(-size, size), vertex.position.y + number(-size, size)};
        vertex.color = {byte(), byte(), byte(), byte()};
        vertex.uv = {number(0, 1), number(0, 1)};
        made.indices.push_back(i);
    }
    return made;
}

Image checkered() {
    Image image{{16, 16}, {}};
    for (int i = 0; i < 256; ++i) {
        const auto shade = static_cast<std::uint8_t>(i * 7);
        image.rgba.insert(image.rgba.end(), {shade, static_cast<std::uint8_t>(255 - i), 90, 255});
    }
    return image;
}

std::vector<std::uint8_t> picture_by(int threads) {
    SurfaceBackend backend([] { return make_viewport({kWidth, kHeight}, {kWidth, kHeight}); }, threads);
    const BackendTexture texture = *backend.create_texture(checkered(), TextureFilter::Linear);
    const BackendTexture canvas = *backend.create_canvas({kWidth, kHeight}, TextureFilter::Nearest);
    Random random(7);
    for (const BackendTexture target : {canvas, BackendTexture{0}}) {
        backend.set_target(target);
        backend.clear({0.2f, 0.3f, 0.4f, 1});
        for (const BlendMode blend : {BlendMode::Alpha, BlendMode::Add, BlendMode::Multiply,
                                      BlendMode::Screen, BlendMode::Replace, BlendMode::Alpha}) {
            const Triangles plain = random_triangles(random, 800);
            backend.draw(plain.vertices, plain.indices, 0, blend, {0, 0, kWidth, kHeight});
            const Triangles textured = random_triangles(random, 800);
            backend.draw(textured.vertices, textured.indices, texture, blend, {13, 7, 150, 101});
        }
    }
    const Triangles copies = random_triangles(random, 500);
    backend.draw(copies.vertices, copies.indices, canvas, BlendMode::Alpha, {0, 0, kWidth, kHeight});
    return backend.read_pixels()->rgba;
}

}  // namespace

TEST_CASE("any number of threads draws the same picture") {
    const std::vector<std::uint8_t> alone = picture_by(1);
    REQUIRE(alone.size() == std::size_t{4} * kWidth * kHeight);
    for (const int threads : {2, 3, 7}) {
        INFO(threads);
        CHECK((picture_by(threads) == alone));
    }
}

TEST_CASE("each part of a job is done once, and all before the next one") {
    for (const int threads : {1, 2, 5}) {
        BandWorkers workers(threads);
        std::vector<std::atomic<int>> done(40);
        for (int job = 1; job <= 300; ++job) {
            const int parts = job % 41;
            for (std::atomic<int>& count : done) count = 0;
            workers.run(parts, [&](int part) { ++done[static_cast<std::size_t>(part)]; });
            bool all_once = true;
            for (int part = 0; part < 40; ++part)
                all_once = all_once && done[static_cast<std::size_t>(part)] == (part < parts ? 1 : 0);
            REQUIRE(all_once);
        }
    }
}
