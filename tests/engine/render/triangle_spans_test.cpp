// Which pixels triangles cover: against the sign of exact cross products, pixel by pixel.
#include "render/surface/triangle_spans.h"

#include <catch2/catch.hpp>
#include <set>
#include <utility>

#include <cairn/engine/random.h>

using namespace cairn::engine;

namespace {

using Pixels = std::set<std::pair<int, int>>;

Pixels covered_by_spans(const Corners& corners, const PixelRect& clip) {
    Pixels pixels;
    const PixelBox box = pixels_near(corners, clip);
    std::array<Span, kMaxSpans> spans;
    for (int row = box.first_row; row <= box.last_row; row += kMaxSpans) {
        PixelBox part = box;
        part.first_row = row;
        part.last_row = std::min(box.last_row, row + kMaxSpans - 1);
        const std::size_t count = box.is_empty() ? 0 : find_spans(corners, part, spans);
        for (std::size_t i = 0; i < count; ++i)
            for (int x = spans[i].first; x <= spans[i].last; ++x) pixels.emplace(x, spans[i].row);
    }
    return pixels;
}

/// A middle on an edge counts when the triangle would hold it after a shift by less than any number to the
/// right, and by much less than that downwards: the top-left rule in other words.
Pixels covered_by_definition(const Corners& p, const PixelRect& clip) {
    Pixels pixels;
    for (int y = clip.y; y < clip.y + clip.height; ++y)
        for (int x = clip.x; x < clip.x + clip.width; ++x) {
            bool is_inside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const FixedPoint a = p[k];
                const FixedPoint b = p[(k + 1) % 3];
                const std::int64_t dx = std::int64_t{b.x} - a.x;
                const std::int64_t dy = std::int64_t{b.y} - a.y;
                const std::int64_t side = dx * (y * 256 + 128 - a.y) - dy * (x * 256 + 128 - a.x);
                const std::int64_t of_shift = dy != 0 ? -dy : dx;
                is_inside = is_inside && (side > 0 || (side == 0 && of_shift > 0));
            }
            if (is_inside) pixels.emplace(x, y);
        }
    return pixels;
}

}  // namespace

TEST_CASE("spans hold the pixels whose middles are inside, for triangles of all sizes") {
    constexpr PixelRect kClip = {3, 5, 90, 110};
    Random random(3);
    std::size_t covered = 0;
    for (const double size_pixels : {1.0, 3.0, 10.0, 50.0, 200.0, 30'000.0})
        for (int round = 0; round < 60; ++round) {
            // Half of the corners on middles and edges of pixels, where middles lie on edges.
            const bool is_whole = round % 2 == 0;
            const auto place = [&](double middle) {
                const double pixels = middle + random.uniform(-size_pixels, size_pixels);
                return static_cast<std::int32_t>(is_whole ? std::floor(2 * pixels) * 128 : pixels * 256);
            };
            const double x = random.uniform(0, 100);
            const double y = random.uniform(0, 120);
            Corners corners;
            for (FixedPoint& corner : corners) corner = {place(x), place(y)};
            if (doubled_area(corners) == 0) continue;
            if (doubled_area(corners) < 0) std::swap(corners[1], corners[2]);
            INFO("of " << size_pixels << " pixels, round " << round);
            const Pixels expected = covered_by_definition(corners, kClip);
            CHECK((covered_by_spans(corners, kClip) == expected));
            covered += expected.size();
        }
    CHECK(covered > 100'000);
}
