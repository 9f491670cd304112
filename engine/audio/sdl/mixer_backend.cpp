// The back-end on SDL2_mixer. Invariant: voice slot i plays on mixer channel i; the samples of a sound and
// the bytes of the music live until no channel plays them. The mixer cannot change the speed of a channel, so
// each channel plays silence for ever, into which its stream writes what is heard.
//
// SDL goes on writing to a device that was pulled out, and nobody hears it any more. So the next sound after
// that opens whichever device there is now; without one, the next sound after one has come.
#include "audio/sdl/mixer_backend.h"

#include <SDL.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <cairn/engine/log.h>

#include "audio/sdl/alsa_messages.h"
#include "audio/sdl/mixer_library.h"
#include "audio/sdl/voice_stream.h"

namespace cairn::engine {
namespace {

constexpr int kRate_hz = 44100;
/// 23 ms of delay: less crackles on slow machines, more is heard as late.
constexpr int kBufferFrames = 1024;
/// Decoded; a second takes 176 kB.
constexpr std::size_t kMaxChunks = 128;

struct ChunkDeleter {
    void operator()(Mix_Chunk* chunk) const { mixer().FreeChunk(chunk); }
};
struct MusicDeleter {
    void operator()(Mix_Music* music) const { mixer().FreeMusic(music); }
};

int to_mixer_volume(float volume) {
    return static_cast<int>(std::lround(volume * MIX_MAX_VOLUME));
}

class MixerBackend final : public AudioBackend {
  public:
    ~MixerBackend() override {
        if (!has_audio_) return;
        SDL_DelEventWatch(notice_devices, this);
        close_device();
        chunks_.clear();
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
    }

    void start_voice(int slot, const SoundData& sound, const VoiceSettings& settings) override {
        if (!open_device()) return;
        mixer().HaltChannel(slot);
        const Mix_Chunk* chunk = find_chunk(sound);
        if (!chunk) return;
        Voice& voice = voices_[static_cast<std::size_t>(slot)];
        voice.chunk = chunk;
        voice.stream.start({reinterpret_cast<const std::int16_t*>(chunk->abuf), chunk->alen / 2},
                           settings.pitch, settings.loop);
        mixer().Volume(slot, to_mixer_volume(settings.volume));
        if (mixer().PlayChannel(slot, silence_.get(), -1) < 0) return warn_once(sound.path, Mix_GetError());
        // In this order: what the stream writes is panned. It waits, or the mixer's thread, coming between
        // the two, would play the first buffer on both sides.
        mixer().Pause(slot);
        mixer().RegisterEffect(slot, fill, nullptr, &voice.stream);
        pan(slot, settings.pan);
        mixer().Resume(slot);
    }

    void stop_voice(int slot) override {
        if (is_open_) mixer().HaltChannel(slot);
    }

    void set_voice_pitch(int slot, float pitch) override {
        voices_[static_cast<std::size_t>(slot)].stream.set_pitch(pitch);
    }

    void set_voice_volume(int slot, float volume) override {
        if (is_open_) mixer().Volume(slot, to_mixer_volume(volume));
    }

    void set_voice_pan(int slot, float where) override {
        if (is_open_) pan(slot, where);
    }

    void set_voice_paused(int slot, bool paused) override {
        if (!is_open_) return;
        if (paused)
            mixer().Pause(slot);
        else
            mixer().Resume(slot);
    }

    void set_music_paused(bool paused) override {
        if (!is_open_) return;
        if (paused)
            mixer().PauseMusic();
        else
            mixer().ResumeMusic();
    }

    void start_music(SoundData music, float volume, bool loop) override {
        if (!open_device()) return;
        stop_music();
        music_data_ = std::move(music);
        music_volume_ = volume;
        music_loops_ = loop;
        play_music();
    }

    void stop_music() override {
        if (!is_open_) return;
        mixer().HaltMusic();
        music_.reset();
    }

    void set_music_volume(float volume) override {
        music_volume_ = volume;
        if (is_open_) mixer().VolumeMusic(to_mixer_volume(volume));
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
        mixer().SetPanning(slot, static_cast<Uint8>(255 * std::min(1.0f, 1 - where)),
                           static_cast<Uint8>(255 * std::min(1.0f, 1 + where)));
    }

