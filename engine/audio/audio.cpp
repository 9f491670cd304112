// The bookkeeping of sounds, voices and music. Invariant: a voice plays from its start until its sound's
// length has passed on the clock of advance(), or until it is stopped; the back-end is told, never asked.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <cairn/engine/audio.h>
#include <cairn/engine/files.h>
#include <cairn/engine/log.h>

#include "assets/sound_check.h"
#include "assets/sound_header.h"
#include "audio/backend.h"
#include "base/handle_table.h"

namespace cairn::engine {
namespace {

/// A decoded minute takes 10 MB; longer pieces are music, which is decoded while it plays.
constexpr double kMaxSound_s = 60;
constexpr double kForever_s = std::numeric_limits<double>::infinity();

/// NaN counts as 0.
float unit(float value) {
    return value > 0 ? std::min(value, 1.0f) : 0.0f;
}

float sane_pitch(float pitch) {
    return std::isfinite(pitch) ? std::clamp(pitch, 0.25f, 4.0f) : 1.0f;
}

float sane_pan(float pan) {
    return std::isfinite(pan) ? std::clamp(pan, -1.0f, 1.0f) : 0.0f;
}

}  // namespace

struct Audio::State {
    struct Sound {
        SoundData data;
        double duration_s;
        SoundLimit limit;
        double last_start_s = -kForever_s;
    };
    struct Voice {
        std::uint32_t generation = 1;
        SoundId sound;
        double end_s = -kForever_s;
        double rest_s = 0;  ///< while its group is paused: what is left to play
        float volume = 1;
        float pitch = 1;
        AudioGroup group = AudioGroup::Sound;
    };
    struct Music {
        std::string path;
        double end_s = -kForever_s;
        double rest_s = 0;
        float volume = 1;
        float gain = 1;        ///< of the fade
        float gain_per_s = 0;  ///< below 0: it fades out, and stops at 0
    };
    struct Group {
        float volume = 1;
        bool is_paused = false;
    };

    State(const Files& files_to_read, std::unique_ptr<AudioBackend> chosen)
        : files(files_to_read), backend(std::move(chosen)) {}

    bool is_active(const Voice& voice) const { return voice.end_s > clock_s; }
    /// Not yet among `sounds`.
    Result<Sound> read_sound(std::string_view path);

    Group& group(AudioGroup id) { return groups[static_cast<std::size_t>(id)]; }
    const Group& group(AudioGroup id) const { return groups[static_cast<std::size_t>(id)]; }
    float heard_volume(const Voice& voice) const { return voice.volume * group(voice.group).volume; }
    float heard_music_volume() const { return music.volume * music.gain * group(AudioGroup::Music).volume; }

    /// Null for a voice that has ended.
    Voice* find(VoiceId id) {
        if (id.is_null() || id.index >= voices.size()) return nullptr;
        Voice& voice = voices[id.index];
        return voice.generation == id.generation && is_active(voice) ? &voice : nullptr;
    }

    bool allows(SoundId id, const Sound& sound) const {
        // A hair of tolerance: 0.05 s are three updates of 1/60 s, whatever the rounding of their sum.
        constexpr double kRounding_s = 1e-9;
        if (clock_s - sound.last_start_s < sound.limit.min_interval_s - kRounding_s) return false;
        const auto same = std::count_if(voices.begin(), voices.end(),
                                        [&](const Voice& v) { return v.sound == id && is_active(v); });
        return same < sound.limit.max_voices;
    }

