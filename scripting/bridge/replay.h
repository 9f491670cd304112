// A recorded run as text: what is needed to play it again bit by bit. Invariant: parse_replay(to_text(r))
// equals r.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/input.h>
#include <cairn/engine/result.h>

namespace cairn::scripting {

struct ReplayEvent {
    std::uint64_t frame = 1;  ///< of the update before which the event arrives; the first update is 1
    engine::InputEvent event;

    friend bool operator==(const ReplayEvent&, const ReplayEvent&) = default;
};

struct Replay {
    std::string game;
    std::uint64_t seed = 1;
    engine::Size size;  ///< logical: what mouse positions are measured in
    std::uint64_t frames = 0;
    std::optional<std::uint64_t> hash;  ///< of the state after the last frame
    std::vector<ReplayEvent> events;    ///< in order of frames

    friend bool operator==(const Replay&, const Replay&) = default;
};

std::string to_text(const Replay& replay);

/// Errors read "NAME:LINE: what is wrong".
engine::Result<Replay> parse_replay(std::string_view text, const std::string& name);

/// 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace cairn::scripting
