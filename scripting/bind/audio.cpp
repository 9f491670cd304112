// cairn.audio.
#include <algorithm>

#include "bind/context.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "data/nearest.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

constexpr Field kVolume = at_least(number_field("volume", 1, "1", "more than 1 is as 1"), 0);
constexpr Field kPan = number_field("pan", 0, "0", "-1 left to 1 right, and beyond as there");
constexpr Field kPitch = above(number_field("pitch", 1, "1", "0.25 to 4, and beyond as there"), 0);
constexpr Field kLoop = boolean_field("loop", false, "");
constexpr Field kGroup{"group", FieldType::String, "sfx", "\"sfx\", or one made with new_group"};
constexpr const Field* kPlayOwn[] = {&kVolume, &kPan, &kPitch, &kLoop, &kGroup};
constexpr FieldSet kPlayFields{kPlayOwn};
constexpr Field kMusicLoop = boolean_field("loop", true, "");
constexpr Range kFadeTimes{0, 3600};
constexpr Field kFade = within(number_field("fade", 0, "0", "s in which it swells from silence"), kFadeTimes);
constexpr Field kMusicVolume = within(number_field("volume", 1, "1", ""), kShare);
constexpr const Field* kMusicOwn[] = {&kMusicVolume, &kMusicLoop, &kFade};
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
    const std::vector<std::string>& groups = context_of(L).services.audio.groups();
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (groups[i] == name) return static_cast<engine::AudioGroup>(i);
    call_error(L, "group is " + quote_text(name) + ": no such group" + suggestion(name, groups));
}