    /// From the first byte of music_data_.
    void play_music() {
        SDL_RWops* stream =
            SDL_RWFromConstMem(music_data_.file.data(), static_cast<int>(music_data_.file.size()));
        music_.reset(stream ? mixer().LoadMUS_RW(stream, /*freesrc=*/1) : nullptr);
        mixer().VolumeMusic(to_mixer_volume(music_volume_));
        if (!music_ || mixer().PlayMusic(music_.get(), music_loops_ ? -1 : 0) != 0)
            warn_once(music_data_.path, Mix_GetError());
    }

    /// Called for each event, maybe by SDL's own threads.
    static int notice_devices(void* self, SDL_Event* event) {
        const bool is_about_devices =
            event->type == SDL_AUDIODEVICEREMOVED || event->type == SDL_AUDIODEVICEADDED;
        if (!is_about_devices || event->adevice.iscapture != 0) return 0;
        auto& backend = *static_cast<MixerBackend*>(self);
        (event->type == SDL_AUDIODEVICEREMOVED ? backend.lost_one_ : backend.found_one_) = true;
        return 0;
    }

    /// Before a sound: what became of the device since the last one.
    void follow_devices() {
        const bool found = found_one_.exchange(false);
        const bool lost = lost_one_.exchange(false);
        if (is_open_ && lost) {
            const bool has_music = music_ != nullptr && mixer().PlayingMusic() != 0;
            close_device();
            has_tried_ = false;
            if (open_device() && has_music) play_music();
        } else if (!is_open_ && found) {
            has_tried_ = false;
        }
    }

    void close_device() {
        if (!is_open_) return;
        is_open_ = false;
        mixer().HaltChannel(-1);
        silence_.reset();
        music_.reset();
        mixer().CloseAudio();
    }

    bool open_device() {
        follow_devices();
        if (is_open_ || std::exchange(has_tried_, true)) return is_open_;
        if (const auto loaded = load_mixer(); !loaded) {
            log(LogLevel::Warning, "no sound: " + loaded.error().message);
            return false;
        }
        silence_alsa();
        if (!has_audio_ && SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) {
            log(LogLevel::Warning, std::string("no sound: ") + SDL_GetError());
            return false;
        }
        if (!std::exchange(has_audio_, true)) SDL_AddEventWatch(notice_devices, this);
        // The mixer may not change the format: streams rely on 16-bit stereo.
        if (mixer().OpenAudioDevice(kRate_hz, AUDIO_S16SYS, 2, kBufferFrames, nullptr, 0) != 0) {
            log(LogLevel::Warning, std::string("no sound: ") + Mix_GetError());
            return false;
        }
        is_open_ = true;
        mixer().AllocateChannels(Audio::kMaxVoices);
        silence_.reset(mixer().QuickLoad_RAW(no_sound_.data(), static_cast<Uint32>(no_sound_.size())));
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
        Chunk chunk(stream ? mixer().LoadWAV_RW(stream, /*freesrc=*/1) : nullptr);
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
                const bool plays = mixer().Playing(static_cast<int>(slot)) && !voices_[slot].stream.is_over();
                if (plays && voices_[slot].chunk == entry.second.get()) return false;
            }
            return true;
        });
    }

    bool has_audio_ = false;  ///< SDL's audio, whose devices are watched
    bool is_open_ = false;
    bool has_tried_ = false;
    std::atomic<bool> lost_one_ = false;     ///< an output was pulled out
    std::atomic<bool> found_one_ = false;    ///< one came
    std::map<std::uint32_t, Chunk> chunks_;  ///< by the key of their sound
    std::array<Voice, Audio::kMaxVoices> voices_;
    alignas(4) std::array<Uint8, std::size_t{4} * kBufferFrames> no_sound_{};
    Chunk silence_;
    SoundData music_data_;
    float music_volume_ = 1;
    bool music_loops_ = false;
    std::unique_ptr<Mix_Music, MusicDeleter> music_;
    std::set<std::string> complaints_;
};

}  // namespace

std::unique_ptr<AudioBackend> make_mixer_audio() {
    return std::make_unique<MixerBackend>();
}

}  // namespace cairn::engine
