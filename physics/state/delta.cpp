// The difference of two snapshots: of blocks of 64 bytes, words of 8. For runs of equal blocks a number, then
// for each block that differs a byte that tells which of its words do, and these.
//
//     frame | checksum of the base | size of the base | size of the target | runs
//     run: equal blocks (4 bytes), other blocks (4 bytes), then the others
#include <cstring>

#include <cairn/physics/recording.h>

#include "state/checksum.h"
#include "state/frame.h"

namespace cairn::physics {
namespace {

constexpr FrameKind kDelta{"CairnDel", "delta", 1};

constexpr std::size_t kWords = 8;
using Block = std::array<std::uint64_t, kWords>;

// The block at `index`, with zeros behind the end.
Block block_at(std::span<const std::byte> bytes, std::size_t index) {
    Block block{};
    const std::size_t first = index * sizeof(Block);
    if (first < bytes.size())
        std::memcpy(block.data(), bytes.data() + first, std::min(sizeof(Block), bytes.size() - first));
    return block;
}

std::uint8_t differing_words(const Block& a, const Block& b) {
    unsigned words = 0;
    for (std::size_t i = 0; i < kWords; ++i) words |= (a[i] != b[i] ? 1u : 0u) << i;
    return static_cast<std::uint8_t>(words);
}

std::size_t block_count(std::size_t bytes) {
    return (bytes + sizeof(Block) - 1) / sizeof(Block);
}

}  // namespace

Result<void> make_delta(std::span<const std::byte> base, std::span<const std::byte> target, Snapshot& delta) {
    Writer out(delta);
    begin_frame(out);
    out.value(checksum(base));
    out.value(static_cast<std::uint64_t>(base.size()));
    out.value(static_cast<std::uint64_t>(target.size()));
    const std::size_t blocks = block_count(target.size());
    std::byte* at = out.room(blocks * (sizeof(Block) + 1 + 2 * sizeof(std::uint32_t)));
    const auto is_equal = [&](std::size_t i) {
        return i < block_count(base.size()) && block_at(base, i) == block_at(target, i);
    };
    for (std::size_t i = 0; i < blocks;) {
        std::uint32_t equal = 0;
        std::uint32_t other = 0;
        for (; i < blocks && is_equal(i); ++i) ++equal;
        std::byte* const run = at;
        at += 2 * sizeof(std::uint32_t);
        for (; i < blocks && !is_equal(i); ++i) {
            const Block block = block_at(target, i);
            const std::uint8_t words = differing_words(block_at(base, i), block);
            at = put(at, words);
            for (std::size_t w = 0; w < kWords; ++w) {
                if ((words >> w & 1) != 0) at = put(at, block[w]);
            }
            ++other;
        }
        put(put(run, equal), other);
    }
    out.end(at);
    end_frame(out, kDelta);
    return {};
}

Result<void> apply_delta(std::span<const std::byte> base, std::span<const std::byte> delta,
                         Snapshot& target) {
    if (auto fault = validate_frame(delta, kDelta)) return *fault;
    Reader in(delta, kFrameBytes, 0, "delta");
    in.begin("runs");
    std::uint64_t base_sum = 0;
    std::uint64_t base_size = 0;
    std::uint64_t size = 0;
    in.value(base_sum);
    in.value(base_size);
    in.value(size);
    if (in.ok() && (base_size != base.size() || base_sum != checksum(base)))
        return Error{"the delta is of another snapshot than the one that it is applied to"};
    // A block takes a byte at least, but for those of the base.
    if (in.ok() && size > base.size() + sizeof(Block) * std::uint64_t{delta.size()})
        in.fail("it makes more than it could hold");
    Writer out(target);
    const std::size_t blocks = in.ok() ? block_count(size) : 0;
    std::byte* at = out.room(blocks * sizeof(Block));
    for (std::size_t i = 0; i < blocks && in.ok();) {
        std::uint32_t equal = 0;
        std::uint32_t other = 0;
        in.value(equal);
        in.value(other);
        in.require(equal + std::uint64_t{other} <= blocks - i && equal + std::uint64_t{other} > 0,
                   "a run goes on beyond the end");
        for (; in.ok() && equal > 0; --equal) at = put(at, block_at(base, i++));
        for (; in.ok() && other > 0; --other) {
            Block block = block_at(base, i++);
            std::uint8_t words = 0;
            in.value(words);
            for (std::size_t w = 0; w < kWords; ++w) {
                if ((words >> w & 1) != 0) in.value(block[w]);
            }
            at = put(at, block);
        }
    }
    if (in.ok()) in.require(in.at_end(), "there is more than there should be");
    if (in.fault()) return *in.fault();
    out.end(out.data() + size);
    return {};
}

}  // namespace cairn::physics
