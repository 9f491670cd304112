// Sounds built by hand, whole, cut and damaged. The oracle of checksums divides bit by bit.
#include "assets/sound_check.h"

#include <catch2/catch.hpp>

#include "engine/support/sounds.h"

using namespace cairn::engine;

namespace {

std::string fault(std::string_view file) {
    const auto checked = check_sound_bytes(std::as_bytes(std::span(file)), "a");
    return checked ? std::string() : checked.error().message;
}

}  // namespace

TEST_CASE("whole sounds have no fault") {
    CHECK(fault(tone_wav(0.1)).empty());
    CHECK(fault(vorbis()).empty());
}

TEST_CASE("a WAV file that ends before its samples do is cut off, wherever that is") {
    const std::string wav = tone_wav(0.1);
    for (std::size_t length = 44; length < wav.size(); length += 97)
        CHECK(fault(wav.substr(0, length))
                  .find("sound 'a': is cut off: its samples should take 1600 bytes, and ") == 0);
    CHECK(fault(wav.substr(0, 44 + 512)) ==
          "sound 'a': is cut off: its samples should take 1600 bytes, and 512 are there");
    for (std::size_t length = 0; length < 44; ++length) CHECK_FALSE(fault(wav.substr(0, length)).empty());
}

TEST_CASE("a WAV file whose samples nobody decodes is refused with what would do") {
    const std::string wav = tone_wav(0.1);
    CHECK(fault(with_format(wav, 20, 85)) ==
          "sound 'a': has the encoding 85, but must have one of 1 (PCM), 2 (Microsoft ADPCM), 3 (floats), 6 "
          "(A-law), "
          "7 (mu-law), 17 (IMA ADPCM)");
    for (const int bits : {0, 1, 4, 12, 20, 64})
        CHECK(fault(with_format(wav, 34, static_cast<std::uint64_t>(bits))) ==
              "sound 'a': has " + std::to_string(bits) +
                  " bits a sample, but as PCM must have one of 8, 16, 24, 32");
    CHECK(fault(with_format(wav, 20, 3)) == "sound 'a': has 16 bits a sample, but as floats must have 32");
    CHECK(fault(with_format(wav, 32, 0)) == "sound 'a': has 0 bytes a frame, but must have 2");
    CHECK(fault(with_format(wav, 32, 3)) == "sound 'a': has 3 bytes a frame, but must have 2");
    CHECK(fault(with_format(wav, 24, 0)) ==
          "sound 'a': has a sample rate of 0 Hz, but must have one from 1 to 4194303 Hz");
    CHECK(fault(with_format(wav, 22, 1000)) == "sound 'a': has 1000 channels, but must have from 1 to 8");
    CHECK(fault(with_format(with_format(with_format(wav, 20, 7), 32, 1), 34, 8)) == "");  // mu-law
}

TEST_CASE("an Ogg file that is cut off anywhere, or in which any bit differs, is refused") {
    const std::string ogg = vorbis();
    for (std::size_t length = 0; length < ogg.size(); ++length) {
        INFO(length);
        CHECK_FALSE(fault(ogg.substr(0, length)).empty());
    }
    for (std::size_t bit = 0; bit < 8 * ogg.size(); ++bit) {
        std::string damaged = ogg;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ 1 << bit % 8);
        INFO(bit);
        CHECK_FALSE(fault(damaged).empty());
    }
    CHECK(fault(ogg.substr(0, ogg.size() - 38)).find("its last page is not the end of the stream") !=
          std::string::npos);
    CHECK(fault(ogg + "x").find("a page should begin") != std::string::npos);
}
