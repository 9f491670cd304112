// SDL2_mixer on SDL's dummy device, and the streams of voices against a formula.
#include <SDL.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <string>

#include <cairn/engine/log.h>

#include "audio/backend.h"
#include "audio/sdl/mixer_backend.h"
#include "audio/sdl/mixer_library.h"
#include "audio/sdl/voice_stream.h"
#include "engine/support/drawing.h"
#include "engine/support/sounds.h"
#include "engine/support/standard_error.h"

using namespace cairn::engine;

namespace {

/// Sets SDL's audio driver for one test.
class AudioDriver {
  public:
    explicit AudioDriver(const char* name) { setenv("SDL_AUDIODRIVER", name, 1); }
    ~AudioDriver() { unsetenv("SDL_AUDIODRIVER"); }
};

/// As the system tells of this process.
bool is_mixer_in_memory() {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);)
        if (line.find("libSDL2_mixer") != std::string::npos) return true;
    return false;
}

/// The first frames that a voice plays, in two buffers.
std::vector<std::int16_t> heard(const std::vector<std::int16_t>& samples, float pitch, bool loop,
                                std::size_t frames) {
    VoiceStream stream;
    stream.start(samples, pitch, loop);
    std::vector<std::int16_t> out(2 * frames, 77);
    const std::size_t half = 2 * (frames / 2);
    stream.fill(std::span(out).first(half));
    stream.fill(std::span(out).subspan(half));
    return out;
}

/// A game with one sound, "tone.wav", on one of SDL's audio drivers.
struct SoundGame {
    explicit SoundGame(const char* driver) : chosen(driver) {
        drawing.folder.put("tone.wav", tone_wav(0.5));
        const auto loaded = audio.load_sound("tone.wav");
        REQUIRE(loaded);
        tone = *loaded;
        audio.set_limit(tone, {.min_interval_s = 0, .max_voices = 8});
    }

    AudioDriver chosen;
    Drawing drawing{{8, 8}, false};
    Audio audio{*drawing.files, make_mixer_audio()};
    SoundId tone;
};

}  // namespace

TEST_CASE("a voice at twice the pitch reads every second frame, at half of it one in between") {
    const std::vector<std::int16_t> ramp = {0, 100, 10, 110, 20, 120, 30, 130};
    CHECK(heard(ramp, 1, false, 6) ==
          std::vector<std::int16_t>{0, 100, 10, 110, 20, 120, 30, 130, 0, 0, 0, 0});
    CHECK(heard(ramp, 2, false, 3) == std::vector<std::int16_t>{0, 100, 20, 120, 0, 0});
    CHECK(heard(ramp, 0.5f, false, 9) == std::vector<std::int16_t>{0, 100, 5, 105, 10, 110, 15, 115, 20, 120,
                                                                   25, 125, 30, 130, 30, 130, 0, 0});
    CHECK(heard({}, 2, true, 1) == std::vector<std::int16_t>{0, 0});
}

TEST_CASE("a voice that loops goes on at its beginning, without a gap between") {
    const std::vector<std::int16_t> ramp = {0, 100, 10, 110, 20, 120};
    CHECK(heard(ramp, 2, true, 4) == std::vector<std::int16_t>{0, 100, 20, 120, 10, 110, 0, 100});
    CHECK(heard(ramp, 2.5f, true, 3) == std::vector<std::int16_t>{0, 100, 10, 110, 20, 120});
}

TEST_CASE("a voice changes its pitch where it is") {
    std::vector<std::int16_t> ramp(200);
    for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<std::int16_t>(i / 2);
    VoiceStream stream;
    stream.start(ramp, 1, false);
    std::vector<std::int16_t> out(20);
    stream.fill(out);
    CHECK(out.back() == 9);
    stream.set_pitch(4);
    stream.fill(out);
    CHECK(out.front() == 10);
    CHECK(out.back() == 10 + 4 * 9);
    CHECK_FALSE(stream.is_over());
}

TEST_CASE("the audio device is opened and the mixer taken in by the first sound that plays, not before") {
    const bool was_loaded = is_mixer_in_memory();  // by another test of this process
    SoundGame game("dummy");
    Audio& audio = game.audio;
    audio.set_group_volume(AudioGroup::Sound, 0.5f);
    audio.stop_all_sounds();
    audio.stop_music();
    audio.set_music_volume(0.5f);
    CHECK_FALSE(audio.stats().device_open);
    CHECK(is_mixer_in_memory() == was_loaded);
    CHECK_FALSE(audio.play(game.tone, {.volume = 0.5f, .pan = -1, .pitch = 1.5f}).is_null());
    CHECK(audio.stats().device_open);
    CHECK(is_mixer_in_memory());
    CHECK(audio.play_music("tone.wav"));
}

TEST_CASE("without an audio device a game goes on silently after one warning") {
    SoundGame game("no-such-driver");
    Audio& audio = game.audio;
    int warnings = 0;
    const LogSink before = set_log_sink([&](LogLevel, std::string_view) { ++warnings; });
    const VoiceId voice = audio.play(game.tone);
    (void)audio.play(game.tone);
    const bool music_plays = static_cast<bool>(audio.play_music("tone.wav"));
    set_log_sink(before);
    CHECK(warnings == 1);
    CHECK(music_plays);
    CHECK(audio.is_playing(voice));
    CHECK(audio.stats().plays == 2);
    CHECK_FALSE(audio.stats().device_open);
}

