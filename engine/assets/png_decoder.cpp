// SDL2_image leaves libpng its own handlers, which write to standard error and know no file's name; hence
// this way past it. libpng leaves a faulty file by longjmp: the functions that it may leave own nothing.
#include "assets/png_decoder.h"

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <png.h>
#include <string>

namespace cairn::engine {
namespace {

constexpr std::size_t kSignatureBytes = 8;

/// What libpng's handlers work on.
struct Reading {
    std::span<const std::byte> file;
    std::size_t at = 0;
    char reason[160] = "";
};

void read_bytes(png_structp png, png_bytep out, std::size_t count) {
    auto& reading = *static_cast<Reading*>(png_get_io_ptr(png));
    if (count > reading.file.size() - reading.at) png_error(png, "it ends too early");
    std::memcpy(out, reading.file.data() + reading.at, count);
    reading.at += count;
}

[[noreturn]] void keep_reason(png_structp png, png_const_charp reason) {
    auto& reading = *static_cast<Reading*>(png_get_error_ptr(png));
    std::snprintf(reading.reason, sizeof reading.reason, "%s", reason);
    png_longjmp(png, 1);
}

/// They are about what is not used, such as a color profile that is not as it should be.
void drop_warning(png_structp, png_const_charp) {}

/// libpng's two objects.
class Decoder {
  public:
    explicit Decoder(Reading& reading)
        : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, keep_reason, drop_warning)),
          info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
        if (info_ != nullptr) png_set_read_fn(png_, &reading, read_bytes);
    }
    ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    /// Up to the pixels, which are to be red, green, blue and alpha of a byte each.
    bool read_header() {
        if (info_ == nullptr) return false;
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_info(png_, info_);
        png_set_strip_16(png_);
        png_set_expand(png_);
        png_set_gray_to_rgb(png_);
        png_set_add_alpha(png_, 0xff, PNG_FILLER_AFTER);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }

    [[nodiscard]] std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }

    bool read_pixels(png_bytep* rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_image(png_, rows);
        return true;
    }

  private:
    png_structp png_;
    png_infop info_;
};

}  // namespace

bool is_png(std::span<const std::byte> file) {
    return file.size() >= kSignatureBytes &&
           png_sig_cmp(reinterpret_cast<png_const_bytep>(file.data()), 0, kSignatureBytes) == 0;
}

Result<Image> decode_png(std::span<const std::byte> file, Size size, std::string_view name) {
    Reading reading{.file = file};
    Decoder decoder(reading);
    const auto damaged = [&] {
        const std::string reason = reading.reason[0] != '\0' ? reading.reason : "it cannot be read";
        return Error{"image '" + std::string(name) + "': is damaged: " + reason};
    };
    if (!decoder.read_header()) return damaged();
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(size.width);
    if (decoder.row_bytes() != row_bytes) return damaged();
    Image image{size, {}};
    image.rgba.resize(row_bytes * static_cast<std::size_t>(size.height));
    std::vector<png_bytep> rows;
    for (int y = 0; y < size.height; ++y) rows.push_back(image.rgba.data() + row_bytes * y);
    if (!decoder.read_pixels(rows.data())) return damaged();
    return image;
}

}  // namespace cairn::engine
