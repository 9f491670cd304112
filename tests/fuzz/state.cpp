// Fuzz target: snapshots that were changed, under a checksum that fits. A world either refuses one, and stays
// as it was, or has a state in which it goes on: it steps, its snapshots can be restored, and it gives the
// same bits twice.
#include <cstring>
#include <vector>

#include "fuzz/input.h"
#include "physics/state/state_scenes.h"
#include "state/checksum.h"

using namespace cairn::physics;
using fuzz::require;

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kFrame = 32;  // the checksum is its last word
constexpr int kWarmUp = 45;         // steps, until there is something of everything

// Of each scene, made once.
const std::vector<Bytes>& snapshots() {
    static const std::vector<Bytes> all = [] {
        std::vector<Bytes> made;
        for (const test::Scene& scene : test::state_scenes()) {
            World world;
            scene.build(world);
            for (int step = 0; step < kWarmUp; ++step) {
                scene.act(world, step);
                world.step(test::kStep_s).value();
            }
            const Snapshot snapshot = world.snapshot().value();
            made.emplace_back(snapshot.bytes().begin(), snapshot.bytes().end());
        }
        return made;
    }();
    return all;
}

std::uint32_t any_word(fuzz::Input& in) {
    constexpr std::array<std::uint32_t, 6> kSpecial{0, 0xffffffff, 0x7f800000, 0x7fffffff, 0x80000000, 1};
    const int choice = in.below(12);
    if (choice < static_cast<int>(kSpecial.size())) return kSpecial[static_cast<std::size_t>(choice)];
    return choice < 9 ? in.byte() : static_cast<std::uint32_t>(in.bits());
}

void change(Bytes& bytes, fuzz::Input& in) {
    while (!in.is_empty()) {
        const std::size_t at = kFrame + in.bits() % (bytes.size() - kFrame - sizeof(std::uint32_t));
        const std::uint32_t word = any_word(in);
        switch (in.below(4)) {
            case 0:
                bytes[at] = static_cast<std::byte>(word);
                break;
            case 1:
                bytes[at] ^= static_cast<std::byte>(1u << word % 8);
                break;
            case 2:
                std::memcpy(bytes.data() + at, &word, sizeof word);
                break;
            default:  // a word from elsewhere
                std::memcpy(bytes.data() + at,
                            bytes.data() + kFrame + in.bits() % (bytes.size() - kFrame - sizeof word),
                            sizeof word);
        }
    }
    const std::uint64_t sum = checksum(std::span(bytes).subspan(kFrame));
    std::memcpy(bytes.data() + kFrame - sizeof sum, &sum, sizeof sum);
}

void go_on(World& world, int steps) {
    for (int step = 0; step < steps; ++step)
        require(static_cast<bool>(world.step(test::kStep_s)), "it steps");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    Bytes bytes = snapshots()[static_cast<std::size_t>(in.below(static_cast<int>(snapshots().size())))];
    World world;
    test::build_stack(world);
    const std::uint64_t before = world.state_hash();
    change(bytes, in);
    if (const Result<void> restored = world.restore(bytes); !restored) {
        require(!restored.error().message.empty(), "an error has a message");
        require(world.state_hash() == before, "a refused snapshot changes nothing");
        go_on(world, 1);
        return 0;
    }
    go_on(world, 2);
    const Snapshot later = world.snapshot().value();
    World twin;
    if (!twin.restore(later.bytes())) return 0;  // nonsense may grow to what is refused
    require(twin.state_hash() == world.state_hash(), "a restored world is as the one that was saved");
    go_on(world, 2);
    go_on(twin, 2);
    require(twin.state_hash() == world.state_hash(), "a restored world goes on as the one that was saved");
    for (const BodyId id : world.bodies()) require(static_cast<bool>(world.destroy_body(id)), "bodies go");
    go_on(world, 1);
    return 0;
}
