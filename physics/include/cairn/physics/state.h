// The state of a world as bytes: to go back to, to save, to send.
//
// A snapshot holds everything that what follows depends on, so a world that is restored goes on as the one it
// was taken from did, bit for bit, on every machine and on any number of threads. Handles and user data are
// part of it: what a handle named when the snapshot was taken, it names again. The bytes have a version and a
// checksum; damaged or foreign ones are refused, and the world stays as it was.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace cairn::physics {

/// Bytes of a snapshot, made by World::snapshot. Movable; used again, it allocates only to grow.
class Snapshot {
  public:
    /// Plain bytes, to be written to a file as they are. Valid until the snapshot is made anew.
    [[nodiscard]] std::span<const std::byte> bytes() const { return {bytes_.get(), size_}; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }

  private:
    friend class Writer;

    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace cairn::physics
