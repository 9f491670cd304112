// Durations from sound headers that are built by hand.
#include "assets/sound_header.h"

#include <catch2/catch.hpp>

#include "engine/support/sounds.h"

using namespace cairn::engine;

namespace {

Result<double> duration(std::string_view file) {
    return read_sound_duration_s(std::as_bytes(std::span(file)), "a");
}

std::string ogg_page(std::uint64_t granule, std::string_view body) {
    std::string page = "OggS";
    append_little_endian(page, 0, 2);  // version, flags
    append_little_endian(page, granule, 8);
    append_little_endian(page, 0, 12);  // stream, sequence, checksum
    append_little_endian(page, 1, 1);   // one segment
    append_little_endian(page, body.size(), 1);
    return page.append(body);
}

std::string vorbis_identification(std::uint64_t rate) {
    std::string packet = "\x01vorbis";
    append_little_endian(packet, 0, 4);
    append_little_endian(packet, 1, 1);
    append_little_endian(packet, rate, 4);
    return packet + std::string(14, '\0');
}

}  // namespace

TEST_CASE("the length of a WAV file is its bytes by its bytes per second") {
    REQUIRE(duration(tone_wav(0.25)));
    CHECK(*duration(tone_wav(0.25)) == Approx(0.25).margin(1e-9));
}

TEST_CASE("the length of an Ogg Vorbis file is the last page's position by the rate") {
    const std::string file =
        ogg_page(0, vorbis_identification(48000)) + ogg_page(24000, "x") + ogg_page(72000, "y");
    REQUIRE(duration(file));
    CHECK(*duration(file) == 1.5);
}

TEST_CASE("a WAV file with a rate or with channels that sound libraries cannot take is refused") {
    const std::string wav = tone_wav(0.01);
    const auto message = [](const std::string& file) {
        const auto read = duration(file);
        return read ? std::string() : read.error().message;
    };
    for (const int channels : {0, 9, 256, 1000, 65535})
        CHECK(message(with_format(wav, 22, static_cast<std::uint64_t>(channels))) ==
              "sound 'a': has " + std::to_string(channels) + " channels, but must have from 1 to 8");
    for (const int channels : {1, 2, 8})
        CHECK(message(with_format(wav, 22, static_cast<std::uint64_t>(channels))) == "");
    CHECK(message(with_format(wav, 24, 0)) ==
          "sound 'a': has a sample rate of 0 Hz, but must have one from 1 to 4194303 Hz");
    CHECK(message(with_format(with_format(wav, 24, 0), 26, 64)) ==  // 2^22
          "sound 'a': has a sample rate of 4194304 Hz, but must have one from 1 to 4194303 Hz");
    CHECK(message(with_format(with_format(wav, 24, 0xffff), 26, 63)) == "");
    // A second format, which some libraries take for the one that counts.
    std::string second = wav + wav.substr(12, 24);
    CHECK(message(second) == "");
    CHECK_THAT(message(with_format(second, wav.size() + 8 + 2, 0)), Catch::Contains("has 0 channels"));
}

TEST_CASE("a sound file that is cut off in its header, or is something else, is refused") {
    const std::string wav = tone_wav(0.01);
    for (std::size_t length = 0; length < 44; ++length) CHECK_FALSE(duration(wav.substr(0, length)));
    const std::string ogg = ogg_page(0, vorbis_identification(48000));
    for (std::size_t length = 0; length < 44; ++length) CHECK_FALSE(duration(ogg.substr(0, length)));
    CHECK_FALSE(duration(ogg_page(0, "OpusHead and so on")));
    CHECK_FALSE(duration(ogg_page(0, vorbis_identification(0))));
    CHECK_FALSE(duration("ID3 is an MP3 file"));
    CHECK_THAT(duration("ID3").error().message, Catch::Contains("neither an Ogg Vorbis nor a WAV"));
}
