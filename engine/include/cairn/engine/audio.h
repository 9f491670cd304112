// Sounds and music: what plays, how loud, how often at most.
// Invariant: which voices play depends only on the calls made here and on the time given to advance(), never
// on the sound card, so that a game behaves the same headlessly, without a device, and in a replay.
//
// No device is opened before the first sound or music is played. Without a device a warning is logged once
// and all goes on silently.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/handle.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

class AudioBackend;
class Files;

/// Sounds and music that are made louder, quieter and silent together. Sound and Music are always there; a
/// game may add others (AudioGroup(2) and up).
enum class AudioGroup : int { Sound, Music };

struct SoundPlay {
    float volume = 1;   ///< 0 .. 1, clamped; multiplied by the group's volume
    float pan = 0;      ///< -1 left .. 1 right, clamped
    float pitch = 1;    ///< 0.25 .. 4, clamped; speed and pitch change together
    bool loop = false;  ///< plays until stopped
    AudioGroup group = AudioGroup::Sound;
};

/// Keeps a heap of crates from sounding like a machine gun.
struct SoundLimit {
    double min_interval_s = 0.03;  ///< the same sound starts again no sooner than this
    int max_voices = 8;            ///< of the same sound at a time
};

struct AudioStats {
    long plays = 0;         ///< voices started
    long refused = 0;       ///< plays that a limit swallowed
    int active_voices = 0;  ///< playing now
    long music_plays = 0;
    bool device_open = false;
};

/// Whether a sound or a piece of music is whole, from the first byte to the last; Audio looks no farther than
/// the header before it plays one. The error names the path and the reason.
Result<void> check_sound(const Files& files, std::string_view path);

class Audio {
  public:
    /// Of all sounds together.
    static constexpr int kMaxVoices = 32;

    /// Platform::create_audio makes them.
    Audio(const Files& files, std::unique_ptr<AudioBackend> backend);
    ~Audio();
    Audio(const Audio&) = delete;
    Audio& operator=(const Audio&) = delete;

    /// Ogg Vorbis or WAV (PCM). The file's header is checked now, its samples are decoded by the first play.
    /// The same path gives the same handle. The error names the path and the reason.
    Result<SoundId> load_sound(std::string_view path);
    /// Reads a sound anew; its handle plays what the file holds now. Voices of it end. False when no sound is
    /// of that file. With an error the old one stays.
    Result<bool> reload_sound(std::string_view path);
    /// Sounds of files below a folder are read anew when they are loaded the next time. The handles that
    /// there are play what they did.
    void forget_files(std::string_view folder);
    bool is_valid(SoundId sound) const;
    double duration_s(SoundId sound) const;
    void set_limit(SoundId sound, const SoundLimit& limit);

    /// The null handle when a limit refuses it. A null or stale sound plays nothing and logs an error.
    VoiceId play(SoundId sound, const SoundPlay& play = {});
    /// Of a voice that has ended: nothing.
    void stop(VoiceId voice);
    void set_voice_volume(VoiceId voice, float volume);
    void set_voice_pan(VoiceId voice, float pan);
    /// What is left of it plays faster or slower from now on: 0.25 .. 4, clamped.
    void set_voice_pitch(VoiceId voice, float pitch);
    bool is_playing(VoiceId voice) const;
    void stop_all_sounds();

    /// Replaces the music that plays, if any. It swells from silence within `fade_s`.
    Result<void> play_music(std::string_view path, float volume = 1, bool loop = true, double fade_s = 0);
    /// Fades it out within `fade_s`.
    void stop_music(double fade_s = 0);
    void set_music_volume(float volume);
    /// The path of the music that plays; empty: none.
    const std::string& music() const;

    /// At most 16 in all. The error names the rule.
    Result<AudioGroup> add_group(std::string_view name);
    /// "sfx", "music" and those added, in order.
    const std::vector<std::string>& groups() const;
    /// What plays in a paused group stands still, and so does what is started in it, until it is resumed.
    void set_paused(AudioGroup group, bool paused);
    bool is_paused(AudioGroup group) const;
    /// 0 .. 1, clamped; for a settings page.
    void set_group_volume(AudioGroup group, float volume);
    float group_volume(AudioGroup group) const;

    /// Lets time pass: call it once per update with the step. Voices end and limits run by this clock.
    void advance(double elapsed_s);

    AudioStats stats() const;
    /// Their paths, sorted.
    std::vector<std::string> loaded_sounds() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace cairn::engine
