// The back-end on SDL2_mixer. Invariant: voice slot i plays on mixer channel i; the bytes of a chunk or of
// the music live until no channel plays them.
#include "audio/sdl/mixer_backend.h"

#include <SDL.h>
#include <SDL_mixer.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <cairn/engine/log.h>

#include "audio/sdl/resample.h"

namespace cairn::engine {
namespace {

constexpr int kRate_hz = 44100;
/// 23 ms of delay: less crackles on slow machines, more is heard as late.
constexpr int kBufferFrames = 1024;
/// Of resampled copies; a second in one takes 176 kB.
constexpr std::size_t kMaxChunks = 128;

struct ChunkDeleter {
    void operator()(Mix_Chunk* chunk) const { Mix_FreeChunk(chunk); }
};
struct MusicDeleter {
    void operator()(Mix_Music* music) const { Mix_FreeMusic(music); }
};

int to_mixer_volume(float volume) {
    return static_cast<int>(std::lround(volume * MIX_MAX_VOLUME));
}

class MixerBackend final : public AudioBackend {
  public:
    ~MixerBackend() override {
        if (!is_open_) return;
        Mix_HaltChannel(-1);
        chunks_.clear();
        music_.reset();
        Mix_CloseAudio();
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
    }

    void start_voice(int slot, const SoundData& sound, const VoiceSettings& settings) override {
        if (!open_device()) return;
        Mix_HaltChannel(slot);
        Mix_Chunk* chunk = find_chunk(sound, settings.pitch_step);
        if (!chunk) return;
        Mix_Volume(slot, to_mixer_volume(settings.volume));
        pan(slot, settings.pan);
        if (Mix_PlayChannel(slot, chunk, settings.loop ? -1 : 0) < 0) warn_once(sound.path, Mix_GetError());
    }

    void stop_voice(int slot) override {
        if (is_open_) Mix_HaltChannel(slot);
    }

    void set_voice_volume(int slot, float volume) override {
        if (is_open_) Mix_Volume(slot, to_mixer_volume(volume));
    }

    void set_voice_pan(int slot, float where) override {
        if (is_open_) pan(slot, where);
    }

    void set_voice_paused(int slot, bool paused) override {
        if (!is_open_) return;
        if (paused)
            Mix_Pause(slot);
        else
            Mix_Resume(slot);
    }

    void set_music_paused(bool paused) override {
        if (!is_open_) return;
        if (paused)
            Mix_PauseMusic();
        else
            Mix_ResumeMusic();
    }

    void start_music(SoundData music, float volume, bool loop) override {
        if (!open_device()) return;
        stop_music();
        music_data_ = std::move(music);
        SDL_RWops* stream =
            SDL_RWFromConstMem(music_data_.file.data(), static_cast<int>(music_data_.file.size()));
        music_.reset(stream ? Mix_LoadMUS_RW(stream, /*freesrc=*/1) : nullptr);
        Mix_VolumeMusic(to_mixer_volume(volume));
        if (!music_ || Mix_PlayMusic(music_.get(), loop ? -1 : 0) != 0)
            warn_once(music_data_.path, Mix_GetError());
    }

    void stop_music() override {
        if (!is_open_) return;
        Mix_HaltMusic();
        music_.reset();
    }

    void set_music_volume(float volume) override {
        if (is_open_) Mix_VolumeMusic(to_mixer_volume(volume));
    }

    bool is_device_open() const override { return is_open_; }

  private:
    /// A mixer chunk and, for a resampled one, the samples that it points to.
    struct Chunk {
        std::vector<std::int16_t> samples;
        std::unique_ptr<Mix_Chunk, ChunkDeleter> chunk;
    };
    using ChunkKey = std::pair<std::uint32_t, int>;  ///< sound and pitch step

    static void pan(int slot, float where) {
        Mix_SetPanning(slot, static_cast<Uint8>(255 * std::min(1.0f, 1 - where)),
                       static_cast<Uint8>(255 * std::min(1.0f, 1 + where)));
    }

    bool open_device() {
        if (is_open_ || std::exchange(has_tried_, true)) return is_open_;
        if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) {
            log(LogLevel::Warning, std::string("no sound: ") + SDL_GetError());
            return false;
        }
        // The mixer may not change the format: the resampler relies on 16-bit stereo.
        if (Mix_OpenAudioDevice(kRate_hz, AUDIO_S16SYS, 2, kBufferFrames, nullptr, 0) != 0) {
            log(LogLevel::Warning, std::string("no sound: ") + Mix_GetError());
            SDL_QuitSubSystem(SDL_INIT_AUDIO);
            return false;
        }
        is_open_ = true;
        Mix_AllocateChannels(Audio::kMaxVoices);
        return true;
    }

    void warn_once(const std::string& path, const std::string& reason) {
        if (complaints_.insert(path).second)
            log(LogLevel::Warning, "sound '" + path + "' cannot be played: " + reason);
    }

    Mix_Chunk* find_chunk(const SoundData& sound, int pitch_step) {
        if (const auto known = chunks_.find({sound.key, pitch_step}); known != chunks_.end())
            return known->second.chunk.get();
        if (chunks_.size() >= kMaxChunks) drop_idle_chunks();

        Chunk made;
        if (pitch_step == 0) {
            SDL_RWops* stream = SDL_RWFromConstMem(sound.file.data(), static_cast<int>(sound.file.size()));
            made.chunk.reset(stream ? Mix_LoadWAV_RW(stream, /*freesrc=*/1) : nullptr);
        } else {
            const Mix_Chunk* original = find_chunk(sound, 0);
            if (!original) return nullptr;
            std::vector<std::int16_t> samples(original->alen / sizeof(std::int16_t));
            std::memcpy(samples.data(), original->abuf, samples.size() * sizeof(std::int16_t));
            made.samples =
                resample_stereo(samples, std::exp2(static_cast<double>(pitch_step) / kPitchStepsPerOctave));
            made.chunk.reset(
                Mix_QuickLoad_RAW(reinterpret_cast<Uint8*>(made.samples.data()),
                                  static_cast<Uint32>(made.samples.size() * sizeof(std::int16_t))));
        }
        if (!made.chunk) {
            warn_once(sound.path, Mix_GetError());
            return nullptr;
        }
        return chunks_.emplace(ChunkKey{sound.key, pitch_step}, std::move(made)).first->second.chunk.get();
    }

    /// Freeing a chunk that plays would cut it off.
    void drop_idle_chunks() {
        std::erase_if(chunks_, [](const auto& entry) {
            for (int channel = 0; channel < Audio::kMaxVoices; ++channel)
                if (Mix_Playing(channel) && Mix_GetChunk(channel) == entry.second.chunk.get()) return false;
            return true;
        });
    }

    bool is_open_ = false;
    bool has_tried_ = false;
    std::map<ChunkKey, Chunk> chunks_;
    SoundData music_data_;
    std::unique_ptr<Mix_Music, MusicDeleter> music_;
    std::set<std::string> complaints_;
};

}  // namespace

std::unique_ptr<AudioBackend> make_mixer_audio() {
    return std::make_unique<MixerBackend>();
}

}  // namespace cairn::engine