    const Files& files;
    std::unique_ptr<AudioBackend> backend;
    HandleTable<SoundId, Sound> sounds;
    std::map<std::string, SoundId, std::less<>> sounds_by_path;
    std::array<Voice, kMaxVoices> voices;
    Music music;
    std::vector<Group> groups = {Group{}, Group{}};
    std::vector<std::string> group_names = {"sfx", "music"};
    std::uint32_t sounds_read = 0;
    double clock_s = 0;
    long plays = 0;
    long refused = 0;
    long music_plays = 0;
};

Audio::Audio(const Files& files, std::unique_ptr<AudioBackend> backend)
    : state_(std::make_unique<State>(files, std::move(backend))) {}

Audio::~Audio() = default;

// ---- Sounds

Result<Audio::State::Sound> Audio::State::read_sound(std::string_view path) {
    Result<std::vector<std::byte>> file = files.read_bytes(path);
    if (!file) return Error{"sound '" + std::string(path) + "' cannot be loaded: " + file.error().message};
    const Result<double> duration_s = read_sound_duration_s(*file, path);
    if (!duration_s) return duration_s.error();
    if (const auto whole = check_sound_bytes(*file, path); !whole) return whole.error();
    if (*duration_s > kMaxSound_s)
        return Error{"sound '" + std::string(path) + "': plays for " + std::to_string(*duration_s) +
                     " s; at most 60 s are allowed. Play longer pieces as music"};
    return Sound{
        .data = {++sounds_read, std::string(path), std::move(*file)}, .duration_s = *duration_s, .limit = {}};
}

Result<SoundId> Audio::load_sound(std::string_view path) {
    if (const auto known = state_->sounds_by_path.find(path); known != state_->sounds_by_path.end())
        return known->second;
    Result<State::Sound> sound = state_->read_sound(path);
    if (!sound) return sound.error();
    const SoundId id = state_->sounds.insert(*std::move(sound));
    state_->sounds_by_path.emplace(path, id);
    return id;
}

std::vector<std::string> Audio::loaded_sounds() const {
    std::vector<std::string> paths;
    for (const auto& [path, sound] : state_->sounds_by_path) paths.push_back(path);
    return paths;
}

Result<bool> Audio::reload_sound(std::string_view path) {
    State& s = *state_;
    const auto known = s.sounds_by_path.find(path);
    if (known == s.sounds_by_path.end()) return false;
    Result<State::Sound> sound = s.read_sound(path);
    if (!sound) return sound.error();
    for (std::size_t slot = 0; slot < s.voices.size(); ++slot) {
        if (s.voices[slot].sound != known->second || !s.is_active(s.voices[slot])) continue;
        s.voices[slot].end_s = -kForever_s;
        s.backend->stop_voice(static_cast<int>(slot));
    }
    State::Sound& old = *s.sounds.find(known->second);
    sound->limit = old.limit;
    old = *std::move(sound);
    return true;
}

void Audio::forget_files(std::string_view folder) {
    const std::string prefix = std::string(folder) + '/';
    std::erase_if(state_->sounds_by_path, [&](const auto& known) { return known.first.starts_with(prefix); });
}

bool Audio::is_valid(SoundId sound) const {
    return state_->sounds.find(sound) != nullptr;
}

double Audio::duration_s(SoundId sound) const {
    const State::Sound* found = state_->sounds.find(sound);
    return found ? found->duration_s : 0;
}

void Audio::set_limit(SoundId sound, const SoundLimit& limit) {
    if (State::Sound* found = state_->sounds.find(sound)) found->limit = limit;
}

// ---- Voices

VoiceId Audio::play(SoundId id, const SoundPlay& play) {
    State& s = *state_;
    State::Sound* sound = s.sounds.find(id);
    if (!sound) {
        log(LogLevel::Error, "play: the sound handle is null or stale; nothing is played");
        return {};
    }
    const auto slot =
        std::find_if(s.voices.begin(), s.voices.end(), [&](const auto& v) { return !s.is_active(v); });
    if (slot == s.voices.end() || !s.allows(id, *sound)) {
        ++s.refused;
        return {};
    }

    ++slot->generation;
    slot->sound = id;
    slot->pitch = sane_pitch(play.pitch);
    slot->end_s = play.loop ? kForever_s : s.clock_s + sound->duration_s / static_cast<double>(slot->pitch);
    slot->volume = unit(play.volume);
    slot->group = play.group;
    sound->last_start_s = s.clock_s;
    ++s.plays;

    const int index = static_cast<int>(slot - s.voices.begin());
    s.backend->start_voice(index, sound->data,
                           {.volume = s.heard_volume(*slot),
                            .pan = sane_pan(play.pan),
                            .pitch = slot->pitch,
                            .loop = play.loop});
    if (s.group(play.group).is_paused) {
        slot->rest_s = slot->end_s - s.clock_s;
        slot->end_s = kForever_s;
        s.backend->set_voice_paused(index, true);
    }
    return {static_cast<std::uint32_t>(index), slot->generation};
}

void Audio::stop(VoiceId id) {
    State::Voice* voice = state_->find(id);
    if (!voice) return;
    voice->end_s = -kForever_s;
    state_->backend->stop_voice(static_cast<int>(id.index));
}

void Audio::set_voice_volume(VoiceId id, float volume) {
    State::Voice* voice = state_->find(id);
    if (!voice) return;
    voice->volume = unit(volume);
    state_->backend->set_voice_volume(static_cast<int>(id.index), state_->heard_volume(*voice));
}

void Audio::set_voice_pan(VoiceId id, float pan) {
    if (state_->find(id)) state_->backend->set_voice_pan(static_cast<int>(id.index), sane_pan(pan));
}

void Audio::set_voice_pitch(VoiceId id, float pitch) {
    State::Voice* voice = state_->find(id);
    if (!voice) return;
    const float before = std::exchange(voice->pitch, sane_pitch(pitch));
    // What is left of it is as much sound as before.
    const double factor = static_cast<double>(before) / static_cast<double>(voice->pitch);
    if (state_->group(voice->group).is_paused) {
        voice->rest_s *= factor;
    } else {
        voice->end_s = state_->clock_s + (voice->end_s - state_->clock_s) * factor;
    }
    state_->backend->set_voice_pitch(static_cast<int>(id.index), voice->pitch);
}

bool Audio::is_playing(VoiceId voice) const {
    return state_->find(voice) != nullptr;
}

void Audio::stop_all_sounds() {
    for (std::uint32_t i = 0; i < kMaxVoices; ++i) stop({i, state_->voices[i].generation});
}

// ---- Music

Result<void> Audio::play_music(std::string_view path, float volume, bool loop, double fade_s) {
    State& s = *state_;
    Result<std::vector<std::byte>> file = s.files.read_bytes(path);
    if (!file) return Error{"music '" + std::string(path) + "' cannot be loaded: " + file.error().message};
    const Result<double> duration_s = read_sound_duration_s(*file, path);
    if (!duration_s) return duration_s.error();
    if (const auto whole = check_sound_bytes(*file, path); !whole) return whole.error();
    s.music = {.path = std::string(path),
               .end_s = loop ? kForever_s : s.clock_s + *duration_s,
               .volume = unit(volume)};
    if (fade_s > 0) {
        s.music.gain = 0;
        s.music.gain_per_s = static_cast<float>(1 / fade_s);
    }
    ++s.music_plays;
    s.backend->start_music({0, std::string(path), std::move(*file)}, s.heard_music_volume(), loop);
    if (s.group(AudioGroup::Music).is_paused) {
        s.music.rest_s = s.music.end_s - s.clock_s;
        s.music.end_s = kForever_s;
        s.backend->set_music_paused(true);
    }
    return {};
}

void Audio::stop_music(double fade_s) {
    if (state_->music.path.empty()) return;
    if (fade_s > 0) {
        state_->music.gain_per_s = static_cast<float>(-1 / fade_s);
        return;
    }
    state_->music = {};
    state_->backend->stop_music();
}

void Audio::set_music_volume(float volume) {
    state_->music.volume = unit(volume);
    state_->backend->set_music_volume(state_->heard_music_volume());
}

const std::string& Audio::music() const {
    return state_->music.path;
}

// ---- Mixing and time

Result<AudioGroup> Audio::add_group(std::string_view name) {
    constexpr std::size_t kMaxGroups = 16;
    std::vector<std::string>& names = state_->group_names;
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end())
        return Error{"group \"" + std::string(name) + "\": the name must be new and not empty"};
    if (names.size() >= kMaxGroups)
        return Error{"group \"" + std::string(name) + "\": there are " + std::to_string(kMaxGroups) +
                     " already"};
    names.emplace_back(name);
    state_->groups.emplace_back();
    return static_cast<AudioGroup>(names.size() - 1);
}

