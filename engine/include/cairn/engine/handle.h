// Small typed names for things that the engine owns (textures, fonts, sounds, voices).
// Invariant: generation 0 is never given out, so the zero handle is null; a handle of something that was
// freed does not name whatever took its place.
#pragma once

#include <cstdint>

namespace cairn::engine {

template <typename Tag>
struct Handle {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;

    bool is_null() const { return generation == 0; }
    friend bool operator==(Handle, Handle) = default;
};

using TextureId = Handle<struct TextureTag>;
using FontId = Handle<struct FontTag>;
using SoundId = Handle<struct SoundTag>;
using VoiceId = Handle<struct VoiceTag>;

}  // namespace cairn::engine
