// Prototypes by all of their bits.
#include "world/shape_prototypes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "base/ample.h"

namespace cairn::physics {
namespace {

// All of a prototype, without the gaps between its members.
class Words {
  public:
    explicit Words(const ShapePrototype& prototype) {
        // Bindings name all members, or do not compile.
        const auto& [convex, def, users, place, digest, reach] =
            prototype;  // the last follows from the first
        const auto& [owns_end, is_box, centroid, half_size, outline, normals] = convex;
        const auto& [kind, count, radius_m, points_m] = outline;
        const auto& [density, material, filter, contact_events, hit_events, sensor, seen_by_sensors,
                     one_way_normal, user_data] = def;
        const auto& [friction, restitution, rolling_resistance, surface_speed, material_kind] = material;
        const auto& [categories, mask, group] = filter;
        const std::array<bool, 6> flags{owns_end,   is_box, contact_events,
                                        hit_events, sensor, seen_by_sensors};
        std::uint32_t bits = static_cast<std::uint32_t>(kind) << 16 | std::uint32_t{count} << 8;
        for (std::size_t i = 0; i < flags.size(); ++i) bits |= std::uint32_t{flags[i]} << i;
        add(points_m);
        add(normals);
        add(std::array{centroid, half_size, one_way_normal});
        add(std::array{radius_m, density, friction, restitution, rolling_resistance, surface_speed});
        add(std::array{bits, static_cast<std::uint32_t>(material_kind), static_cast<std::uint32_t>(group),
                       0u});
        add(std::array{categories, mask, user_data});
    }

    bool operator==(const Words& other) const = default;

    // Four sums that need not wait for each other, then the finalizer of MurmurHash3 (Appleby 2011).
    [[nodiscard]] std::uint32_t digest() const {
        constexpr std::size_t kSums = 4;
        static_assert(kCount % kSums == 0);
        std::array<std::uint64_t, kSums> sums{1, 2, 3, 4};
        for (std::size_t i = 0; i < kCount; i += kSums) {
            for (std::size_t k = 0; k < kSums; ++k)
                sums[k] = std::rotl((sums[k] ^ words_[i + k]) * 0xff51afd7ed558ccdu, 29);
        }
        std::uint64_t hash = 0;
        for (const std::uint64_t sum : sums) {
            hash = (hash ^ sum) * 0xc4ceb9fe1a85ec53u;
            hash ^= hash >> 33;
        }
        return static_cast<std::uint32_t>(hash);
    }

  private:
    static constexpr std::size_t kCount = 28;

    template <class T, std::size_t n>
    void add(const std::array<T, n>& values) {
        using Bits = std::array<std::uint64_t, sizeof(values) / sizeof(std::uint64_t)>;
        const auto bits = std::bit_cast<Bits>(values);
        std::copy(bits.begin(), bits.end(), words_.begin() + static_cast<std::ptrdiff_t>(used_));
        used_ += bits.size();
    }

    std::array<std::uint64_t, kCount> words_{};
    std::size_t used_ = 0;
};

}  // namespace

ShapePrototype* ShapePrototypes::take(const Convex& convex, const ShapeDef& def) {
    ShapePrototype wanted{convex, def};
    wanted.def.user_data = 0;
    wanted.def.filter.group = 0;
    const Words words(wanted);
    wanted.digest = words.digest();
    if (2 * (size() + 1) > slots_.size()) grow_table();
    for (std::size_t at = home(wanted.digest); slots_[at].place != kEmpty; at = after(at)) {
        if (slots_[at].digest != wanted.digest) continue;
        ShapePrototype& known = *prototypes_[slots_[at].place];
        if (Words(known) != words) continue;
        ++known.users;
        return &known;
    }
    wanted.users = 1;
    wanted.reach_m = farthest_distance(convex, convex.centroid);
    if (first_free_ == kEmpty) {
        wanted.place = static_cast<std::uint32_t>(prototypes_.size());
        push_amply(prototypes_, std::make_unique<ShapePrototype>(wanted));
    } else {
        wanted.place = first_free_;
        first_free_ = prototypes_[first_free_]->place;
        --free_count_;
        *prototypes_[wanted.place] = wanted;
    }
    put({wanted.digest, wanted.place});
    return prototypes_[wanted.place].get();
}

void ShapePrototypes::release(ShapePrototype* prototype) {
    if (--prototype->users > 0) return;
    std::size_t gap = home(prototype->digest);
    while (slots_[gap].place != prototype->place) gap = after(gap);
    // What follows without a gap, and may stand nearer to where it is looked for first, moves up. Source:
    // Knuth, vol. 3, 6.4, algorithm R.
    for (std::size_t at = after(gap); slots_[at].place != kEmpty; at = after(at)) {
        const std::size_t mask = slots_.size() - 1;
        const std::size_t from_home = (at - home(slots_[at].digest)) & mask;
        if (from_home < ((at - gap) & mask)) continue;
        slots_[gap] = slots_[at];
        gap = at;
    }
    slots_[gap] = {};
    first_free_ = std::exchange(prototype->place, first_free_);
    ++free_count_;
}

void ShapePrototypes::clear() {
    std::fill(slots_.begin(), slots_.end(), Slot{});
    first_free_ = kEmpty;
    free_count_ = 0;
    for (std::size_t place = prototypes_.size(); place-- > 0; ++free_count_) {
        prototypes_[place]->place = std::exchange(first_free_, static_cast<std::uint32_t>(place));
    }
}

void ShapePrototypes::grow_table() {
    constexpr std::size_t kLeast = 16;
    const std::vector<Slot> before = std::exchange(slots_, {});
    slots_.resize(std::max(kLeast, 2 * before.size()));
    for (const Slot& entry : before) {
        if (entry.place != kEmpty) put(entry);
    }
}

void ShapePrototypes::put(Slot entry) {
    std::size_t at = home(entry.digest);
    while (slots_[at].place != kEmpty) at = after(at);
    slots_[at] = entry;
}

}  // namespace cairn::physics
