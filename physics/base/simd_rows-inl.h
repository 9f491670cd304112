// Rows of four floats read into and written from SIMD registers, one quantity of several rows per register.
// Rows are loaded whole and transposed, which is faster than gathers. To be included between
// HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE users, once per target.
#if defined(CAIRN_PHYSICS_BASE_SIMD_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_BASE_SIMD_ROWS_INL_H_
#undef CAIRN_PHYSICS_BASE_SIMD_ROWS_INL_H_
#else
#define CAIRN_PHYSICS_BASE_SIMD_ROWS_INL_H_
#endif

#include <cstdint>
#include <cstring>
#include <hwy/highway.h>

#include "base/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kLanes>;
using V = hn::Vec<D>;
using DI = hn::RebindToSigned<D>;
using VI = hn::Vec<DI>;
using M = hn::Mask<D>;

inline constexpr int kStep = static_cast<int>(hn::MaxLanes(D()));  // lanes that one register holds

HWY_INLINE V set(float x) {
    return hn::Set(D(), x);
}
HWY_INLINE VI set_int(std::int32_t x) {
    return hn::Set(DI(), x);
}
HWY_INLINE V load(const Lanes<float>& lanes, int lane) {
    return hn::Load(D(), lanes.data() + lane);
}
HWY_INLINE VI load(const Lanes<std::int32_t>& lanes, int lane) {
    return hn::Load(DI(), lanes.data() + lane);
}
HWY_INLINE void store(V v, Lanes<float>& lanes, int lane) {
    hn::Store(v, D(), lanes.data() + lane);
}
HWY_INLINE void store(VI v, Lanes<std::int32_t>& lanes, int lane) {
    hn::Store(v, DI(), lanes.data() + lane);
}

// The lanes of which the bit is set.
HWY_INLINE M wanted_lanes(unsigned lanes, int lane) {
    alignas(32) static constexpr Lanes<std::int32_t> kBits{1, 2, 4, 8, 16, 32, 64, 128};
    const VI bits = hn::And(load(kBits, lane), set_int(static_cast<std::int32_t>(lanes)));
    return hn::RebindMask(D(), hn::Ne(bits, hn::Zero(DI())));
}

// The numbers in some lanes; those that are not wanted are 0.
HWY_INLINE void load_wanted(const Lanes<std::int32_t>& numbers, M wanted, int lane, std::int32_t* out) {
    hn::Store(hn::IfThenElseZero(hn::RebindMask(DI(), wanted), load(numbers, lane)), DI(), out);
}

// One bit per lane of a register.
HWY_INLINE unsigned bits_of(M mask) {
    std::uint8_t bits = 0;
    hn::StoreMaskBits(D(), mask, &bits);
    return bits;
}

struct Columns {
    V x, y, z, u;
};

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Columns load_rows(const float* rows, const std::int32_t* index) {
    const float* row = rows + 4 * index[0];
    return {set(row[0]), set(row[1]), set(row[2]), set(row[3])};
}

// Rows that stand anywhere: what four floats behind each pointer take up, from an offset on, whatever it is.
HWY_INLINE Columns load_rows(const float* const* rows, int offset) {
    float row[4];
    std::memcpy(row, rows[0] + offset, sizeof row);
    return {set(row[0]), set(row[1]), set(row[2]), set(row[3])};
}

HWY_INLINE void store_rows(float* rows, const std::int32_t* index, const Columns& c) {
    float* row = rows + 4 * index[0];
    row[0] = hn::GetLane(c.x);
    row[1] = hn::GetLane(c.y);
    row[2] = hn::GetLane(c.z);
    row[3] = hn::GetLane(c.u);
}

#else

// Transposes the 4 x 4 matrix in each 128-bit part.
HWY_INLINE void transpose(V& a, V& b, V& c, V& e) {
    const hn::Repartition<double, D> pairs;
    const D d;
    const V ab_low = hn::InterleaveLower(d, a, b);
    const V ab_high = hn::InterleaveUpper(d, a, b);
    const V ce_low = hn::InterleaveLower(d, c, e);
    const V ce_high = hn::InterleaveUpper(d, c, e);
    const auto ab_low2 = hn::BitCast(pairs, ab_low);
    const auto ab_high2 = hn::BitCast(pairs, ab_high);
    const auto ce_low2 = hn::BitCast(pairs, ce_low);
    const auto ce_high2 = hn::BitCast(pairs, ce_high);
    a = hn::BitCast(d, hn::InterleaveLower(pairs, ab_low2, ce_low2));
    b = hn::BitCast(d, hn::InterleaveUpper(pairs, ab_low2, ce_low2));
    c = hn::BitCast(d, hn::InterleaveLower(pairs, ab_high2, ce_high2));
    e = hn::BitCast(d, hn::InterleaveUpper(pairs, ab_high2, ce_high2));
}

// Rows i and i + 4 stand in the two halves of one register, or row i alone where registers hold four.
HWY_INLINE V load_row(const float* rows, const std::int32_t* index, int i) {
    const hn::FixedTag<float, 4> quad;
    const auto low = hn::Load(quad, rows + 4 * index[i]);
#if HWY_MAX_BYTES >= 32
    return hn::Combine(D(), hn::Load(quad, rows + 4 * index[i + 4]), low);
#else
    return low;
#endif
}

HWY_INLINE void store_row(float* rows, const std::int32_t* index, int i, V v) {
    const hn::FixedTag<float, 4> quad;
#if HWY_MAX_BYTES >= 32
    hn::Store(hn::LowerHalf(quad, v), quad, rows + 4 * index[i]);
    hn::Store(hn::UpperHalf(quad, v), quad, rows + 4 * index[i + 4]);
#else
    hn::Store(v, quad, rows + 4 * index[i]);
#endif
}

HWY_INLINE Columns load_rows(const float* rows, const std::int32_t* index) {
    Columns c{load_row(rows, index, 0), load_row(rows, index, 1), load_row(rows, index, 2),
              load_row(rows, index, 3)};
    transpose(c.x, c.y, c.z, c.u);
    return c;
}

// Rows that stand anywhere: four floats behind each pointer, from an offset on.
HWY_INLINE Columns load_rows(const float* const* rows, int offset) {
    const hn::FixedTag<float, 4> quad;
    const auto row = [&](int i) {
        const auto low = hn::LoadU(quad, rows[i] + offset);
#if HWY_MAX_BYTES >= 32
        return hn::Combine(D(), hn::LoadU(quad, rows[i + 4] + offset), low);
#else
        return low;
#endif
    };
    Columns c{row(0), row(1), row(2), row(3)};
    transpose(c.x, c.y, c.z, c.u);
    return c;
}

HWY_INLINE void store_rows(float* rows, const std::int32_t* index, Columns c) {
    transpose(c.x, c.y, c.z, c.u);
    store_row(rows, index, 0, c.x);
    store_row(rows, index, 1, c.y);
    store_row(rows, index, 2, c.z);
    store_row(rows, index, 3, c.u);
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
