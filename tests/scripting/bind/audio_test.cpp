// cairn.audio on the silent back-end: groups, pauses, music and their messages.
#include <catch2/catch.hpp>

#include "engine/support/sounds.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

struct Sounds : LuaBench {
    Sounds() : LuaBench({{"tone.wav", tone_wav(0.5)}, {"song.wav", tone_wav(2)}}) {}
    void frames(int count) {
        for (int i = 0; i < count; ++i) REQUIRE_FALSE(game().update({}));
    }
};

}  // namespace

TEST_CASE_METHOD(Sounds, "a group of the game's own has a pause of its own") {
    REQUIRE(run("cairn.audio.new_group('ui') a = cairn.audio.play('tone.wav') "
                "cairn.audio.set_rate_cap('tone.wav', 0, 8) "
                "b = cairn.audio.play('tone.wav', { group = 'ui' }) cairn.audio.pause('sfx')") == "");
    frames(60);
    CHECK(value("cairn.audio.is_playing(a)") == "true");
    CHECK(value("cairn.audio.is_playing(b)") == "false");
    CHECK(value("cairn.audio.is_paused('sfx')") == "true");
    REQUIRE(run("cairn.audio.resume('sfx')") == "");
    frames(28);
    CHECK(value("cairn.audio.is_playing(a)") == "true");
    frames(4);
    CHECK(value("cairn.audio.is_playing(a)") == "false");
    CHECK(value("cairn.audio.duration('tone.wav')") == "0.5");
}

TEST_CASE_METHOD(Sounds, "music fades out and is then gone") {
    REQUIRE(run("cairn.audio.play_music('song.wav', { fade = 0.2 })") == "");
    CHECK(value("cairn.audio.music()") == "song.wav");
    REQUIRE(run("cairn.audio.stop_music(0.5)") == "");
    frames(5);
    CHECK(value("cairn.audio.music()") == "nil");  // it had swelled for no time yet, so it is silent at once
    REQUIRE(run("cairn.audio.play_music('song.wav') cairn.audio.stop_music(0.5)") == "");
    frames(28);
    CHECK(value("cairn.audio.music()") == "song.wav");
    frames(4);
    CHECK(value("cairn.audio.music()") == "nil");
}

TEST_CASE_METHOD(Sounds, "wrong groups name the nearest") {
    CHECK(run("cairn.audio.set_volume('sfy', 1)")
              .find("group is \"sfy\": no such group; did you mean \"sfx\"?") != std::string::npos);
    CHECK(run("cairn.audio.play('tone.wav', { group = 'music' })").find("must not be the music's") !=
          std::string::npos);
    CHECK(run("cairn.audio.new_group('sfx')").find("must be new") != std::string::npos);
    CHECK(run("for i = 1, 20 do cairn.audio.new_group('g' .. i) end").find("there are 16 already") !=
          std::string::npos);
    CHECK(run("cairn.audio.stop_music(-1)").find("from 0 to 3600 s") != std::string::npos);
}

}  // namespace cairn::scripting::test