std::int64_t play(lua_State* L, std::string_view path, std::optional<TableArgument> options) {
    if (!options) lua_newtable(L);
    const FieldReader reader(L, options ? options->index : -1, kPlayFields);
    engine::Audio& audio = context_of(L).services.audio;
    const engine::SoundId sound = value_or_raise(L, audio.load_sound(path));
    const engine::AudioGroup group = to_group(L, reader.text(kGroup));
    if (group == engine::AudioGroup::Music) reader.fail(kGroup, "must not be the music's");
    return to_integer(audio.play(sound, {.volume = reader.real(kVolume),
                                         .pan = reader.real(kPan),
                                         .pitch = reader.real(kPitch),
                                         .loop = reader.boolean(kLoop),
                                         .group = group}));
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
void set_voice_volume(lua_State* L, std::int64_t voice, NotNegative volume) {
    context_of(L).services.audio.set_voice_volume(to_voice(voice), volume);
}

void set_voice_pan(lua_State* L, std::int64_t voice, float pan) {
    context_of(L).services.audio.set_voice_pan(to_voice(voice), pan);
}
void set_voice_pitch(lua_State* L, std::int64_t voice, Positive pitch) {
    context_of(L).services.audio.set_voice_pitch(to_voice(voice), pitch);
}
double duration(lua_State* L, std::string_view path) {
    engine::Audio& audio = context_of(L).services.audio;
    return audio.duration_s(value_or_raise(L, audio.load_sound(path)));
}

constexpr Range kVoices{1, engine::Audio::kMaxVoices};

void set_rate_cap(lua_State* L, std::string_view path, Seconds seconds,
                  Ranged<kVoices, std::int64_t> voices) {
    engine::Audio& audio = context_of(L).services.audio;
    audio.set_limit(value_or_raise(L, audio.load_sound(path)),
                    {.min_interval_s = seconds, .max_voices = static_cast<int>(voices.value)});
}

engine::Result<void> play_music(lua_State* L, std::string_view path, std::optional<TableArgument> options) {
    if (!options) lua_newtable(L);
    const FieldReader reader(L, options ? options->index : -1, kMusicFields);
    return context_of(L).services.audio.play_music(path, reader.real(kMusicVolume),
                                                   reader.boolean(kMusicLoop), reader.number(kFade));
}
void stop_music(lua_State* L, std::optional<Ranged<kFadeTimes, double>> fade) {
    context_of(L).services.audio.stop_music(fade.value_or(0));
}
void set_music_volume(lua_State* L, Share volume) {
    context_of(L).services.audio.set_music_volume(volume);
}
Pushed music(lua_State* L) {
    const std::string& path = context_of(L).services.audio.music();
    if (path.empty())
        lua_pushnil(L);
    else
        lua_pushlstring(L, path.data(), path.size());
    return {1};
}

void new_group(lua_State* L, std::string_view name) {
    engine::Audio& audio = context_of(L).services.audio;
    // After a reload the script makes its groups again.
    const std::vector<std::string>& groups = audio.groups();
    const auto known = std::find(groups.begin() + 2, groups.end(), name);
    if (known == groups.end()) value_or_raise(L, audio.add_group(name));
}
void pause(lua_State* L, std::string_view group) {
    context_of(L).services.audio.set_paused(to_group(L, group), true);
}
void resume(lua_State* L, std::string_view group) {
    context_of(L).services.audio.set_paused(to_group(L, group), false);
}
bool is_paused(lua_State* L, std::string_view group) {
    return context_of(L).services.audio.is_paused(to_group(L, group));
}

void set_volume(lua_State* L, std::string_view group, Share volume) {
    context_of(L).services.audio.set_group_volume(to_group(L, group), volume);
}
float volume(lua_State* L, std::string_view group) {
    return context_of(L).services.audio.group_volume(to_group(L, group));
}

constexpr std::array<std::string_view, 1> kReturnsPath = {"string?"};

constexpr Function kFunctions[] = {
    function<&play>("play", "path, fields = {}", "voice",
                    "Starts a sound, an Ogg Vorbis or WAV file. The voice is an integer, 0 when the rate cap "
                    "swallowed the "
                    "sound.",
                    &kPlayFields),
    function<&stop>("stop", "voice", "", "Nothing happens when the voice has ended."),
    function<&stop_all>("stop_all", "", "", "All sounds; the music goes on."),
    function<&is_playing>("is_playing", "voice", "playing", ""),
    function<&set_voice_volume>("set_voice_volume", "voice, volume", "", "More than 1 is as 1."),
    function<&set_voice_pan>("set_voice_pan", "voice, pan", "", "-1 left to 1 right, and beyond as there."),
    function<&set_voice_pitch>(
        "set_voice_pitch", "voice, pitch", "",
        "0.25 to 4, and beyond as there: speed and pitch from now on, as of an engine that "
        "turns faster."),
    function<&duration>("duration", "path", "seconds [s]",
                        "Loads a sound and says how long it plays at pitch 1."),
    function<&set_rate_cap>(
        "set_rate_cap", "path, seconds [s], voices", "",
        "The same sound starts at most once per `seconds` and plays in at most `voices` voices; every "
        "sound begins with 0.03 and 8."),
    function<&play_music>("play_music", "path, fields = {}", "", "Replaces the music that plays.",
                          &kMusicFields),
    function<&stop_music>("stop_music", "fade [s] = 0", "", "Within that time it falls silent."),
    function<&set_music_volume>("set_music_volume", "volume", "", "Of the music that plays."),
    function_pushing<&music>("music", "", "path", kReturnsPath, "The file of the music that plays, or nil."),
    function<&new_group>(
        "new_group", "name", "",
        "Makes a group of sounds beside \"sfx\" and \"music\", for a volume and a pause of its own: "
        "\"ui\", \"speech\"."),
    function<&set_volume>("set_volume", "group, volume", "", ""),
    function<&pause>(
        "pause", "group", "",
        "What plays in the group stands still, and so does what is started in it, until it is resumed."),
    function<&resume>("resume", "group", "", ""),
    function<&is_paused>("is_paused", "group", "paused", ""),
    function<&volume>("volume", "group", "volume", ""),
};

}  // namespace

const Module kAudioModule = {"cairn.audio",
                             "Sounds and music. A missing file is an error; a machine without a sound device "
                             "plays silently, and so do headless runs.",
                             kFunctions};

}  // namespace cairn::scripting
