// Lines with a width. Invariant: a line is a strip of cross-sections of four vertices (transparent, opaque,
// opaque, transparent), and wedges that fill the outside of sharp joins and the round ends.
//
// Sharp joins overlap on their inner side, so a translucent line is a little darker there. The alternative,
// cutting the overlap out, needs a polygon boolean per join; it was judged not to be worth it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/tessellate.h"

namespace cairn::engine {
namespace {

/// Points closer than this (in pixels) are one point: the direction between them is rounding noise.
constexpr float kMinSegment = 0.02f;

/// Joins are mitred up to turns whose cosine is this, a little more than a right angle, so that the corners
/// of rotated rectangles stay sharp; beyond, the miter would grow a spike, and the join is round.
constexpr float kMinMiterCosine = -0.1f;

Vec2 left_of(Vec2 direction) {
    return {-direction.y, direction.x};
}

class Stroker {
  public:
    Stroker(float width, const Brush& brush, TriangleList& out)
        : brush_(width < 1 ? brush.faded(width) : brush),
          core_(brush.half_rim() == 0 ? 0.5f * std::max(width, 1.0f) : std::max(0.5f * (width - 1), 0.0f)),
          rim_(core_ + 2 * brush.half_rim()),
          out_(out) {}

    void run(std::span<const Vec2> points, bool closed, LineCap cap) {
        const std::size_t n = points.size();
        const std::size_t segments = closed ? n : n - 1;
        directions_.resize(segments);
        lengths_.resize(segments);
        for (std::size_t i = 0; i < segments; ++i) {
            const Vec2 step = points[(i + 1) % n] - points[i];
            lengths_[i] = length(step);
            directions_[i] = step * (1 / lengths_[i]);
        }

        if (closed) {
            const auto [end, start] = join(points[0], segments - 1, 0);
            open_section_ = start;
            for (std::size_t i = 1; i < n; ++i) pass(points[i], i - 1, i);
            bridge(open_section_, end);
        } else {
            begin_cap(points[0], cap);
            for (std::size_t i = 1; i + 1 < n; ++i) pass(points[i], i - 1, i);
            end_cap(points[n - 1], cap);
        }
    }

    /// All that is left of a line without length: a round dot.
    void dot_at(Vec2 center) { wedge(center, {1, 0}, 2 * std::numbers::pi_v<float>); }

  private:
    struct Join {
        int end;    ///< the section that ends the segment before
        int start;  ///< the section that starts the segment after
    };

    /// Four vertices across the line; `across` points left and has the length that keeps the line's width.
    int section(Vec2 center, Vec2 across, float coverage) {
        const int first = out_.add(brush_.vertex(center + across * rim_, 0));
        out_.add(brush_.vertex(center + across * core_, coverage));
        out_.add(brush_.vertex(center - across * core_, coverage));
        out_.add(brush_.vertex(center - across * rim_, 0));
        return first;
    }

    void bridge(int from, int to) {
        for (int i = 0; i < 3; ++i) {
            if (i == 1 && core_ == 0) continue;
            out_.add_quad(from + i, from + i + 1, to + i + 1, to + i);
        }
    }

    /// A sector around `center` that starts at the unit vector `from` and turns by `angle_rad`.
    void wedge(Vec2 center, Vec2 from, float angle_rad) {
        const float full_turn = 2 * std::numbers::pi_v<float>;
        const float share = std::fabs(angle_rad) / full_turn;
        const int steps =
            std::max(1, static_cast<int>(std::ceil(share * static_cast<float>(circle_segments(rim_)))));
        const int middle = out_.add(brush_.vertex(center, 1));
        int previous = -1;
        for (int i = 0; i <= steps; ++i) {
            const float angle = angle_rad * static_cast<float>(i) / static_cast<float>(steps);
            const Vec2 direction = Affine2::rotation(angle).apply_vector(from);
            const int inner = out_.add(brush_.vertex(center + direction * core_, 1));
            out_.add(brush_.vertex(center + direction * rim_, 0));
            if (previous >= 0) {
                if (core_ > 0) out_.add_triangle(middle, previous, inner);
                out_.add_quad(previous, previous + 1, inner + 1, inner);
            }
            previous = inner;
        }
    }

    Join join(Vec2 at, std::size_t before, std::size_t after) {
        const Vec2 d0 = directions_[before];
        const Vec2 d1 = directions_[after];
        const float cosine = dot(d0, d1);
        // On the inner side a miter runs back along both segments by rim * tan(turn / 2), for which there
        // must be room.
        const float half_tangent = std::sqrt(std::max(1 - cosine, 0.0f) / std::max(1 + cosine, 1e-6f));
        const bool has_room = rim_ * half_tangent <= std::min(lengths_[before], lengths_[after]);
        if (cosine > kMinMiterCosine && has_room) {
            const int both = section(at, left_of(d0 + d1) * (1 / (1 + cosine)), 1);
            return {both, both};
        }
        const float turn = std::atan2(cross(d0, d1), cosine);
        const Vec2 outside = turn > 0 ? -left_of(d0) : left_of(d0);
        wedge(at, outside, turn);
        return {section(at, left_of(d0), 1), section(at, left_of(d1), 1)};
    }

    void pass(Vec2 at, std::size_t before, std::size_t after) {
        const auto [end, start] = join(at, before, after);
        bridge(open_section_, end);
        open_section_ = start;
    }

    void begin_cap(Vec2 at, LineCap cap) {
        const Vec2 direction = directions_.front();
        const Vec2 across = left_of(direction);
        switch (cap) {
            case LineCap::Round:
                wedge(at, across, std::numbers::pi_v<float>);
                open_section_ = section(at, across, 1);
                break;
            case LineCap::Butt: {
                const int rim = section(at - direction * brush_.half_rim(), across, 0);
                open_section_ =
                    section(at + direction * std::min(brush_.half_rim(), 0.5f * lengths_.front()), across, 1);
                bridge(rim, open_section_);
                break;
            }
        }
    }

    void end_cap(Vec2 at, LineCap cap) {
        const Vec2 direction = directions_.back();
        const Vec2 across = left_of(direction);
        switch (cap) {
            case LineCap::Round:
                bridge(open_section_, section(at, across, 1));
                wedge(at, -across, std::numbers::pi_v<float>);
                break;
            case LineCap::Butt: {
                const int last =
                    section(at - direction * std::min(brush_.half_rim(), 0.5f * lengths_.back()), across, 1);
                bridge(open_section_, last);
                bridge(last, section(at + direction * brush_.half_rim(), across, 0));
                break;
            }
        }
    }

    Brush brush_;
    float core_;  ///< half the width of the opaque part
    float rim_;   ///< half the width with the transparent rims
    TriangleList& out_;
    std::vector<Vec2> directions_;
    std::vector<float> lengths_;
    int open_section_ = 0;  ///< the section that the next bridge starts from
};

}  // namespace

void stroke(std::span<const Vec2> points, bool closed, float width, LineCap cap, const Brush& brush,
            TriangleList& out) {
    if (!(width > 0)) return;
    std::vector<Vec2> path;
    path.reserve(points.size());
    for (const Vec2 p : points)
        if (path.empty() || length(p - path.back()) > kMinSegment) path.push_back(p);
    while (closed && path.size() > 1 && length(path.front() - path.back()) <= kMinSegment) path.pop_back();
    if (path.empty()) return;

    Stroker stroker(width, brush, out);
    if (path.size() >= 2)
        stroker.run(path, closed && path.size() >= 3, cap);
    else if (cap == LineCap::Round)
        stroker.dot_at(path.front());
}

}  // namespace cairn::engine
