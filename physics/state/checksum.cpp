// Eight sums of 64 bits, word i of each eight into sum i. A word w gives its sum the product of the halves of
// w ^ key, and its neighbour's sum itself, so that a product of 0 hides nothing; keys differ from eight to
// eight, so that places count. Source: the accumulation of XXH3 (Collet 2019); the sums are joined by the
// round of base/state_hash.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "state/checksum.cpp"
#include "state/checksum.h"

#include <array>
#include <cstring>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef CAIRN_PHYSICS_STATE_CHECKSUM_CPP_
#define CAIRN_PHYSICS_STATE_CHECKSUM_CPP_
namespace cairn::physics {

inline constexpr std::size_t kSums = 8;
inline constexpr std::uint64_t kKeyStep = 0x9e3779b97f4a7c15u;

using Words = std::array<std::uint64_t, kSums>;

}  // namespace cairn::physics
#endif

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

// The same without vectors, which have no neighbours to swap.
void add_words(const std::uint64_t* words, std::size_t count, const Words& keys, Words& sums) {
    Words key = keys;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t lane = 0; lane < kSums; ++lane) {
            const std::uint64_t mixed = words[kSums * i + lane] ^ key[lane];
            sums[lane] += (mixed & 0xffffffff) * (mixed >> 32) + words[kSums * i + (lane ^ 1)];
            key[lane] += kKeyStep;
        }
    }
}

#else

template <class D, class V = hn::Vec<D>>
HWY_INLINE V added(D d, V sum, V word, V key) {
    const hn::Repartition<std::uint32_t, D> halves;
    const V mixed = hn::Xor(word, key);
    const V product = hn::MulEven(hn::BitCast(halves, mixed), hn::BitCast(halves, hn::ShiftRight<32>(mixed)));
    return hn::Add(sum, hn::Add(product, hn::Reverse2(d, word)));
}

// Of so many times eight words. Two vectors at a time: with four lanes one walk over the bytes is enough.
void add_words(const std::uint64_t* words, std::size_t count, const Words& keys, Words& sums) {
    const hn::CappedTag<std::uint64_t, kSums / 2> d;
    const std::size_t lanes = hn::Lanes(d);
    const auto step = hn::Set(d, kKeyStep);
    for (std::size_t lane = 0; lane < kSums; lane += 2 * lanes) {
        auto sum_a = hn::Zero(d);
        auto sum_b = hn::Zero(d);
        auto key_a = hn::LoadU(d, keys.data() + lane);
        auto key_b = hn::LoadU(d, keys.data() + lane + lanes);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t* const at = words + kSums * i + lane;
            sum_a = added(d, sum_a, hn::LoadU(d, at), key_a);
            sum_b = added(d, sum_b, hn::LoadU(d, at + lanes), key_b);
            key_a = hn::Add(key_a, step);
            key_b = hn::Add(key_b, step);
        }
        hn::StoreU(sum_a, d, sums.data() + lane);
        hn::StoreU(sum_b, d, sums.data() + lane + lanes);
    }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {
namespace {

HWY_EXPORT(add_words);

std::uint64_t round(std::uint64_t state, std::uint64_t word) {
    state = (state ^ word) * 0x87c37b91114253d5u;
    return state ^ state >> 32;
}

}  // namespace

std::uint64_t checksum(std::span<const std::byte> bytes) {
    Words keys;
    for (std::size_t i = 0; i < kSums; ++i) keys[i] = round(kKeyStep, i + 1);
    const std::size_t count = bytes.size() / sizeof(Words);
    Words sums{};
    HWY_DYNAMIC_DISPATCH(add_words)
    (reinterpret_cast<const std::uint64_t*>(bytes.data()), count, keys, sums);
    Words rest{};
    if (const std::size_t whole = count * sizeof(Words); whole < bytes.size())
        std::memcpy(rest.data(), bytes.data() + whole, bytes.size() - whole);
    std::uint64_t sum = bytes.size();
    for (std::size_t i = 0; i < kSums; ++i) sum = round(round(sum, sums[i]), rest[i]);
    return sum;
}

}  // namespace cairn::physics
#endif
