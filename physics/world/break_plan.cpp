// Breaking into Voronoi cells. A grain is a direction in which the body is compressed while it breaks, so
// that pieces are long along it afterwards: linear maps keep cells convex and side by side.
#include <algorithm>

#include "collide/fracture_sites.h"
#include "collide/voronoi.h"
#include "world/fracture_plan.h"

namespace cairn::physics {
namespace {

// What stays in one piece, beyond the radius of the break.
constexpr int kRest = -1;

// p - (1 - stretch) (p . direction) direction.
class Grain {
  public:
    explicit Grain(Vec2 grain) {
        const RingPoint g = to_ring_point(grain);
        if (g == RingPoint{}) return;
        stretch_ = length(g);
        direction_ = (1 / stretch_) * g;
    }
    [[nodiscard]] RingPoint compressed(RingPoint p) const { return scaled(p, 1 / stretch_); }
    [[nodiscard]] RingPoint restored(RingPoint p) const { return scaled(p, stretch_); }
    [[nodiscard]] Ring compressed(Ring ring) const {
        for (RingPoint& p : ring) p = compressed(p);
        return ring;
    }
    [[nodiscard]] Ring restored(Ring ring) const {
        for (RingPoint& p : ring) p = restored(p);
        return ring;
    }

  private:
    [[nodiscard]] RingPoint scaled(RingPoint p, double by) const {
        return p - (1 - by) * dot(p, direction_) * direction_;
    }

    RingPoint direction_{};
    double stretch_ = 1;
};

// What is in both.
Ring common_part(Ring ring, const Ring& cell) {
    // m. Shorter edges have no direction worth the name, and leave out nothing that could be seen.
    constexpr double kShortestEdge_m = 1e-6;
    for (std::size_t i = 0; i < cell.size() && !ring.empty(); ++i) {
        const RingPoint edge = cell[i + 1 < cell.size() ? i + 1 : 0] - cell[i];
        const double edge_length = length(edge);
        if (edge_length >= kShortestEdge_m) ring = left_part(ring, {cell[i], (1 / edge_length) * edge});
    }
    return ring;
}

class Break {
  public:
    Break(const Stores& stores, int body, RingPoint impact, const FractureDef& def)
        : stores_(stores), def_(def), grain_(def.grain) {
        for_each_solid_shape(stores, body, [&](int shape) {
            shapes_.push_back(shape);
            rings_.push_back(grain_.compressed(ring_of(stores.shapes[shape].convex())));
        });
        impact_ = nearest_within(grain_.compressed(impact));
        const auto least_radius = static_cast<double>(def.min_width_m);
        sites_ = def.pattern == FracturePattern::Uniform
                     ? uniform_sites(rings_, def.pieces, def.seed)
                     : radial_sites(rings_, impact_, def.pieces, least_radius, def.seed);
        drop_distant_sites();
    }

    FracturePlan plan() {
        do {
            divide();
        } while (drop_narrow_sites());
        const bool breaks = std::any_of(fragments_.begin(), fragments_.end(),
                                        [](const Fragment& f) { return f.group != kRest; });
        if (!breaks) return {};
        UnionFind together;
        together.reset(static_cast<int>(fragments_.size()));
        for (const auto& [a, b] : touching_pairs(fragments_)) together.unite(a, b);
        std::vector<Piece> pieces = make_pieces(stores_, fragments_, together);
        if (pieces.size() < 2) return {};
        for (Piece& piece : pieces) {
            piece.is_shattered = piece.group != kRest;
            piece.is_released = piece.is_shattered && def_.release;
        }
        return pieces;
    }

  private:
    // An impact beside the body counts as one on its outline.
    [[nodiscard]] RingPoint nearest_within(RingPoint impact) const {
        RingPoint nearest = nearest_on_outline(rings_[0], impact);
        for (const Ring& ring : rings_) {
            if (contains(ring, impact)) return impact;
            const RingPoint candidate = nearest_on_outline(ring, impact);
            if (length(impact - candidate) < length(impact - nearest)) nearest = candidate;
        }
        return nearest;
    }

    // From the impact, without the compression.
    [[nodiscard]] double way_to(RingPoint site) const {
        return length(grain_.restored(site) - grain_.restored(impact_));
    }

    // Far beyond the radius there is no need for many cells: those next to the pieces extend outward instead,
    // and what stays together has few shapes.
    void drop_distant_sites() {
        constexpr double kSpacings = 2;  // wide enough that the pieces have all their neighbours
        constexpr std::size_t kLeast = 6;
        const auto radius = static_cast<double>(def_.radius_m);
        double whole = 0;
        for (const Ring& ring : rings_) whole += area(grain_.restored(ring));
        const double margin = kSpacings * std::sqrt(whole / def_.pieces);
        std::stable_sort(sites_.begin(), sites_.end(),
                         [&](RingPoint a, RingPoint b) { return way_to(a) < way_to(b); });
        std::size_t beyond = 0;
        std::size_t kept = 0;
        for (; kept < sites_.size(); ++kept) {
            const double way = way_to(sites_[kept]);
            if (way > radius && ++beyond > kLeast && way > radius + margin) break;
        }
        sites_.resize(kept);
    }

