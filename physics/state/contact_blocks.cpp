#include "state/contact_blocks.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include <cairn/physics/tuning.h>

namespace cairn::physics {
namespace {

using IntLanes = Lanes<std::int32_t>;
using FloatLanes = Lanes<float>;

constexpr int kBoxRows = 8;
static_assert(sizeof(BoxLanes) == kBoxRows * kLaneRow);
using BoxNumbers = std::array<float, kBoxRows * kLanes>;

// What a block repeats: its first byte tells.
constexpr std::uint8_t kSameBoxes = 1;
constexpr std::uint8_t kSameFeatures = 2;
constexpr std::uint8_t kSameAll = 3;

constexpr std::size_t size_of_repeated(std::uint8_t same) {
    return ((same & kSameBoxes) != 0 ? 0 : kBoxRows * kLaneRow) +
           ((same & kSameFeatures) != 0 ? 0 : sizeof(FeatureLanes));
}

constexpr const char* kUsed = "a lane of contacts holds something, though none is in it";

// m. For points that do not touch: more than the slop.
constexpr float kApart_m = 1;

constexpr unsigned lanes_below(int used) {
    return (1u << used) - 1;
}

// Lanes that nobody is in hold what the last one left there, which means nothing.
template <class T>
void clear_unused(Lanes<T>& lanes, int used, T unused) {
    for (int lane = used; lane < kLanes; ++lane) lanes[static_cast<std::size_t>(lane)] = unused;
}

template <class T>
std::byte* put_lanes(std::byte* at, const Lanes<T>& lanes, int used, T unused) {
    Lanes<T> clean = lanes;
    clear_unused(clean, used, unused);
    return put(at, clean);
}

// Puts a part of a block unless it is as before; the bit goes into `same` then.
template <class Part>
std::byte* put_unless_same(std::byte* at, const Part& part, Part& last, std::uint8_t bit,
                           std::uint8_t& same) {
    if (std::memcmp(&part, &last, sizeof part) == 0) {
        same |= bit;
        return at;
    }
    last = part;
    return put(at, part);
}

template <class T>
bool is_unused(const Lanes<T>& lanes, int used, T unused) {
    return std::all_of(lanes.begin() + used, lanes.end(), [unused](T value) { return value == unused; });
}

// As put_lanes leaves them. Passes go over all lanes of a block, so nothing may lie hidden there.
bool is_unused(const PairBlock& pairs, int used) {
    if (used == kLanes) return true;
    const auto& [contact, body_a, body_b, shape_a, shape_b, boxes, features, reports, impacts, faint] = pairs;
    const auto& [half_ax, half_ay, half_bx, half_by, offset_ax, offset_ay, offset_bx, offset_by] = boxes;
    bool unused = static_cast<unsigned>(reports | impacts) <= lanes_below(used);
    for (const IntLanes* lanes : {&contact, &shape_a, &shape_b}) unused &= is_unused(*lanes, used, kNone);
    for (const IntLanes& lanes : features) unused &= is_unused(lanes, used, kNoFeature);
    for (const FloatLanes* lanes :
         {&half_ax, &half_ay, &half_bx, &half_by, &offset_ax, &offset_ay, &offset_bx, &offset_by})
        unused &= is_unused(*lanes, used, 0.0f);
    return unused;
}

bool is_unused(const ContactBlock& block, int used) {
    if (used == kLanes) return true;
    bool unused = is_unused(block.friction_impulse, used, 0.0f);
    for (const ContactBlockPoint& point : block.points) unused &= is_unused(point.impulse, used, 0.0f);
    return unused;
}

std::byte* put_pairs(std::byte* at, const PairBlock& pairs, int used, RepeatedParts& last) {
    const auto& [contact, body_a, body_b, shape_a, shape_b, boxes, features, reports, impacts, faint] = pairs;
    std::byte* const same_at = at++;
    for (const IntLanes* lanes : {&contact, &shape_a, &shape_b}) at = put_lanes(at, *lanes, used, kNone);
    BoxLanes clean_boxes = boxes;
    FeatureLanes clean_features = features;
    if (used < kLanes) {
        auto& [half_ax, half_ay, half_bx, half_by, offset_ax, offset_ay, offset_bx, offset_by] = clean_boxes;
        for (FloatLanes* lanes :
             {&half_ax, &half_ay, &half_bx, &half_by, &offset_ax, &offset_ay, &offset_bx, &offset_by})
            clear_unused(*lanes, used, 0.0f);
        for (IntLanes& lanes : clean_features) clear_unused(lanes, used, kNoFeature);
    }
    std::uint8_t same = 0;
    at = put_unless_same(at, std::bit_cast<BoxNumbers>(clean_boxes), last.boxes, kSameBoxes, same);
    at = put_unless_same(at, clean_features, last.features, kSameFeatures, same);
    for (const std::uint8_t bits : {reports, impacts})
        at = put(at, static_cast<std::uint8_t>(bits & lanes_below(used)));
    put(same_at, same);
    return at;
}

// Of a block that has all of its bytes.
const std::byte* get_pairs(const std::byte* at, PairBlock& pairs, RepeatedParts& last, Reading& reading) {
    auto& [contact, body_a, body_b, shape_a, shape_b, boxes, features, reports, impacts, faint] = pairs;
    std::uint8_t same = 0;
    at = get(at, same, reading);
    for (IntLanes* lanes : {&contact, &shape_a, &shape_b}) at = get(at, *lanes, reading);
    if ((same & kSameBoxes) == 0) at = get(at, last.boxes, reading);
    if ((same & kSameFeatures) == 0) at = get(at, last.features, reading);
    boxes = std::bit_cast<BoxLanes>(last.boxes);
    features = last.features;
    body_a.fill(kNone);
    body_b.fill(kNone);
    for (std::uint8_t* bits : {&reports, &impacts}) at = get(at, *bits, reading);
    faint = 0;  // follows from the record
    return at;
}

// Of separations only this is asked between steps: whether they are so small that the two touch.
std::uint8_t touching_lanes(const ContactBlock& block, int used) {
    unsigned touching = 0;
    for (int i = 0; i < used; ++i) {
        const auto lane = static_cast<std::size_t>(i);
        const float gap = std::min(block.points[0].separation[lane], block.points[1].separation[lane]);
        touching |= (gap < tuning::kLinearSlop_m ? 1u : 0u) << i;
    }
    return static_cast<std::uint8_t>(touching);
}

// Where a block begins of which so many bytes follow at least; null when not all of it is there.
const std::byte* begin_block(Reader& in, std::size_t least) {
    const std::span<const std::byte> rest = in.rest();
    const auto same = rest.empty() ? std::uint8_t{0} : std::to_integer<std::uint8_t>(rest[0]);
    const bool fits = same <= kSameAll && least + size_of_repeated(same) <= rest.size();
    return in.require(fits, "it ends in the middle of a block, or the block repeats what none does")
               ? rest.data()
               : nullptr;
}

}  // namespace

std::byte* put_colored_block(std::byte* at, const PairBlock& pairs, const ContactBlock& block, int used,
                             RepeatedParts& last) {
    at = put_pairs(at, pairs, used, last);
    for (const ContactBlockPoint& point : block.points) at = put_lanes(at, point.impulse, used, 0.0f);
    at = put_lanes(at, block.friction_impulse, used, 0.0f);
    return put(at, touching_lanes(block, used));
}

bool read_colored_block(Reader& in, PairBlock& pairs, ContactBlock& block, int used, RepeatedParts& last) {
    const std::byte* at = begin_block(in, kColoredBlockBytes.least);
    if (at == nullptr) return false;
    at = get_pairs(at, pairs, last, in.reading);
    for (ContactBlockPoint& point : block.points) at = get(at, point.impulse, in.reading);
    at = get(at, block.friction_impulse, in.reading);
    std::uint8_t touching = 0;
    in.end(get(at, touching, in.reading));
    for (int lane = 0; lane < kLanes; ++lane)
        block.points[0].separation[static_cast<std::size_t>(lane)] =
            (touching >> lane & 1) != 0 ? 0.0f : kApart_m;
    block.points[1].separation.fill(kApart_m);
    return in.require(touching <= lanes_below(used) && is_unused(pairs, used) && is_unused(block, used),
                      kUsed);
}

}  // namespace cairn::physics
