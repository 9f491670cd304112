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

/// Division of the page's bits by the polynomial, one by one.
std::uint32_t remainder_of(const std::string& page) {
    std::uint32_t crc = 0;
    for (const char c : page) {
        for (int bit = 7; bit >= 0; --bit) {
            const bool carry = ((crc >> 31) ^ (static_cast<unsigned char>(c) >> bit & 1u)) != 0;
            crc = crc << 1 ^ (carry ? 0x04c11db7u : 0);
        }
    }
    return crc;
}

std::string page(int flags, std::uint64_t granule, const std::string& body) {
    std::string text = "OggS";
    append_little_endian(text, 0, 1);
    append_little_endian(text, static_cast<std::uint64_t>(flags), 1);
    append_little_endian(text, granule, 8);
    append_little_endian(text, 0, 12);
    append_little_endian(text, 1, 1);
    append_little_endian(text, body.size(), 1);
    text += body;
    std::string checksum;
    append_little_endian(checksum, remainder_of(text), 4);
    return text.replace(22, 4, checksum);
}

std::string vorbis() {
    std::string packet = "\x01vorbis";
    append_little_endian(packet, 0, 5);
    append_little_endian(packet, 48000, 4);
    packet += std::string(14, '\0');
    return page(2, 0, packet) + page(0, 24000, "some") + page(4, 48000, "more of it");
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

TEST_CASE("a WAV file with numbers that no player takes is refused") {
    const auto with = [](std::size_t at, std::uint64_t value, int bytes) {
        std::string number;
        append_little_endian(number, value, bytes);
        return tone_wav(0.1).replace(at, number.size(), number);
    };
    constexpr std::size_t kChannels = 22, kRate = 24;
    const std::string start = "sound 'a': has a header that states ";
    CHECK(fault(with(kChannels, 0, 2)) == start + "0 channels; must be 1 to 8");
    CHECK(fault(with(kChannels, 60000, 2)) == start + "60000 channels; must be 1 to 8");
    CHECK(fault(with(kRate, 0, 4)) == start + "0 samples a second; must be 1 to 2147483647");
    CHECK(fault(with(kRate, 0xffffffff, 4)) ==
          start + "4294967295 samples a second; must be 1 to 2147483647");
    CHECK(fault(with(kChannels, 8, 2)).empty());
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
