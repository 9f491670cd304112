// What makes audible what Audio has decided to play.
// Invariant: it decides nothing itself: which voices play, how loud and how long, is known before it is
// asked.
//
// To add a back-end: derive from AudioBackend, and let a Platform make it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <cairn/engine/audio.h>

namespace cairn::engine {

/// A sound as it lies in memory; it stays there as long as Audio lives.
struct SoundData {
    std::uint32_t key = 0;  ///< differs between sounds
    std::string path;
    std::vector<std::byte> file;
};

struct VoiceSettings {
    float volume = 1;  ///< 0 .. 1, the group's volume included
    float pan = 0;     ///< -1 .. 1
    float pitch = 1;   ///< 0.25 .. 4
    bool loop = false;
};

class AudioBackend {
  public:
    virtual ~AudioBackend() = default;

    /// `slot` is 0 .. Audio::kMaxVoices - 1; what played there stops.
    virtual void start_voice(int slot, const SoundData& sound, const VoiceSettings& settings) = 0;
    virtual void stop_voice(int slot) = 0;
    virtual void set_voice_volume(int slot, float volume) = 0;
    virtual void set_voice_pan(int slot, float pan) = 0;
    virtual void set_voice_pitch(int slot, float pitch) = 0;
    virtual void set_voice_paused(int slot, bool paused) = 0;

    virtual void start_music(SoundData music, float volume, bool loop) = 0;
    virtual void stop_music() = 0;
    virtual void set_music_volume(float volume) = 0;
    virtual void set_music_paused(bool paused) = 0;

    virtual bool is_device_open() const = 0;
};

}  // namespace cairn::engine
