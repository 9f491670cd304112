// Points by their index, as the caller counts them.
#include "world/chain_rules.h"

#include <cairn/physics/tuning.h>

#include "world/validation.h"

namespace cairn::physics {
namespace {

// m. As for every other shape (collide/convex.cpp).
constexpr float kMaxLength_m = 1e6f;

std::string point_name(std::size_t index) {
    return "chain.points_m[" + std::to_string(index) + "]";
}
std::string given_name(std::size_t index) {
    return "points_m[" + std::to_string(index) + "]";
}

check::Fault validate_place(const std::string& name, Vec2 p) {
    if (auto fault = check::finite(name.c_str(), p)) return fault;
    const float farthest = std::max(std::fabs(p.x), std::fabs(p.y));
    return check::require(farthest <= kMaxLength_m, name.c_str(), static_cast<double>(farthest),
                          "within 1e6 m of the body's origin");
}

check::Fault validate_gap(const std::string& name, Vec2 p, const std::string& neighbour, Vec2 q) {
    const float gap = length(q - p);
    const std::string field = "the distance from " + name + " to " + neighbour;
    return check::require(gap >= tuning::kLinearSlop_m, field.c_str(), static_cast<double>(gap),
                          "at least 0.005 m");
}

// A run of points, with what stands before and after it where there is something.
struct Neighbour {
    std::string name;
    Vec2 point;
};
template <class Name>
check::Fault validate_run(std::span<const Vec2> points, Name&& name, const std::optional<Neighbour>& before,
                          const std::optional<Neighbour>& after) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Names are made for faults only: a chain may have 10^5 points.
        if (!is_finite(points[i]) || std::fabs(points[i].x) > kMaxLength_m ||
            std::fabs(points[i].y) > kMaxLength_m) {
            return validate_place(name(i), points[i]);
        }
        if (i > 0 && length(points[i] - points[i - 1]) < tuning::kLinearSlop_m)
            return validate_gap(name(i - 1), points[i - 1], name(i), points[i]);
    }
    if (before) {
        if (auto fault = validate_gap(before->name, before->point, name(0), points.front())) return fault;
    }
    if (after) return validate_gap(name(points.size() - 1), points.back(), after->name, after->point);
    return {};
}

// The point before or after a place of the chain: another point, or where the chain goes on.
std::optional<Neighbour> neighbour_before(const ChainRecord& chain, int index) {
    const auto& points = chain.points_m;
    if (index > 0) return Neighbour{point_name(index - 1), points[index - 1]};
    if (chain.closed) return Neighbour{point_name(points.size() - 1), points.back()};
    if (chain.before_m) return Neighbour{"chain.before_m", *chain.before_m};
    return {};
}
std::optional<Neighbour> neighbour_from(const ChainRecord& chain, int index) {
    const auto& points = chain.points_m;
    if (index < static_cast<int>(points.size())) return Neighbour{point_name(index), points[index]};
    if (chain.closed) return Neighbour{point_name(0), points.front()};
    if (chain.after_m) return Neighbour{"chain.after_m", *chain.after_m};
    return {};
}

check::Fault validate_end(const char* name, const std::optional<Vec2>& end, std::size_t index, Vec2 point) {
    if (!end) return {};
    return check::first_of({validate_place(name, *end), validate_gap(name, *end, point_name(index), point)});
}

int least_count(bool closed) {
    return closed ? 3 : 2;
}

check::Fault too_few(std::size_t count, bool closed) {
    return Error{"chain.points_m has " + std::to_string(count) + " points, but must have at least " +
                 std::to_string(least_count(closed)) +
                 (closed ? " to be closed" : " (a closed one at least 3)")};
}

check::Fault not_open() {
    return Error{"chain.before_m or chain.after_m is set, but a closed chain has no ends"};
}

check::Fault validate_index(const char* name, int index, int low, int high) {
    return check::within(name, index, low, high);
}

}  // namespace

check::Fault validate(const ChainDef& def) {
    const auto points = def.points_m;
    if (points.size() < static_cast<std::size_t>(least_count(def.closed)))
        return too_few(points.size(), def.closed);
    if (def.closed && (def.before_m || def.after_m)) return not_open();
    std::optional<Neighbour> after_last;
    if (def.closed) after_last = Neighbour{point_name(0), points.front()};
    if (auto fault = validate_run(points, point_name, {}, after_last)) return fault;
    if (auto fault = validate_end("chain.before_m", def.before_m, 0, points.front())) return fault;
    if (auto fault = validate_end("chain.after_m", def.after_m, points.size() - 1, points.back()))
        return fault;

    const std::size_t segments = points.size() - (def.closed ? 0 : 1);
    if (def.materials.size() > 1 && def.materials.size() != segments) {
        return Error{"chain.materials has " + std::to_string(def.materials.size()) +
                     " entries, but must have none, 1, or " + std::to_string(segments) +
                     " (one for each segment)"};
    }
    for (std::size_t i = 0; i < def.materials.size(); ++i) {
        if (auto fault = validate(def.materials[i]))
            return Error{"chain.materials[" + std::to_string(i) + "]: " + fault->message};
    }
    return {};
}

check::Fault validate_set_point(const ChainRecord& chain, int index, Vec2 point_m) {
    const int count = static_cast<int>(chain.points_m.size());
    if (auto fault = validate_index("the index of the point", index, 0, count - 1)) return fault;
    const auto name = [index](std::size_t) { return point_name(index); };
    return validate_run({&point_m, 1}, name, neighbour_before(chain, index),
                        neighbour_from(chain, index + 1));
}

check::Fault validate_insert(const ChainRecord& chain, int index, std::span<const Vec2> points_m) {
    const int count = static_cast<int>(chain.points_m.size());
    if (auto fault = validate_index("the index of the first new point", index, 0, count)) return fault;
    if (points_m.empty()) return {};
    return validate_run(points_m, given_name, neighbour_before(chain, index), neighbour_from(chain, index));
}

check::Fault validate_remove(const ChainRecord& chain, int first, int count) {
    const int points = static_cast<int>(chain.points_m.size());
    if (auto fault = validate_index("the index of the first point", first, 0, points - 1)) return fault;
    if (auto fault = validate_index("the count of points", count, 0, points - first)) return fault;
    if (points - count < least_count(chain.closed)) return too_few(points - count, chain.closed);
    if (count == 0) return {};
    const bool whole_start = first == 0;
    const bool whole_end = first + count == points;
    std::optional<Neighbour> before = neighbour_before(chain, first);
    std::optional<Neighbour> after = neighbour_from(chain, first + count);
    // A closed chain that loses a run across its first point is joined there.
    if (chain.closed && whole_start) before = Neighbour{point_name(points - 1), chain.points_m.back()};
    if (chain.closed && whole_end) after = Neighbour{point_name(0), chain.points_m.front()};
    if (!before || !after) return {};
    return validate_gap(before->name, before->point, after->name, after->point);
}

check::Fault validate_ends(const ChainRecord& chain, std::optional<Vec2> before_m,
                           std::optional<Vec2> after_m) {
    if (chain.closed) return before_m || after_m ? not_open() : check::Fault{};
    return check::first_of(
        {validate_end("chain.before_m", before_m, 0, chain.points_m.front()),
         validate_end("chain.after_m", after_m, chain.points_m.size() - 1, chain.points_m.back())});
}

check::Fault validate_segment_index(const ChainRecord& chain, int index) {
    return validate_index("the index of the segment", index, 0, static_cast<int>(chain.segments.size()) - 1);
}

}  // namespace cairn::physics
