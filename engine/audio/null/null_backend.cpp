// The silent back-end. Invariant: it keeps nothing, because Audio keeps the books.
#include "audio/null/null_backend.h"

namespace cairn::engine {
namespace {

class NullAudio final : public AudioBackend {
  public:
    void start_voice(int, const SoundData&, const VoiceSettings&) override {}
    void stop_voice(int) override {}
    void set_voice_volume(int, float) override {}
    void set_voice_pan(int, float) override {}
    void set_voice_pitch(int, float) override {}
    void set_voice_paused(int, bool) override {}
    void start_music(SoundData, float, bool) override {}
    void stop_music() override {}
    void set_music_volume(float) override {}
    void set_music_paused(bool) override {}
    bool is_device_open() const override { return false; }
};

}  // namespace

std::unique_ptr<AudioBackend> make_null_audio() {
    return std::make_unique<NullAudio>();
}

}  // namespace cairn::engine
