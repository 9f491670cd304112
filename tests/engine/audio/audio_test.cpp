// The bookkeeping of sounds, on the silent back-end and on the clock of advance().
#include <catch2/catch.hpp>

#include <cairn/engine/audio.h>
#include <cairn/engine/log.h>

#include "engine/support/drawing.h"
#include "engine/support/sounds.h"

using namespace cairn::engine;

namespace {

/// A headless platform's audio with a sound of half a second and no limits.
struct Sounds : Drawing {
    Sounds() : Drawing({8, 8}, false), audio(platform->create_audio(*files)) {
        folder.put("tone.wav", tone_wav(0.5));
        auto loaded = audio->load_sound("tone.wav");
        REQUIRE(loaded);
        tone = *loaded;
        audio->set_limit(tone, {.min_interval_s = 0, .max_voices = 100});
    }

    std::unique_ptr<Audio> audio;
    SoundId tone;
};

}  // namespace

TEST_CASE_METHOD(Sounds, "a voice plays for the length of its sound") {
    CHECK(audio->duration_s(tone) == Approx(0.5));
    const VoiceId voice = audio->play(tone);
    CHECK(audio->is_playing(voice));
    audio->advance(0.49);
    CHECK(audio->is_playing(voice));
    audio->advance(0.02);
    CHECK_FALSE(audio->is_playing(voice));
    CHECK(audio->stats().plays == 1);
    CHECK(audio->stats().active_voices == 0);
    CHECK_FALSE(audio->stats().device_open);
}

TEST_CASE_METHOD(Sounds, "a sound that is read anew has its handle and limits, and its voices end") {
    const VoiceId voice = audio->play(tone);
    folder.put("tone.wav", tone_wav(0.25));
    REQUIRE(audio->reload_sound("tone.wav"));
    CHECK(audio->duration_s(tone) == Approx(0.25));
    CHECK_FALSE(audio->is_playing(voice));
    CHECK(audio->is_playing(audio->play(tone)));
    folder.put("tone.wav", "torn");
    CHECK_FALSE(audio->reload_sound("tone.wav"));
    CHECK(audio->duration_s(tone) == Approx(0.25));
    CHECK_FALSE(*audio->reload_sound("other.wav"));
}

TEST_CASE_METHOD(Sounds,
                 "a sound whose folder is forgotten is read anew, and its old handle plays as before") {
    folder.put("mine/tone.wav", tone_wav(0.5));
    const SoundId before = *audio->load_sound("mine/tone.wav");
    folder.put("mine/tone.wav", tone_wav(0.25));
    CHECK(*audio->load_sound("mine/tone.wav") == before);
    audio->forget_files("mine");
    CHECK(audio->duration_s(*audio->load_sound("mine/tone.wav")) == Approx(0.25));
    CHECK(audio->duration_s(before) == Approx(0.5));
    CHECK(*audio->load_sound("tone.wav") == tone);
}

TEST_CASE_METHOD(Sounds, "a higher pitch ends sooner, a loop not at all") {
    const VoiceId high = audio->play(tone, {.pitch = 2});
    const VoiceId low = audio->play(tone, {.pitch = 0.5f});
    const VoiceId loop = audio->play(tone, {.loop = true});
    audio->advance(0.26);
    CHECK_FALSE(audio->is_playing(high));
    CHECK(audio->is_playing(low));
    audio->advance(0.75);
    CHECK_FALSE(audio->is_playing(low));
    CHECK(audio->is_playing(loop));
    audio->stop(loop);
    CHECK_FALSE(audio->is_playing(loop));
}

TEST_CASE_METHOD(Sounds,
                 "what is left of a voice ends sooner when its pitch rises, also while it is paused") {
    const VoiceId voice = audio->play(tone);  // half a second
    audio->advance(0.2);
    audio->set_voice_pitch(voice, 3);
    audio->advance(0.09);
    CHECK(audio->is_playing(voice));
    audio->advance(0.02);
    CHECK_FALSE(audio->is_playing(voice));

    const VoiceId paused = audio->play(tone);
    audio->advance(0.1);
    audio->set_paused(AudioGroup::Sound, true);
    audio->set_voice_pitch(paused, 0.5f);  // 0.4 s of sound take 0.8 s
    audio->advance(9);
    audio->set_paused(AudioGroup::Sound, false);
    audio->advance(0.79);
    CHECK(audio->is_playing(paused));
    audio->advance(0.02);
    CHECK_FALSE(audio->is_playing(paused));

    const VoiceId loop = audio->play(tone, {.loop = true});
    audio->set_voice_pitch(loop, 4);
    audio->set_voice_pitch(VoiceId{}, 2);
    audio->advance(100);
    CHECK(audio->is_playing(loop));
}

TEST_CASE_METHOD(Sounds, "a voice's handle does not name the voice that took its place") {
    const VoiceId first = audio->play(tone);
    audio->stop(first);
    const VoiceId second = audio->play(tone);
    CHECK(second.index == first.index);
    CHECK_FALSE(audio->is_playing(first));
    audio->stop(first);
    CHECK(audio->is_playing(second));
    CHECK_FALSE(audio->is_playing(VoiceId{}));
}

TEST_CASE_METHOD(Sounds, "the same sound starts no sooner than its interval") {
    audio->set_limit(tone, {.min_interval_s = 0.05, .max_voices = 100});
    int started = 0;
    for (int update = 0; update < 60; ++update) {
        for (int crate = 0; crate < 10; ++crate)
            if (!audio->play(tone).is_null()) ++started;
        audio->advance(1.0 / 60);
    }
    // Three updates are 0.05 s: updates 0, 3, 6, ... 57.
    CHECK(started == 20);
    CHECK(audio->stats().refused == 600 - 20);
}

