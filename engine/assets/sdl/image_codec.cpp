// Decodes JPEG and encodes PNG with SDL2_image. Invariant: header and end are checked before a decoder sees
// the file, so only whole PNG and JPEG of a sane size reach one.
#include <SDL.h>
#include <SDL_image.h>
#include <cassert>
#include <cstring>
#include <memory>

#include <cairn/engine/image.h>
#include <cairn/engine/native_file.h>

#include "assets/png_decoder.h"

namespace cairn::engine {
namespace {

struct SurfaceDeleter {
    void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};
using Surface = std::unique_ptr<SDL_Surface, SurfaceDeleter>;

Error image_error(std::string_view name, std::string_view reason) {
    return Error{"image '" + std::string(name) + "': " + std::string(reason)};
}

/// Where an SDL stream for writing keeps its bytes. SDL has streams over fixed memory only.
struct GrowingMemory {
    std::vector<std::byte> bytes;
    std::size_t at = 0;
};

GrowingMemory& memory_of(SDL_RWops* stream) {
    return *static_cast<GrowingMemory*>(stream->hidden.unknown.data1);
}

SDL_RWops* open_growing_memory(GrowingMemory& memory) {
    SDL_RWops* stream = SDL_AllocRW();
    if (!stream) return nullptr;
    stream->type = SDL_RWOPS_UNKNOWN;
    stream->hidden.unknown.data1 = &memory;
    stream->size = [](SDL_RWops* s) { return static_cast<Sint64>(memory_of(s).bytes.size()); };
    stream->seek = [](SDL_RWops* s, Sint64 offset, int whence) {
        GrowingMemory& m = memory_of(s);
        const auto end = static_cast<Sint64>(m.bytes.size());
        const Sint64 base = whence == RW_SEEK_SET   ? 0
                            : whence == RW_SEEK_CUR ? static_cast<Sint64>(m.at)
                                                    : end;
        if (base + offset < 0 || base + offset > end) return Sint64{-1};
        m.at = static_cast<std::size_t>(base + offset);
        return base + offset;
    };
    stream->read = [](SDL_RWops*, void*, std::size_t, std::size_t) { return std::size_t{0}; };
    stream->write = [](SDL_RWops* s, const void* data, std::size_t size, std::size_t count) {
        GrowingMemory& m = memory_of(s);
        const std::size_t added = size * count;
        if (m.at + added > m.bytes.size()) m.bytes.resize(m.at + added);
        std::memcpy(m.bytes.data() + m.at, data, added);
        m.at += added;
        return count;
    };
    stream->close = [](SDL_RWops* s) {
        SDL_FreeRW(s);
        return 0;
    };
    return stream;
}

}  // namespace

const std::uint8_t* Image::pixel(int x, int y) const {
    assert(x >= 0 && x < size.width && y >= 0 && y < size.height);
    return rgba.data() + 4 * (static_cast<std::size_t>(y) * size.width + x);
}

Result<Image> decode_image(std::span<const std::byte> file, std::string_view name) {
    const Result<Size> stated = check_image(file, name);
    if (!stated) return stated.error();
    if (is_png(file)) return decode_png(file, *stated, name);
    SDL_RWops* stream = SDL_RWFromConstMem(file.data(), static_cast<int>(file.size()));
    if (!stream) return image_error(name, SDL_GetError());
    const Surface decoded(IMG_Load_RW(stream, /*freesrc=*/1));
    if (!decoded) return image_error(name, std::string("is damaged: ") + IMG_GetError());
    const Surface rgba(SDL_ConvertSurfaceFormat(decoded.get(), SDL_PIXELFORMAT_RGBA32, 0));
    if (!rgba) return image_error(name, SDL_GetError());

    Image image{{rgba->w, rgba->h}, {}};
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(rgba->w);
    image.rgba.resize(row_bytes * rgba->h);
    for (int y = 0; y < rgba->h; ++y)
        std::memcpy(
            image.rgba.data() + y * row_bytes,
            static_cast<const std::uint8_t*>(rgba->pixels) + static_cast<std::size_t>(y) * rgba->pitch,
            row_bytes);
    return image;
}

Result<std::vector<std::byte>> encode_png(const Image& image) {
    // SDL takes the pixels as not const, but saving only reads them.
    const Surface surface(SDL_CreateRGBSurfaceWithFormatFrom(const_cast<std::uint8_t*>(image.rgba.data()),
                                                             image.size.width, image.size.height, 32,
                                                             4 * image.size.width, SDL_PIXELFORMAT_RGBA32));
    GrowingMemory memory;
    SDL_RWops* stream = surface ? open_growing_memory(memory) : nullptr;
    if (!stream || IMG_SavePNG_RW(surface.get(), stream, /*freedst=*/1) != 0)
        return Error{std::string("cannot encode a picture as PNG: ") + SDL_GetError()};
    return std::move(memory.bytes);
}

Result<void> save_png(const Image& image, const std::string& native_path) {
    const Result<std::vector<std::byte>> png = encode_png(image);
    if (!png) return png.error();
    return write_native_file(native_path, {reinterpret_cast<const char*>(png->data()), png->size()});
}

}  // namespace cairn::engine
