// The back-end on SDL2_mixer. Invariant: voice slot i plays on mixer channel i; the samples of a sound and
// the bytes of the music live until no channel plays them. The mixer cannot change the speed of a channel, so
// each channel plays silence for ever, into which its stream writes what is heard.
#include "audio/sdl/mixer_backend.h"

#include <SDL.h>
#include <SDL_mixer.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <cairn/engine/log.h>

#include "audio/sdl/voice_stream.h"

namespace cairn::engine {
namespace {

constexpr int kRate_hz = 44100;
/// 23 ms of delay: less crackles on slow machines, more is heard as late.
constexpr int kBufferFrames = 1024;
/// Decoded; a second takes 176 kB.
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
        silence_.reset();
        music_.reset();
        Mix_CloseAudio();
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
    }

    void start_voice(int slot, const SoundData& sound, const VoiceSettings& settings) override {
        if (!open_device()) return;
        Mix_HaltChannel(slot);
        const Mix_Chunk* chunk = find_chunk(sound);
        if (!chunk) return;
        Voice& voice = voices_[static_cast<std::size_t>(slot)];
        voice.chunk = chunk;
        voice.stream.start({reinterpret_cast<const std::int16_t*>(chunk->abuf), chunk->alen / 2},
                           settings.pitch, settings.loop);
        Mix_Volume(slot, to_mixer_volume(settings.volume));
        if (Mix_PlayChannel(slot, silence_.get(), -1) < 0) return warn_once(sound.path, Mix_GetError());
        // In this order: what the stream writes is panned.
        Mix_RegisterEffect(slot, fill, nullptr, &voice.stream);
        pan(slot, settings.pan);
    }

    void stop_voice(int slot) override {
        if (is_open_) Mix_HaltChannel(slot);
    }

    void set_voice_pitch(int slot, float pitch) override {
        voices_[static_cast<std::size_t>(slot)].stream.set_pitch(pitch);
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
    using Chunk = std::unique_ptr<Mix_Chunk, ChunkDeleter>;
    struct Voice {
        const Mix_Chunk* chunk = nullptr;  ///< that the stream reads
        VoiceStream stream;
    };

    /// The mixer's effect of each channel, on its own thread.
    static void fill(int, void* buffer, int bytes, void* stream) {
        static_cast<VoiceStream*>(stream)->fill(
            {static_cast<std::int16_t*>(buffer), static_cast<std::size_t>(bytes) / sizeof(std::int16_t)});
    }

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
        // The mixer may not change the format: streams rely on 16-bit stereo.
        if (Mix_OpenAudioDevice(kRate_hz, AUDIO_S16SYS, 2, kBufferFrames, nullptr, 0) != 0) {
            log(LogLevel::Warning, std::string("no sound: ") + Mix_GetError());
            SDL_QuitSubSystem(SDL_INIT_AUDIO);
            return false;
        }
        is_open_ = true;
        Mix_AllocateChannels(Audio::kMaxVoices);
        silence_.reset(Mix_QuickLoad_RAW(no_sound_.data(), static_cast<Uint32>(no_sound_.size())));
        return true;
    }

    void warn_once(const std::string& path, const std::string& reason) {
        if (complaints_.insert(path).second)
            log(LogLevel::Warning, "sound '" + path + "' cannot be played: " + reason);
    }

    /// Decoded when it is first played.
    const Mix_Chunk* find_chunk(const SoundData& sound) {
        if (const auto known = chunks_.find(sound.key); known != chunks_.end()) return known->second.get();
        if (chunks_.size() >= kMaxChunks) drop_idle_chunks();
        SDL_RWops* stream = SDL_RWFromConstMem(sound.file.data(), static_cast<int>(sound.file.size()));
        Chunk chunk(stream ? Mix_LoadWAV_RW(stream, /*freesrc=*/1) : nullptr);
        if (!chunk) {
            warn_once(sound.path, Mix_GetError());
            return nullptr;
        }
        return chunks_.emplace(sound.key, std::move(chunk)).first->second.get();
    }

    /// What is still read stays.
    void drop_idle_chunks() {
        std::erase_if(chunks_, [&](const auto& entry) {
            for (std::size_t slot = 0; slot < voices_.size(); ++slot) {
                const bool plays = Mix_Playing(static_cast<int>(slot)) && !voices_[slot].stream.is_over();
                if (plays && voices_[slot].chunk == entry.second.get()) return false;
            }
            return true;
        });
    }

    bool is_open_ = false;
    bool has_tried_ = false;
    std::map<std::uint32_t, Chunk> chunks_;  ///< by the key of their sound
    std::array<Voice, Audio::kMaxVoices> voices_;
    alignas(4) std::array<Uint8, std::size_t{4} * kBufferFrames> no_sound_{};
    Chunk silence_;
    SoundData music_data_;
    std::unique_ptr<Mix_Music, MusicDeleter> music_;
    std::set<std::string> complaints_;
};

}  // namespace

std::unique_ptr<AudioBackend> make_mixer_audio() {
    return std::make_unique<MixerBackend>();
}

}  // namespace cairn::engine
