// From fragments to pieces.
#include "world/fragments.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <cairn/physics/fracture.h>
#include <cairn/physics/tuning.h>

#include "collide/distance.h"

namespace cairn::physics {
namespace {

bool touch(const Fragment& a, const Fragment& b) {
    for (const Convex& one : a.convexes) {
        for (const Convex& other : b.convexes) {
            if (distance_between(one, other, {}).distance <= tuning::kLinearSlop_m) return true;
        }
    }
    return false;
}

double mass_for_density_1(const Convex& shape) {
    return mass_of(shape, 1).mass;
}

}  // namespace

Fragment whole_fragment(const Stores& stores, int shape, int group) {
    const Convex& convex = stores.shapes[shape].convex();
    return {shape, group, true, ring_of(convex), {convex}};
}

Fragment part_fragment(int shape, int group, Ring ring) {
    Fragment part{shape, group, false, std::move(ring), {}};
    if (least_width(part.ring) >= static_cast<double>(kLeastPieceWidth_m))
        part.convexes = shapes_of(part.ring);
    return part;
}

std::vector<std::pair<int, int>> touching_pairs(const std::vector<Fragment>& fragments) {
    constexpr double kGap = static_cast<double>(tuning::kLinearSlop_m);
    std::vector<RingBox> boxes;
    for (const Fragment& f : fragments) boxes.push_back(box_of(f.ring));
    RingBox all = boxes[0];
    for (const RingBox& box : boxes) all = merged(all, box);
    // A sweep along the longer side of the whole, so that a long compound costs no square.
    const bool along_x = all.upper.x - all.lower.x >= all.upper.y - all.lower.y;
    const auto low = [&](int i) { return along_x ? boxes[i].lower.x : boxes[i].lower.y; };
    const auto high = [&](int i) { return along_x ? boxes[i].upper.x : boxes[i].upper.y; };
    std::vector<int> order(fragments.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int i, int k) { return low(i) < low(k); });
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const int a = order[i];
        for (std::size_t k = i + 1; k < order.size() && low(order[k]) <= high(a) + kGap; ++k) {
            const int b = order[k];
            if (fragments[a].group != fragments[b].group || !overlap(boxes[a], boxes[b], kGap)) continue;
            if (touch(fragments[a], fragments[b])) pairs.emplace_back(a, b);
        }
    }
    return pairs;
}

std::vector<Piece> make_pieces(const Stores& stores, const std::vector<Fragment>& fragments,
                               UnionFind& together) {
    std::map<int, double> kept;  // of each shape, its area in fragments
    for (const Fragment& f : fragments) {
        for (const Convex& convex : f.convexes) kept[f.shape] += mass_for_density_1(convex);
    }
    std::vector<Piece> pieces;
    std::vector<int> piece_of(fragments.size(), kNone);  // by the first member of its set
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const Fragment& f = fragments[i];
        int& index = piece_of[together.find(static_cast<int>(i))];
        if (index == kNone) {
            index = static_cast<int>(pieces.size());
            pieces.emplace_back();
            pieces.back().group = f.group;
        }
        const ShapeRecord& source = stores.shapes[f.shape];
        const double share = f.is_whole ? 1 : mass_for_density_1(source.convex()) / kept[f.shape];
        const auto density = static_cast<float>(static_cast<double>(source.def().density_kg_m2) * share);
        for (const Convex& convex : f.convexes) {
            pieces[index].shapes.push_back({f.shape, convex, density});
            pieces[index].mass += mass_of(convex, static_cast<double>(density));
        }
    }
    return pieces;
}

}  // namespace cairn::physics