TEST_CASE_METHOD(
    Sounds, "the same sound has no more voices than its limit, and all sounds together no more than 32") {
    audio->set_limit(tone, {.min_interval_s = 0, .max_voices = 3});
    for (int i = 0; i < 5; ++i) (void)audio->play(tone);
    CHECK(audio->stats().active_voices == 3);
    CHECK(audio->stats().refused == 2);
    audio->set_limit(tone, {.min_interval_s = 0, .max_voices = 100});
    for (int i = 0; i < 50; ++i) (void)audio->play(tone);
    CHECK(audio->stats().active_voices == Audio::kMaxVoices);
    audio->stop_all_sounds();
    CHECK(audio->stats().active_voices == 0);
}

TEST_CASE_METHOD(Sounds, "one path is one sound, and a missing or damaged one is an error that names it") {
    CHECK(*audio->load_sound("tone.wav") == tone);
    folder.put("noise.wav", "this is no sound");
    folder.put("long.wav", tone_wav(61));
    CHECK_THAT(audio->load_sound("nosuch.ogg").error().message,
               Catch::Contains("'nosuch.ogg'") && Catch::Contains("not found"));
    CHECK_THAT(audio->load_sound("noise.wav").error().message, Catch::Contains("'noise.wav'"));
    CHECK_THAT(audio->load_sound("long.wav").error().message, Catch::Contains("music"));
    folder.put("cut.wav", tone_wav(1).substr(0, 5000));
    CHECK_THAT(audio->load_sound("cut.wav").error().message,
               Catch::Contains("'cut.wav'") && Catch::Contains("is cut off"));
    CHECK_THAT(audio->play_music("cut.wav").error().message, Catch::Contains("is cut off"));
    CHECK_THAT(audio->play_music("nosuch.ogg").error().message, Catch::Contains("'nosuch.ogg'"));
}

TEST_CASE_METHOD(Sounds, "a null sound plays nothing and is logged") {
    std::string logged;
    const LogSink before = set_log_sink([&](LogLevel, std::string_view text) { logged = text; });
    CHECK(audio->play(SoundId{}).is_null());
    set_log_sink(before);
    CHECK_THAT(logged, Catch::Contains("null or stale"));
    CHECK(audio->stats().plays == 0);
}

TEST_CASE_METHOD(Sounds, "music plays until it ends or is stopped") {
    REQUIRE(audio->play_music("tone.wav"));
    audio->advance(100);
    CHECK(audio->music() == "tone.wav");
    audio->stop_music();
    CHECK(audio->music().empty());
    REQUIRE(audio->play_music("tone.wav", 1, /*loop=*/false));
    audio->advance(0.6);
    CHECK(audio->music().empty());
    CHECK(audio->stats().music_plays == 2);
}

TEST_CASE_METHOD(Sounds, "group volumes are clamped") {
    audio->set_group_volume(AudioGroup::Music, 7);
    audio->set_group_volume(AudioGroup::Sound, -1);
    CHECK(audio->group_volume(AudioGroup::Music) == 1);
    CHECK(audio->group_volume(AudioGroup::Sound) == 0);
}

TEST_CASE_METHOD(Sounds, "a paused group stands still and then plays the rest") {
    const VoiceId voice = audio->play(tone);
    audio->advance(0.2);
    audio->set_paused(AudioGroup::Sound, true);
    const VoiceId late = audio->play(tone);  // waits too
    audio->advance(100);
    CHECK(audio->is_playing(voice));
    CHECK(audio->is_playing(late));
    audio->set_paused(AudioGroup::Sound, false);
    audio->advance(0.29);
    CHECK(audio->is_playing(voice));
    audio->advance(0.02);
    CHECK_FALSE(audio->is_playing(voice));
    CHECK(audio->is_playing(late));
    audio->advance(0.2);
    CHECK_FALSE(audio->is_playing(late));
}

TEST_CASE_METHOD(Sounds, "groups are apart from each other") {
    const AudioGroup speech = *audio->add_group("speech");
    CHECK(audio->groups() == std::vector<std::string>{"sfx", "music", "speech"});
    const VoiceId said = audio->play(tone, {.group = speech});
    const VoiceId heard = audio->play(tone);
    audio->set_paused(speech, true);
    audio->set_group_volume(speech, 0.25f);
    audio->advance(1);
    CHECK(audio->is_playing(said));
    CHECK_FALSE(audio->is_playing(heard));
    CHECK(audio->group_volume(speech) == 0.25f);
    CHECK(audio->group_volume(AudioGroup::Sound) == 1);
    CHECK_FALSE(audio->add_group("sfx"));
    CHECK_FALSE(audio->add_group(""));
}

TEST_CASE_METHOD(Sounds, "music that fades out is gone when it is silent, and paused music waits") {
    REQUIRE(audio->play_music("tone.wav"));
    audio->stop_music(1);
    audio->advance(0.9);
    CHECK(audio->music() == "tone.wav");
    audio->advance(0.2);
    CHECK(audio->music().empty());
    REQUIRE(audio->play_music("tone.wav", 1, false, 0.2));
    audio->set_paused(AudioGroup::Music, true);
    audio->advance(9);
    CHECK(audio->music() == "tone.wav");
    audio->set_paused(AudioGroup::Music, false);
    audio->advance(0.6);
    CHECK(audio->music().empty());
}
