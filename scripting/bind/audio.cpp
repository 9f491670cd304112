// cairn.audio.
#include "bind/context.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

constexpr Field kVolume = number_field("volume", 1, "1", "0 to 1");
constexpr Field kPan = number_field("pan", 0, "0", "-1 left to 1 right");
constexpr Field kPitch = number_field("pitch", 1, "1", "0.25 to 4");
constexpr Field kLoop = boolean_field("loop", false, "");
constexpr const Field* kPlayOwn[] = {&kVolume, &kPan, &kPitch, &kLoop};
constexpr FieldSet kPlayFields{kPlayOwn};
constexpr Field kMusicLoop = boolean_field("loop", true, "");
constexpr const Field* kMusicOwn[] = {&kVolume, &kMusicLoop};
constexpr FieldSet kMusicFields{kMusicOwn};

// A voice is one integer in Lua; 0 is none.
std::int64_t to_integer(engine::VoiceId voice) {
    return static_cast<std::int64_t>(voice.index | static_cast<std::uint64_t>(voice.generation) << 32);
}
engine::VoiceId to_voice(std::int64_t number) {
    const auto bits = static_cast<std::uint64_t>(number);
    return {.index = static_cast<std::uint32_t>(bits), .generation = static_cast<std::uint32_t>(bits >> 32)};
}

engine::AudioGroup to_group(lua_State* L, std::string_view name) {
    if (name == "sfx") return engine::AudioGroup::Sound;
    if (name == "music") return engine::AudioGroup::Music;
    argument_error(L, 1, "\"sfx\" or \"music\"");
}

std::int64_t play(lua_State* L, std::string_view path, std::optional<TableArgument> options) {
    if (!options) lua_newtable(L);
    const FieldReader reader(L, options ? options->index : -1, kPlayFields);
    engine::Audio& audio = context_of(L).services.audio;
    const engine::SoundId sound = value_or_raise(L, audio.load_sound(path));
    return to_integer(audio.play(sound, {.volume = reader.real(kVolume),
                                         .pan = reader.real(kPan),
                                         .pitch = reader.real(kPitch),
                                         .loop = reader.boolean(kLoop)}));
}
void stop(lua_State* L, std::int64_t voice) {
    context_of(L).services.audio.stop(to_voice(voice));
}
void stop_all(lua_State* L) {
    context_of(L).services.audio.stop_all_sounds();
}
bool is_playing(lua_State* L, std::int64_t voice) {
    return context_of(L).services.audio.is_playing(to_voice(voice));
}
void set_voice_volume(lua_State* L, std::int64_t voice, float volume) {
    context_of(L).services.audio.set_voice_volume(to_voice(voice), volume);
}

void set_rate_cap(lua_State* L, std::string_view path, double seconds, std::int64_t voices) {
    if (!(seconds >= 0)) argument_error(L, 2, "a time, at least 0");
    if (voices < 1 || voices > engine::Audio::kMaxVoices) {
        argument_error(L, 3, "an integer from 1 to " + std::to_string(engine::Audio::kMaxVoices));
    }
    engine::Audio& audio = context_of(L).services.audio;
    audio.set_limit(value_or_raise(L, audio.load_sound(path)),
                    {.min_interval_s = seconds, .max_voices = static_cast<int>(voices)});
}

engine::Result<void> play_music(lua_State* L, std::string_view path, std::optional<TableArgument> options) {
    if (!options) lua_newtable(L);
    const FieldReader reader(L, options ? options->index : -1, kMusicFields);
    return context_of(L).services.audio.play_music(path, reader.real(kVolume), reader.boolean(kMusicLoop));
}
void stop_music(lua_State* L) {
    context_of(L).services.audio.stop_music();
}

void set_volume(lua_State* L, std::string_view group, float volume) {
    context_of(L).services.audio.set_group_volume(to_group(L, group), volume);
}
float volume(lua_State* L, std::string_view group) {
    return context_of(L).services.audio.group_volume(to_group(L, group));
}

constexpr Function kFunctions[] = {
    function<&play>("play", "path, fields = {}", "voice",
                    "Starts a sound, an Ogg Vorbis or WAV file. The voice is an integer, 0 when the rate cap "
                    "swallowed the "
                    "sound.",
                    &kPlayFields),
    function<&stop>("stop", "voice", "", "Nothing happens when the voice has ended."),
    function<&stop_all>("stop_all", "", "", "All sounds; the music goes on."),
    function<&is_playing>("is_playing", "voice", "playing", ""),
    function<&set_voice_volume>("set_voice_volume", "voice, volume", "", ""),
    function<&set_rate_cap>(
        "set_rate_cap", "path, seconds [s], voices", "",
        "The same sound starts at most once per `seconds` and plays in at most `voices` voices; every "
        "sound begins with 0.03 and 8."),
    function<&play_music>("play_music", "path, fields = {}", "", "Replaces the music that plays.",
                          &kMusicFields),
    function<&stop_music>("stop_music", "", "", ""),
    function<&set_volume>("set_volume", "group, volume", "", "Group \"sfx\" or \"music\"; 0 to 1."),
    function<&volume>("volume", "group", "volume", ""),
};

}  // namespace

const Module kAudioModule = {"cairn.audio",
                             "Sounds and music. A missing file is an error; a machine without a sound device "
                             "plays silently, and so do headless runs.",
                             kFunctions};

}  // namespace cairn::scripting
