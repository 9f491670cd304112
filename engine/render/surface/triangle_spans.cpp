#include "render/surface/triangle_spans.h"

#include <algorithm>
#include <cassert>

namespace cairn::engine {
namespace {

/// The first pixel whose middle is not before a place, and the last one not behind it.
int first_pixel(std::int32_t place) {
    return (place + kSubpixels / 2 - 1) >> 8;
}
int last_pixel(std::int32_t place) {
    return (place - kSubpixels / 2) >> 8;
}
static_assert(kSubpixels == 1 << 8);

/// Three edge functions: none is below 0 where a pixel's middle is inside.
template <class Int>
struct Edges {
    std::array<Int, 3> at;  ///< at the first pixel of the box
    std::array<Int, 3> step_x;
    std::array<Int, 3> step_y;

    Edges(const Corners& corners, const PixelBox& box) {
        const Int middle_x = static_cast<Int>(box.first_column) * kSubpixels + kSubpixels / 2;
        const Int middle_y = static_cast<Int>(box.first_row) * kSubpixels + kSubpixels / 2;
        for (std::size_t k = 0; k < 3; ++k) {
            const FixedPoint p = corners[k];
            const FixedPoint q = corners[k == 2 ? 0 : k + 1];
            const Int dx = static_cast<Int>(q.x) - p.x;
            const Int dy = static_cast<Int>(q.y) - p.y;
            // The points of an edge that is neither top nor left belong to the neighbour.
            const bool is_own = dy < 0 || (dy == 0 && dx > 0);
            at[k] = dx * (middle_y - p.y) - dy * (middle_x - p.x) - (is_own ? 0 : 1);
            step_x[k] = -dy * kSubpixels;
            step_y[k] = dx * kSubpixels;
        }
    }
};

template <class Int>
Int floor_div(Int a, Int b) {
    const Int quotient = a / b;
    return quotient - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

/// The first and the last column inside, counted from the first one of the box; none where first > last.
struct Columns {
    int first;
    int last;
};

template <class Int>
Columns divide_for_columns(const Edges<Int>& edges, int count) {
    Int first = 0;
    Int last = count - 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const Int at = edges.at[k];
        const Int step = edges.step_x[k];
        if (step > 0)
            first = std::max(first, -floor_div(at, step));
        else if (step < 0)
            last = std::min(last, floor_div(at, -step));
        else if (at < 0)
            last = first - 1;
    }
    return first <= last ? Columns{static_cast<int>(first), static_cast<int>(last)} : Columns{0, -1};
}

/// The same. The pixels inside lie side by side, so in the short rows of small triangles, which are most,
/// stepping to them costs less than dividing.
template <class Int>
[[gnu::always_inline]] inline Columns step_to_columns(Int a, Int b, Int c, Int step_a, Int step_b, Int step_c,
                                                      int count) {
    int first = 0;
    // Not below 0 means that no sign bit is set.
    while ((a | b | c) < 0) {
        if (++first == count) return {0, -1};
        a += step_a;
        b += step_b;
        c += step_c;
    }
    int end = first;
    do {
        ++end;
        a += step_a;
        b += step_b;
        c += step_c;
    } while (end < count && (a | b | c) >= 0);
    return {first, end - 1};
}

template <class Int>
std::size_t find_spans_of(Edges<Int> edges, const PixelBox& box, std::span<Span, kMaxSpans> spans) {
    constexpr int kShort = 8;
    const int count = box.last_column - box.first_column + 1;
    std::size_t found = 0;
    if (count <= kShort) {
        // In variables of their own, which stay in registers.
        auto [a, b, c] = edges.at;
        const auto [right_a, right_b, right_c] = edges.step_x;
        const auto [down_a, down_b, down_c] = edges.step_y;
        for (int row = box.first_row; row <= box.last_row; ++row) {
            const Columns columns = step_to_columns(a, b, c, right_a, right_b, right_c, count);
            spans[found] = {row, box.first_column + columns.first, box.first_column + columns.last};
            found += columns.first <= columns.last ? 1 : 0;
            a += down_a;
            b += down_b;
            c += down_c;
        }
        return found;
    }
    for (int row = box.first_row; row <= box.last_row; ++row) {
        const Columns columns = divide_for_columns(edges, count);
        if (columns.first <= columns.last)
            spans[found++] = {row, box.first_column + columns.first, box.first_column + columns.last};
        for (std::size_t k = 0; k < 3; ++k) edges.at[k] += edges.step_y[k];
    }
    return found;
}

/// Up to so many pixels across, edge functions fit into 32 bits: 2 * (2^6 * 2^8)^2 = 2^29.
constexpr std::int32_t kSmall = 64 * kSubpixels;

}  // namespace

PixelBox pixels_near(const Corners& p, const PixelRect& clip) {
    const auto [min_x, max_x] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [min_y, max_y] = std::minmax({p[0].y, p[1].y, p[2].y});
    return {
        .first_column = std::max(clip.x, first_pixel(min_x)),
        .last_column = std::min(clip.x + clip.width - 1, last_pixel(max_x)),
        .first_row = std::max(clip.y, first_pixel(min_y)),
        .last_row = std::min(clip.y + clip.height - 1, last_pixel(max_y)),
    };
}

std::size_t find_spans(const Corners& p, const PixelBox& box, std::span<Span, kMaxSpans> spans) {
    assert(box.last_row - box.first_row < kMaxSpans);
    const auto [min_x, max_x] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [min_y, max_y] = std::minmax({p[0].y, p[1].y, p[2].y});
    if (std::max(max_x - min_x, max_y - min_y) <= kSmall)
        return find_spans_of(Edges<std::int32_t>(p, box), box, spans);
    return find_spans_of(Edges<std::int64_t>(p, box), box, spans);
}

}  // namespace cairn::engine
