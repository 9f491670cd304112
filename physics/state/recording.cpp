// States one behind the other, whole or as the difference from the one before. In a file:
//
//     frame | states between whole ones | their number | for each: size (8 bytes), whole? (1) | their bytes
#include <algorithm>
#include <utility>

#include <cairn/physics/recording.h>
#include <cairn/physics/world.h>

#include "state/frame.h"

namespace cairn::physics {
namespace {

constexpr FrameKind kRecording{"CairnRec", "recording", 1};

constexpr std::size_t kStateBytes = sizeof(std::uint64_t) + 1;

}  // namespace

Recording::Recording(int states_between_whole_ones) : between_(std::max(states_between_whole_ones, 1)) {}

std::span<const std::byte> Recording::bytes_of(int index) const {
    const auto i = static_cast<std::size_t>(index);
    const std::uint64_t first = states_[i].first_byte;
    const std::uint64_t last = i + 1 < states_.size() ? states_[i + 1].first_byte : bytes_.size();
    return std::span(bytes_).subspan(first, last - first);
}

Result<void> Recording::record(const World& world) {
    if (auto taken = world.snapshot(other_); !taken) return taken;
    bool is_whole = size() % between_ == 0;
    if (!is_whole) {
        const auto before = snapshot_of(size() - 1);
        if (!before) return before.error();
        if (auto made = make_delta(*before, other_.bytes(), delta_); !made) return made;
        is_whole = delta_.size() >= other_.size();
    }
    const std::span<const std::byte> bytes = is_whole ? other_.bytes() : delta_.bytes();
    states_.push_back({bytes_.size(), is_whole});
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    std::swap(snapshot_, other_);
    current_ = size() - 1;
    return {};
}

// Leaves the snapshot of the state in snapshot_. What is at hand already need not be put together again.
Result<std::span<const std::byte>> Recording::snapshot_of(int index) {
    int first = index;
    while (!states_[static_cast<std::size_t>(first)].is_whole && first != current_) --first;
    if (first != current_) {
        Writer(snapshot_).bytes(bytes_of(first));
        current_ = first;
    }
    for (int next = first + 1; next <= index; ++next) {
        if (auto applied = apply_delta(snapshot_.bytes(), bytes_of(next), other_); !applied)
            return applied.error();
        std::swap(snapshot_, other_);
        current_ = next;
    }
    return snapshot_.bytes();
}

Result<void> Recording::seek(World& world, int index) {
    if (index < 0 || index >= size()) {
        return Error{"the index is " + std::to_string(index) + ", but must be one of the " +
                     std::to_string(size()) + " states of the recording, from 0 on"};
    }
    const auto snapshot = snapshot_of(index);
    if (!snapshot) return snapshot.error();
    return world.restore(*snapshot);
}

Result<void> Recording::cut(int index) {
    if (index < 0 || index > size()) {
        return Error{"the index is " + std::to_string(index) + ", but must be from 0 to " +
                     std::to_string(size())};
    }
    if (index == size()) return {};
    bytes_.resize(states_[static_cast<std::size_t>(index)].first_byte);
    states_.resize(static_cast<std::size_t>(index));
    if (current_ >= index) current_ = -1;
    return {};
}

Result<void> Recording::save(Snapshot& into) const {
    Writer out(into);
    begin_frame(out);
    out.value(static_cast<std::uint32_t>(between_));
    out.count(states_.size());
    for (int i = 0; i < size(); ++i) {
        out.value(static_cast<std::uint64_t>(bytes_of(i).size()));
        out.value(states_[static_cast<std::size_t>(i)].is_whole);
    }
    out.bytes(bytes_);
    end_frame(out, kRecording);
    return {};
}

Result<void> Recording::load(std::span<const std::byte> bytes) {
    if (auto fault = validate_frame(bytes, kRecording)) return *fault;
    Reader in(bytes, kFrameBytes, 0, kRecording.name);
    in.begin("list of states");
    std::uint32_t between = 0;
    in.value(between);
    in.require(between >= 1 && between <= 1u << 30, "whole states have no distance");
    std::vector<State> states(in.count(kStateBytes));
    std::uint64_t total = 0;
    for (State& state : states) {
        std::uint64_t size = 0;
        in.value(size);
        in.value(state.is_whole);
        state.first_byte = total;
        in.require(size <= bytes.size() && total <= bytes.size(), "a state is larger than the recording");
        total += size;
    }
    in.settle();
    in.require(states.empty() || states.front().is_whole, "the first state is not whole");
    const std::span<const std::byte> rest = in.rest();
    if (in.ok()) in.require(rest.size() == total, "the states do not fill the recording");
    if (in.fault()) return *in.fault();
    between_ = static_cast<int>(between);
    states_ = std::move(states);
    bytes_.assign(rest.begin(), rest.end());
    current_ = -1;
    return {};
}

}  // namespace cairn::physics
