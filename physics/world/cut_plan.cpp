// Cuts along a segment. A shape is divided where the segment goes all through it. Parts and whole shapes that
// touch stay together, unless the segment passes between them.
#include <algorithm>

#include <cairn/physics/tuning.h>

#include "world/fracture_plan.h"

namespace cairn::physics {
namespace {

constexpr double kSlop_m = static_cast<double>(tuning::kLinearSlop_m);

enum class Side : std::uint8_t { Left, Right, Both };

struct Cut {
    std::vector<Fragment> fragments;
    std::vector<Side> sides;  // of the fragments
};

bool covers(const CutWay& way, const Interval& interval) {
    return interval.low >= -kSlop_m && interval.high <= way.length_m + kSlop_m;
}

void add(Cut& cut, Fragment fragment, Side side) {
    cut.fragments.push_back(std::move(fragment));
    cut.sides.push_back(side);
}

void add_shape(Cut& cut, const Stores& stores, int shape, const CutWay& way) {
    Fragment whole = whole_fragment(stores, shape, 0);
    double leftmost = way.line.distance(whole.ring[0]);
    double rightmost = leftmost;
    for (const RingPoint p : whole.ring) {
        leftmost = std::max(leftmost, way.line.distance(p));
        rightmost = std::min(rightmost, way.line.distance(p));
    }
    if (rightmost >= -kSlop_m) return add(cut, std::move(whole), Side::Left);
    if (leftmost <= kSlop_m) return add(cut, std::move(whole), Side::Right);
    if (!covers(way, *interval_near(whole.ring, way.line, kLineReach_m))) {
        return add(cut, std::move(whole), Side::Both);
    }
    Fragment left = part_fragment(shape, 0, left_part(whole.ring, way.line));
    Fragment right = part_fragment(shape, 0, left_part(whole.ring, way.line.reversed()));
    if (left.convexes.empty() || right.convexes.empty()) {
        const bool is_left = area(left.ring) > area(right.ring);
        return add(cut, std::move(whole), is_left ? Side::Left : Side::Right);
    }
    add(cut, std::move(left), Side::Left);
    add(cut, std::move(right), Side::Right);
}

// Whether the segment passes between two fragments that touch.
bool is_severed(const Cut& cut, int a, int b, const CutWay& way) {
    if (cut.sides[a] == Side::Both || cut.sides[b] == Side::Both || cut.sides[a] == cut.sides[b])
        return false;
    if (cut.fragments[a].shape == cut.fragments[b].shape) return true;
    const auto of_a = interval_near(cut.fragments[a].ring, way.line, kSlop_m);
    const auto of_b = interval_near(cut.fragments[b].ring, way.line, kSlop_m);
    if (!of_a || !of_b) return false;
    return covers(way, {std::max(of_a->low, of_b->low), std::min(of_a->high, of_b->high)});
}

}  // namespace

RingPoint local_point(const Transform& xf, Position point) {
    const auto c = static_cast<double>(xf.q.c);
    const auto s = static_cast<double>(xf.q.s);
    const RingPoint d{point.x - xf.p.x, point.y - xf.p.y};
    return {c * d.x + s * d.y, c * d.y - s * d.x};
}

CutWay cut_way(const Transform& xf, Position from, Position to) {
    const RingPoint origin = local_point(xf, from);
    const RingPoint way = local_point(xf, to) - origin;
    const double way_length = length(way);
    return {{origin, (1 / way_length) * way}, way_length};
}

FracturePlan plan_cut(const Stores& stores, int body, const CutWay& way) {
    Cut cut;
    for_each_solid_shape(stores, body, [&](int shape) { add_shape(cut, stores, shape, way); });
    const int count = static_cast<int>(cut.fragments.size());
    if (count < 2) return {};
    UnionFind together;
    together.reset(count);
    bool divides = false;
    std::vector<std::pair<int, int>> severed;
    for (const auto& [a, b] : touching_pairs(cut.fragments)) {
        if (is_severed(cut, a, b, way)) {
            severed.emplace_back(a, b);
        } else {
            together.unite(a, b);
        }
    }
    for (const auto& [a, b] : severed) divides = divides || together.find(a) != together.find(b);
    if (!divides) return {};
    return make_pieces(stores, cut.fragments, together);
}

}  // namespace cairn::physics