TEST_CASE(
    "after the audio device was pulled out, the next sound plays on the one that there is, and music goes "
    "on") {
    SoundGame game("dummy");
    Audio& audio = game.audio;
    const auto tell = [](SDL_EventType type) {
        SDL_Event event;
        SDL_zero(event);
        event.type = type;
        SDL_PushEvent(&event);
        SDL_FlushEvent(type);
    };
    CHECK_FALSE(audio.play(game.tone, {.loop = true}).is_null());
    CHECK(audio.play_music("tone.wav"));
    REQUIRE(mixer().PlayingMusic() != 0);
    tell(SDL_AUDIODEVICEREMOVED);
    CHECK_FALSE(audio.play(game.tone).is_null());
    CHECK(audio.stats().device_open);
    CHECK(mixer().PlayingMusic() != 0);
    CHECK(mixer().Playing(-1) == 1);  // the looping one ended with its device

    int warnings = 0;
    const LogSink before = set_log_sink([&](LogLevel, std::string_view) { ++warnings; });
    tell(SDL_AUDIODEVICEREMOVED);
    SDL_AudioQuit();  // so that none can be opened
    for (int i = 0; i < 3; ++i) (void)audio.play(game.tone);
    CHECK(warnings == 1);
    CHECK_FALSE(audio.stats().device_open);
    SDL_AudioInit(nullptr);
    tell(SDL_AUDIODEVICEADDED);
    (void)audio.play(game.tone);
    set_log_sink(before);
    CHECK(audio.stats().device_open);
}

TEST_CASE("a sound whose samples are damaged is warned about once and stays silent") {
    const AudioDriver dummy("dummy");
    Drawing game({8, 8}, false);
    game.folder.put("odd.ogg", vorbis());
    Audio audio(*game.files, make_mixer_audio());
    const auto odd = audio.load_sound("odd.ogg");
    REQUIRE(odd);
    audio.set_limit(*odd, {.min_interval_s = 0, .max_voices = 8});
    std::string warnings;
    const LogSink before =
        set_log_sink([&](LogLevel, std::string_view text) { warnings.append(text) += '\n'; });
    (void)audio.play(*odd);
    (void)audio.play(*odd);
    set_log_sink(before);
    CHECK_THAT(warnings, Catch::Contains("'odd.ogg'"));
    CHECK(std::count(warnings.begin(), warnings.end(), '\n') == 1);
}

TEST_CASE("what the check of sounds refuses, the mixer does not decode, and the rest it does") {
    const AudioDriver dummy("dummy");
    Drawing game({8, 8}, false);
    Audio audio(*game.files, make_mixer_audio());
    const std::string wav = tone_wav(0.02);
    int number = 0;
    const auto agree = [&](std::size_t at, std::uint64_t value) {
        CAPTURE(at, value);
        const std::string name = "sound" + std::to_string(++number) + ".wav";
        game.folder.put(name, with_format(wav, at, value));
        const bool is_fine = static_cast<bool>(check_sound(*game.files, name));
        const auto sound = audio.load_sound(name);
        if (!sound) {  // refused for its header, before the mixer gets it
            CHECK_FALSE(is_fine);
            return;
        }
        std::string warnings;
        const LogSink before = set_log_sink([&](LogLevel, std::string_view text) { warnings.append(text); });
        (void)audio.play(*sound);
        set_log_sink(before);
        audio.stop_all_sounds();  // or there would soon be no voice left
        CHECK(is_fine == warnings.empty());
    };
    for (std::uint64_t encoding = 0; encoding < 20; ++encoding) agree(20, encoding);
    for (const std::uint64_t channels : {0, 1, 2, 3, 8, 9, 255, 256}) agree(22, channels);
    for (const std::uint64_t rate : {0, 1, 8000, 44100, 65535}) agree(24, rate);
    for (const std::uint64_t high : {1, 63, 64, 1000, 65535}) agree(26, high);
    for (std::uint64_t bits = 0; bits < 66; ++bits) agree(34, bits);
    for (std::uint64_t frame = 0; frame < 5; ++frame) agree(32, frame);
}

TEST_CASE("music of a format that the mixer would divide by is refused before it gets it") {
    const AudioDriver dummy("dummy");
    Drawing game({8, 8}, false);
    Audio audio(*game.files, make_mixer_audio());
    for (const std::uint64_t channels : {0, 256}) {
        game.folder.put("odd.wav", with_format(tone_wav(0.1), 22, channels));
        const auto played = audio.play_music("odd.wav");
        REQUIRE_FALSE(played);
        CHECK_THAT(played.error().message, Catch::Contains("channels, but must have from 1 to 8"));
    }
}

TEST_CASE("where ALSA finds no sound device, the only words about it are ours") {
    std::string told;
    const LogSink before = set_log_sink([&](LogLevel, std::string_view text) { told += text; });
    setenv("ALSA_CONFIG_PATH", "/nonexistent", 1);
    const std::string written = written_to_standard_error([] {
        SoundGame game("alsa");
        game.audio.play(game.tone);
    });
    unsetenv("ALSA_CONFIG_PATH");
    set_log_sink(before);
    CHECK(written == "");
    CHECK_THAT(told, Catch::StartsWith("no sound: "));
}