const std::vector<std::string>& Audio::groups() const {
    return state_->group_names;
}

void Audio::set_paused(AudioGroup id, bool paused) {
    State& s = *state_;
    if (std::exchange(s.group(id).is_paused, paused) == paused) return;
    // A paused voice has no end; what is left of it counts from when it goes on.
    const auto turn = [&](double& end_s, double& rest_s) {
        if (paused) rest_s = end_s - s.clock_s;
        end_s = paused ? kForever_s : s.clock_s + rest_s;
    };
    if (id == AudioGroup::Music) {
        if (s.music.path.empty()) return;
        turn(s.music.end_s, s.music.rest_s);
        s.backend->set_music_paused(paused);
        return;
    }
    for (std::size_t i = 0; i < s.voices.size(); ++i) {
        State::Voice& voice = s.voices[i];
        if (voice.group != id || !s.is_active(voice)) continue;
        turn(voice.end_s, voice.rest_s);
        s.backend->set_voice_paused(static_cast<int>(i), paused);
    }
}

bool Audio::is_paused(AudioGroup group) const {
    return state_->group(group).is_paused;
}

void Audio::set_group_volume(AudioGroup id, float volume) {
    State& s = *state_;
    s.group(id).volume = unit(volume);
    if (id == AudioGroup::Music) return s.backend->set_music_volume(s.heard_music_volume());
    for (std::size_t i = 0; i < s.voices.size(); ++i)
        if (s.voices[i].group == id && s.is_active(s.voices[i]))
            s.backend->set_voice_volume(static_cast<int>(i), s.heard_volume(s.voices[i]));
}

float Audio::group_volume(AudioGroup group) const {
    return state_->group(group).volume;
}

void Audio::advance(double elapsed_s) {
    if (!(elapsed_s > 0) || !std::isfinite(elapsed_s)) return;
    State& s = *state_;
    s.clock_s += elapsed_s;
    if (s.music.end_s <= s.clock_s) s.music = {};
    if (s.music.gain_per_s == 0 || s.group(AudioGroup::Music).is_paused) return;
    s.music.gain = std::clamp(s.music.gain + s.music.gain_per_s * static_cast<float>(elapsed_s), 0.0f, 1.0f);
    s.backend->set_music_volume(s.heard_music_volume());
    if (s.music.gain == 0) return stop_music();
    if (s.music.gain == 1) s.music.gain_per_s = 0;
}

AudioStats Audio::stats() const {
    const State& s = *state_;
    const auto active =
        std::count_if(s.voices.begin(), s.voices.end(), [&](const auto& v) { return s.is_active(v); });
    return {.plays = s.plays,
            .refused = s.refused,
            .active_voices = static_cast<int>(active),
            .music_plays = s.music_plays,
            .device_open = s.backend->is_device_open()};
}

}  // namespace cairn::engine
