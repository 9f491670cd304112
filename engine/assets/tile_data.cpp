// CSV and base64. Invariant: no more is ever unpacked than the cells need, so a small file cannot fill the
// memory.
#include "assets/tile_data.h"

#include <array>
#include <charconv>
#include <zlib.h>

#include "assets/json_text.h"

namespace cairn::engine {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

/// The value of a base64 letter, or -1.
int letter_value(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+') return 62;
    return c == '/' ? 63 : -1;
}

Result<std::vector<std::uint8_t>> decode_base64(std::string_view text) {
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (is_space(c) || c == '=') continue;
        const int value = letter_value(c);
        if (value < 0) return Error{excerpt(std::string(1, c)) + " is no letter of base64"};
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        if (++count < 4) continue;
        for (const int shift : {16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
        bits = 0;
        count = 0;
    }
    if (count == 1) return Error{"the base64 text is cut off"};
    if (count == 2) bytes.push_back(static_cast<std::uint8_t>(bits >> 4));
    if (count == 3) {
        bytes.push_back(static_cast<std::uint8_t>(bits >> 10));
        bytes.push_back(static_cast<std::uint8_t>(bits >> 2));
    }
    return bytes;
}

/// Of zlib or gzip; exactly `size` bytes must come out.
Result<std::vector<std::uint8_t>> inflate_bytes(const std::vector<std::uint8_t>& packed, std::size_t size) {
    std::vector<std::uint8_t> bytes(size + 1);  // one more shows that there is too much
    z_stream stream{};
    constexpr int kDetectHeader = 15 + 32;
    if (inflateInit2(&stream, kDetectHeader) != Z_OK) return Error{"the data cannot be unpacked"};
    stream.next_in = const_cast<std::uint8_t*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = bytes.data();
    stream.avail_out = static_cast<uInt>(bytes.size());
    const int status = inflate(&stream, Z_FINISH);
    const std::size_t got = stream.total_out;
    inflateEnd(&stream);
    if (got != size || (status != Z_STREAM_END && status != Z_BUF_ERROR))
        return Error{"the compressed data is damaged, or not " + std::to_string(size) + " bytes long"};
    bytes.resize(size);
    return bytes;
}

Error wrong_count(std::size_t got, std::size_t cells) {
    return Error{"it has " + std::to_string(got) + " tiles, but the layer has " + std::to_string(cells) +
                 " cells"};
}

}  // namespace

Result<std::vector<std::uint32_t>> tiles_from_csv(std::string_view text, std::size_t cells) {
    std::vector<std::uint32_t> tiles;
    while (true) {
        while (!text.empty() && (is_space(text.front()) || text.front() == ',')) text.remove_prefix(1);
        if (text.empty()) break;
        std::uint32_t value = 0;
        const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
        if (end.ec != std::errc{})
            return Error{excerpt(std::string(text.substr(0, 12))) + " is no tile number"};
        text.remove_prefix(static_cast<std::size_t>(end.ptr - text.data()));
        if (tiles.size() == cells) return wrong_count(cells + 1, cells);
        tiles.push_back(value);
    }
    if (tiles.size() != cells) return wrong_count(tiles.size(), cells);
    return tiles;
}

Result<std::vector<std::uint32_t>> tiles_from_base64(std::string_view text, std::string_view compression,
                                                     std::size_t cells) {
    Result<std::vector<std::uint8_t>> bytes = decode_base64(text);
    if (!bytes) return bytes.error();
    if (compression == "zlib" || compression == "gzip") {
        bytes = inflate_bytes(*bytes, 4 * cells);
        if (!bytes) return bytes.error();
    } else if (!compression.empty()) {
        return Error{"the compression '" + std::string(compression) +
                     "' is not known; save it as CSV, zlib or gzip"};
    }
    if (bytes->size() != 4 * cells) return wrong_count(bytes->size() / 4, cells);
    std::vector<std::uint32_t> tiles(cells);
    for (std::size_t i = 0; i < cells; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            tiles[i] |= static_cast<std::uint32_t>((*bytes)[4 * i + k]) << (8 * k);
    return tiles;
}

}  // namespace cairn::engine