    [[nodiscard]] int group_of(std::size_t site) const {
        return way_to(sites_[site]) <= static_cast<double>(def_.radius_m) ? static_cast<int>(site) : kRest;
    }

    void divide() {
        RingBox all = box_of(rings_[0]);
        for (const Ring& ring : rings_) all = merged(all, box_of(ring));
        const std::vector<Ring> cells = voronoi_cells(
            sites_, {all.lower, {all.upper.x, all.lower.y}, all.upper, {all.lower.x, all.upper.y}});
        fragments_.clear();
        widths_.assign(sites_.size(), 0);
        occupied_.assign(sites_.size(), false);
        for (std::size_t i = 0; i < shapes_.size(); ++i) divide_shape(i, cells);
    }

    void divide_shape(std::size_t index, const std::vector<Ring>& cells) {
        const RingBox box = box_of(rings_[index]);
        const std::size_t first = fragments_.size();
        int widest_group = kRest;
        double widest = -1;
        bool is_divided = false;
        for (std::size_t site = 0; site < cells.size(); ++site) {
            if (cells[site].empty() || !overlap(box, box_of(cells[site]), 0)) continue;
            Ring part = grain_.restored(common_part(rings_[index], cells[site]));
            if (part.empty()) continue;
            const double width = least_width(part);
            occupied_[site] = true;
            widths_[site] = std::max(widths_[site], width);
            is_divided = is_divided || (widest >= 0 && group_of(site) != widest_group);
            if (width > widest) {
                widest = width;
                widest_group = group_of(site);
            }
            Fragment fragment = part_fragment(shapes_[index], group_of(site), std::move(part));
            if (!fragment.convexes.empty()) fragments_.push_back(std::move(fragment));
        }
        // A shape that lies in one cell, or is too small for pieces, stays as it is.
        if (is_divided && fragments_.size() > first) return;
        fragments_.resize(first);
        fragments_.push_back(whole_fragment(stores_, shapes_[index], widest_group));
    }

    // Sites whose pieces would be too narrow go, the narrower half of them at once: their neighbours will be
    // larger. Whether any went.
    bool drop_narrow_sites() {
        std::vector<std::pair<double, std::size_t>> narrow;
        for (std::size_t site = 0; site < sites_.size(); ++site) {
            if (!occupied_[site] || group_of(site) == kRest) continue;
            if (widths_[site] < static_cast<double>(def_.min_width_m))
                narrow.emplace_back(widths_[site], site);
        }
        if (narrow.empty() || sites_.size() == 1) return false;
        std::sort(narrow.begin(), narrow.end());
        narrow.resize((narrow.size() + 1) / 2);
        if (narrow.size() == sites_.size()) narrow.pop_back();
        std::vector<bool> is_gone(sites_.size(), false);
        for (const auto& [width, site] : narrow) is_gone[site] = true;
        std::size_t kept = 0;
        for (std::size_t site = 0; site < sites_.size(); ++site) {
            if (!is_gone[site]) sites_[kept++] = sites_[site];
        }
        sites_.resize(kept);
        return true;
    }

    const Stores& stores_;
    const FractureDef& def_;
    Grain grain_;
    RingPoint impact_;
    std::vector<int> shapes_;
    std::vector<Ring> rings_;  // of the shapes, compressed, as the sites and the impact
    std::vector<RingPoint> sites_;
    std::vector<Fragment> fragments_;
    std::vector<double> widths_;  // by site: of the widest fragment in its cell
    std::vector<bool> occupied_;  // by site: something of the body is in its cell
};

}  // namespace

check::Fault validate(const FractureDef& def) {
    const auto pattern = static_cast<double>(def.pattern);
    const auto grain = static_cast<double>(length(def.grain));
    return check::first_of(
        {check::within("fracture.pattern", pattern, 0, static_cast<double>(FracturePattern::Radial)),
         check::within("fracture.pieces", def.pieces, 2, kMaxFracturePieces),
         check::require(std::isfinite(def.min_width_m) && def.min_width_m >= kLeastPieceWidth_m,
                        "fracture.min_width_m", static_cast<double>(def.min_width_m),
                        "finite and at least 0.01 m"),
         check::require(def.radius_m > 0, "fracture.radius_m", static_cast<double>(def.radius_m),
                        "greater than 0"),
         check::finite("fracture.grain", def.grain),
         check::require(grain == 0 || (grain >= 1 && grain <= 16), "the length of fracture.grain", grain,
                        "0 or from 1 to 16")});
}

FracturePlan plan_break(const Stores& stores, int body, RingPoint impact, const FractureDef& def) {
    return Break(stores, body, impact, def).plan();
}

}  // namespace cairn::physics
