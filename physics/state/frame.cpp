// magic (8 bytes), version (4), 0 (4), size of all (8), checksum of all else (8); little endian.
#include "state/frame.h"

#include <cstring>

#include "state/checksum.h"

namespace cairn::physics {
namespace {

constexpr std::size_t kMagicBytes = 8;

struct Frame {
    std::array<char, kMagicBytes> magic{};
    std::uint32_t version = 0;
    std::uint32_t zero = 0;
    std::uint64_t size = 0;
    std::uint64_t checksum = 0;
};
static_assert(sizeof(Frame) == kFrameBytes);

Frame frame_of(std::span<const std::byte> bytes, const FrameKind& kind) {
    Frame frame;
    std::memcpy(frame.magic.data(), kind.magic, kMagicBytes);
    frame.version = kind.version;
    frame.size = bytes.size();
    frame.checksum = checksum(bytes.subspan(kFrameBytes));
    return frame;
}

}  // namespace

void begin_frame(Writer& out) {
    out.end(out.room(kFrameBytes) + kFrameBytes);
}

void end_frame(Writer& out, const FrameKind& kind) {
    const Frame frame = frame_of({out.data(), out.size()}, kind);
    std::memcpy(out.data(), &frame, kFrameBytes);
}

check::Fault validate_frame(std::span<const std::byte> bytes, const FrameKind& kind) {
    const std::string name = kind.name;
    if (bytes.size() < kFrameBytes) {
        return Error{"the " + name + " has " + std::to_string(bytes.size()) +
                     " bytes, but must have at least " + std::to_string(kFrameBytes)};
    }
    Frame found;
    std::memcpy(&found, bytes.data(), kFrameBytes);
    if (std::memcmp(found.magic.data(), kind.magic, kMagicBytes) != 0)
        return Error{"the bytes are no " + name + ": they must begin with " + kind.magic};
    if (found.version != kind.version || found.zero != 0) {
        return Error{"the " + name + " is of version " + std::to_string(found.version) + ", but must be of " +
                     std::to_string(kind.version) + ", which this program reads and writes"};
    }
    if (found.size != bytes.size()) {
        return Error{"the " + name + " has " + std::to_string(bytes.size()) +
                     " bytes, but says that it has " + std::to_string(found.size)};
    }
    if (found.checksum != frame_of(bytes, kind).checksum)
        return Error{"the " + name + " is damaged: its checksum is not that of its contents"};
    return {};
}

}  // namespace cairn::physics
