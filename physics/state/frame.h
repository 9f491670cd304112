// What stands before the contents of everything that is saved: what it is, of which version, how long, and a
// checksum of all that follows.
#pragma once

#include <cstdint>
#include <span>

#include "base/check.h"
#include "state/bytes.h"

namespace cairn::physics {

/// Eight letters each. The version is that of the format; a program reads its own only.
struct FrameKind {
    const char* magic;
    const char* name;  ///< "snapshot", for errors
    std::uint32_t version;
};

inline constexpr std::size_t kFrameBytes = 32;

/// Room for the frame, to be filled in when the contents are written.
void begin_frame(Writer& out);
void end_frame(Writer& out, const FrameKind& kind);

/// Why the bytes are not what they should be, if so: foreign, of another version, cut short, damaged.
check::Fault validate_frame(std::span<const std::byte> bytes, const FrameKind& kind);

}  // namespace cairn::physics
