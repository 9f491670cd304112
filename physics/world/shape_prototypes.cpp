// Prototypes by all of their bits.
#include "world/shape_prototypes.h"

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace cairn::physics {
namespace {

// All of a prototype, without the gaps between its members.
class Words {
  public:
    explicit Words(const ShapePrototype& prototype) {
        // Bindings name all members, or do not compile.
        const auto& [convex, def] = prototype;
        const auto& [owns_end, is_box, centroid, half_size, outline, normals] = convex;
        const auto& [kind, count, radius_m, points_m] = outline;
        const auto& [density, material, filter, contact_events, hit_events, sensor, seen_by_sensors,
                     one_way_normal, user_data] = def;
        const auto& [friction, restitution, rolling_resistance, surface_speed, material_kind] = material;
        const auto& [categories, mask, group] = filter;
        add(owns_end, is_box, contact_events, hit_events, sensor, seen_by_sensors);
        add(static_cast<std::uint32_t>(kind), std::uint32_t{count});
        add(centroid, half_size, one_way_normal);
        add(radius_m, density, friction, restitution, rolling_resistance, surface_speed);
        add(static_cast<std::uint32_t>(material_kind), static_cast<std::uint32_t>(group));
        add(categories, mask, user_data);
        for (const Vec2 point : points_m) add(point);
        for (const Vec2 normal : normals) add(normal);
    }

    bool operator==(const Words& other) const = default;

    // Source: the finalizer of MurmurHash3, Appleby 2011, after each word.
    [[nodiscard]] std::uint64_t hash() const {
        std::uint64_t hash = 0;
        for (std::size_t i = 0; i < kCount; i += 2) {
            hash ^= std::uint64_t{words_[i]} << 32 | words_[i + 1];
            hash *= 0xff51afd7ed558ccdu;
            hash ^= hash >> 32;
        }
        return hash;
    }

  private:
    static constexpr std::size_t kCount = 64;

    template <class... Members>
    void add(const Members&... members) {
        (put(members), ...);
    }
    void put(std::uint32_t word) { words_[used_++] = word; }
    void put(std::uint64_t word) {
        put(static_cast<std::uint32_t>(word));
        put(static_cast<std::uint32_t>(word >> 32));
    }
    void put(bool flag) { put(std::uint32_t{flag}); }
    void put(float number) { put(std::bit_cast<std::uint32_t>(number)); }
    void put(Vec2 v) {
        put(v.x);
        put(v.y);
    }

    std::array<std::uint32_t, kCount> words_{};
    std::size_t used_ = 0;
};

}  // namespace

bool ShapePrototype::operator==(const ShapePrototype& other) const {
    return Words(*this) == Words(other);
}

std::size_t ShapePrototypes::Hash::operator()(const ShapePrototype& prototype) const {
    return Words(prototype).hash();
}

ShapePrototypes::Shared* ShapePrototypes::take(const Convex& convex, const ShapeDef& def) {
    ShapePrototype prototype{convex, def};
    prototype.def.user_data = 0;
    if (const auto known = counts_.find(prototype); known != counts_.end()) return take(&*known);
    if (spare_.empty()) return take(&*counts_.emplace(prototype, 0).first);
    Counts::node_type node = std::move(spare_.back());
    spare_.pop_back();
    node.key() = prototype;
    node.mapped() = 0;
    return take(&*counts_.insert(std::move(node)).position);
}

void ShapePrototypes::release(Shared* shared) {
    if (--shared->second == 0) spare_.push_back(counts_.extract(shared->first));
}

void ShapePrototypes::clear() {
    while (!counts_.empty()) spare_.push_back(counts_.extract(counts_.begin()));
}

}  // namespace cairn::physics
