// The two ways to fill a window. Invariant: textures never outlive the SDL_Renderer that made them.
#include "render/sdl/window_backend.h"

#include <SDL.h>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <cairn/engine/log.h>

#include "render/surface/surface_backend.h"

namespace cairn::engine {
namespace {

struct SdlDeleter {
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};
using RendererPtr = std::unique_ptr<SDL_Renderer, SdlDeleter>;
using TexturePtr = std::unique_ptr<SDL_Texture, SdlDeleter>;

Error sdl_error(std::string_view what) {
    return Error{std::string(what) + ": " + SDL_GetError()};
}

Size output_size(SDL_Renderer* renderer) {
    Size size;
    SDL_GetRendererOutputSize(renderer, &size.width, &size.height);
    return size;
}

/// The factors of (what is drawn, what lies under it) for premultiplied colors; those of the rasterizer's
/// blended().
SDL_BlendMode to_sdl(BlendMode mode) {
    const auto compose = [](SDL_BlendFactor color, SDL_BlendFactor under, SDL_BlendFactor alpha,
                            SDL_BlendFactor alpha_under) {
        return SDL_ComposeCustomBlendMode(color, under, SDL_BLENDOPERATION_ADD, alpha, alpha_under,
                                          SDL_BLENDOPERATION_ADD);
    };
    switch (mode) {
        case BlendMode::Alpha:
            return compose(SDL_BLENDFACTOR_ONE, SDL_BLENDFACTOR_ONE_MINUS_SRC_ALPHA, SDL_BLENDFACTOR_ONE,
                           SDL_BLENDFACTOR_ONE_MINUS_SRC_ALPHA);
        case BlendMode::Add:
            return compose(SDL_BLENDFACTOR_ONE, SDL_BLENDFACTOR_ONE, SDL_BLENDFACTOR_ZERO,
                           SDL_BLENDFACTOR_ONE);
        case BlendMode::Multiply:
            return compose(SDL_BLENDFACTOR_DST_COLOR, SDL_BLENDFACTOR_ONE_MINUS_SRC_ALPHA,
                           SDL_BLENDFACTOR_ZERO, SDL_BLENDFACTOR_ONE);
        case BlendMode::Screen:
            return compose(SDL_BLENDFACTOR_ONE, SDL_BLENDFACTOR_ONE_MINUS_SRC_COLOR, SDL_BLENDFACTOR_ONE,
                           SDL_BLENDFACTOR_ONE_MINUS_SRC_ALPHA);
        case BlendMode::Replace:
            return SDL_BLENDMODE_NONE;
    }
    return SDL_BLENDMODE_NONE;
}

/// Whether there may be a graphics driver. Linux shows its devices as files; to see that there are none takes
/// less than to start an OpenGL that is drawn by the processor, a tenth of a second.
bool may_be_accelerated() {
#ifdef __linux__
    for (const char* device : {"/dev/dri", "/dev/nvidiactl", "/dev/dxg", "/dev/mali0", "/dev/kgsl-3d0"}) {
        std::error_code ignored;
        if (std::filesystem::exists(device, ignored)) return true;
    }
    return false;
#else
    return true;
#endif
}

/// Whether the OpenGL context at hand is drawn by the processor. What these programs make of a picture takes
/// several times as long as our rasterizer does.
bool is_imitated_by_processor() {
    using GetString = const unsigned char* (*)(unsigned int name);
    constexpr unsigned int kGlRenderer = 0x1F01;
    if (SDL_GL_GetCurrentContext() == nullptr) return false;
    const auto get_string = reinterpret_cast<GetString>(SDL_GL_GetProcAddress("glGetString"));
    const unsigned char* name = get_string != nullptr ? get_string(kGlRenderer) : nullptr;
    if (name == nullptr) return false;
    const std::string_view renderer(reinterpret_cast<const char*>(name));
    for (const std::string_view imitation : {"llvmpipe", "softpipe", "swrast", "SwiftShader"}) {
        if (renderer.find(imitation) != std::string_view::npos) return true;
    }
    return false;
}

/// SDL's renderer on a graphics driver draws the triangles.
class AcceleratedBackend final : public RenderBackend {
  public:
    AcceleratedBackend(const SdlWindow& window, RendererPtr renderer, bool has_vsync)
        : window_(window), renderer_(std::move(renderer)), has_vsync_(has_vsync) {}

    Viewport viewport() const override {
        return make_viewport(window_.logical_size(), output_size(renderer_.get()));
    }
    bool keeps_pixels() const override { return true; }

    Result<BackendTexture> create_texture(const Image& image, TextureFilter filter) override {
        TexturePtr texture(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGBA32,
                                             SDL_TEXTUREACCESS_STATIC, image.size.width, image.size.height));
        if (!texture ||
            SDL_UpdateTexture(texture.get(), nullptr, image.rgba.data(), 4 * image.size.width) != 0)
            return sdl_error("cannot make a texture");
        return keep(std::move(texture), filter);
    }

    Result<BackendTexture> create_canvas(Size size, TextureFilter filter) override {
        TexturePtr texture(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGBA32,
                                             SDL_TEXTUREACCESS_TARGET, size.width, size.height));
        if (!texture) return sdl_error("cannot make a canvas");
        // What a new target shows is not defined.
        SDL_Texture* before = SDL_GetRenderTarget(renderer_.get());
        SDL_SetRenderTarget(renderer_.get(), texture.get());
        clear({0, 0, 0, 0});
        SDL_SetRenderTarget(renderer_.get(), before);
        return keep(std::move(texture), filter);
    }

    void set_target(BackendTexture canvas) override {
        SDL_SetRenderTarget(renderer_.get(), canvas ? textures_[canvas - 1].get() : nullptr);
    }

    void update_texture(BackendTexture texture, int x, int y, const Image& part) override {
        const SDL_Rect area = {x, y, part.size.width, part.size.height};
        SDL_UpdateTexture(textures_[texture - 1].get(), &area, part.rgba.data(), 4 * part.size.width);
    }

    void destroy_texture(BackendTexture texture) override { textures_[texture - 1].reset(); }

    void clear(Color color) override {
        const Rgba8 c = to_rgba8(color);
        SDL_RenderSetClipRect(renderer_.get(), nullptr);
        SDL_SetRenderDrawColor(renderer_.get(), c.r, c.g, c.b, c.a);
        SDL_RenderClear(renderer_.get());
    }

    void draw(std::span<const RenderVertex> vertices, std::span<const int> indices, BackendTexture texture,
              BlendMode blend, const PixelRect& scissor) override {
        static_assert(sizeof(Rgba8) == sizeof(SDL_Color), "vertex colors are handed to SDL as they are");
        const SDL_Rect clip = {scissor.x, scissor.y, scissor.width, scissor.height};
        SDL_RenderSetClipRect(renderer_.get(), &clip);
        SDL_Texture* image = texture ? textures_[texture - 1].get() : nullptr;
        if (image)
            SDL_SetTextureBlendMode(image, to_sdl(blend));
        else
            SDL_SetRenderDrawBlendMode(renderer_.get(), to_sdl(blend));
        constexpr int kStride = sizeof(RenderVertex);
        const int failed = SDL_RenderGeometryRaw(
            renderer_.get(), image, &vertices[0].position.x, kStride,
            reinterpret_cast<const SDL_Color*>(&vertices[0].color), kStride, &vertices[0].uv.x, kStride,
            static_cast<int>(vertices.size()), indices.data(), static_cast<int>(indices.size()), sizeof(int));
        if (failed && !std::exchange(has_warned_, true))
            log(LogLevel::Warning, std::string("drawing failed: ") + SDL_GetError());
    }

    Result<Image> read_pixels() override {
        Image image{output_size(renderer_.get()), {}};
        image.rgba.resize(4 * static_cast<std::size_t>(image.size.width) * image.size.height);
        SDL_RenderSetClipRect(renderer_.get(), nullptr);
        if (SDL_RenderReadPixels(renderer_.get(), nullptr, SDL_PIXELFORMAT_RGBA32, image.rgba.data(),
                                 4 * image.size.width) != 0)
            return sdl_error("cannot read the picture back");
        // What a driver leaves in the window's alpha is not defined; the picture is opaque.
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
        return image;
    }

    void present() override { SDL_RenderPresent(renderer_.get()); }
    bool waits_for_display() const override { return has_vsync_; }

  private:
    BackendTexture keep(TexturePtr texture, TextureFilter filter) {
        SDL_SetTextureScaleMode(
            texture.get(), filter == TextureFilter::Nearest ? SDL_ScaleModeNearest : SDL_ScaleModeLinear);
        for (std::size_t i = 0; i < textures_.size(); ++i)
            if (!textures_[i]) {
                textures_[i] = std::move(texture);
                return static_cast<BackendTexture>(i + 1);
            }
        textures_.push_back(std::move(texture));
        return static_cast<BackendTexture>(textures_.size());
    }

    const SdlWindow& window_;
    RendererPtr renderer_;
    std::vector<TexturePtr> textures_;  ///< texture id - 1; empty: free
    bool has_vsync_;
    bool has_warned_ = false;
};

/// What the window shows, in the form that the display wants. Asked anew each time: it follows the window's
/// size.
SDL_Surface* shown_by(const SdlWindow& window) {
    return SDL_GetWindowSurface(window.native());
}

void copy_rows(const Image& picture, SDL_Surface& to) {
    // Red and blue change places in what nearly every display wants. SDL's conversion looks at each pixel's
    // format.
    const bool is_bgr =
        to.format->format == SDL_PIXELFORMAT_RGB888 || to.format->format == SDL_PIXELFORMAT_ARGB8888;
    const int pitch = 4 * picture.size.width;
    if (!is_bgr || SDL_BYTEORDER != SDL_LIL_ENDIAN) {
        SDL_ConvertPixels(picture.size.width, picture.size.height, SDL_PIXELFORMAT_RGBA32,
                          picture.rgba.data(), pitch, to.format->format, to.pixels, to.pitch);
        return;
    }
    for (int y = 0; y < picture.size.height; ++y) {
        const std::uint8_t* const from = picture.rgba.data() + static_cast<std::ptrdiff_t>(y) * pitch;
        std::uint8_t* const row =
            static_cast<std::uint8_t*>(to.pixels) + static_cast<std::ptrdiff_t>(y) * to.pitch;
        for (int x = 0; x < picture.size.width; ++x) {
            std::uint32_t rgba;
            std::memcpy(&rgba, from + 4 * x, 4);
            const std::uint32_t bgra = (rgba & 0xff00ff00u) | ((rgba >> 16) & 0xffu) | ((rgba & 0xffu) << 16);
            std::memcpy(row + 4 * x, &bgra, 4);
        }
    }
}

/// Our rasterizer draws; SDL shows the picture.
class UnacceleratedBackend final : public RenderBackend {
  public:
    explicit UnacceleratedBackend(const SdlWindow& window)
        : window_(window), surface_([&window] {
              const SDL_Surface* shown = shown_by(window);
              return make_viewport(window.logical_size(),
                                   shown ? Size{shown->w, shown->h} : window.logical_size());
          }) {}

    Viewport viewport() const override { return surface_.viewport(); }
    bool keeps_pixels() const override { return true; }
    Result<BackendTexture> create_texture(const Image& image, TextureFilter filter) override {
        return surface_.create_texture(image, filter);
    }
    Result<BackendTexture> create_canvas(Size size, TextureFilter filter) override {
        return surface_.create_canvas(size, filter);
    }
    void set_target(BackendTexture canvas) override { surface_.set_target(canvas); }
    void update_texture(BackendTexture texture, int x, int y, const Image& part) override {
        surface_.update_texture(texture, x, y, part);
    }
    void destroy_texture(BackendTexture texture) override { surface_.destroy_texture(texture); }

    void clear(Color color) override { surface_.clear(color); }

    void draw(std::span<const RenderVertex> vertices, std::span<const int> indices, BackendTexture texture,
              BlendMode blend, const PixelRect& scissor) override {
        surface_.draw(vertices, indices, texture, blend, scissor);
    }

    Result<Image> read_pixels() override { return surface_.read_pixels(); }

    void present() override {
        SDL_Surface* const shown = shown_by(window_);
        const Image& picture = surface_.picture();
        // The window may have been resized since the picture was begun; the next one has its size.
        if (shown == nullptr || Size{shown->w, shown->h} != picture.size) return;
        if (SDL_LockSurface(shown) != 0) return;
        copy_rows(picture, *shown);
        SDL_UnlockSurface(shown);
        SDL_UpdateWindowSurface(window_.native());
    }

  private:
    const SdlWindow& window_;
    SurfaceBackend surface_;
};

}  // namespace

Result<std::unique_ptr<RenderBackend>> make_window_backend(const SdlWindow& window) {
    // Else the window's surface would go through the imitated driver that it stands in for.
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    const char* chosen = SDL_GetHint(SDL_HINT_RENDER_DRIVER);
    const bool is_chosen = chosen != nullptr && *chosen != '\0';
    const bool wants_software = is_chosen ? std::string_view(chosen) == "software" : !may_be_accelerated();
    if (!wants_software) {
        RendererPtr renderer(
            SDL_CreateRenderer(window.native(), -1, window.def().has_vsync ? SDL_RENDERER_PRESENTVSYNC : 0));
        SDL_RendererInfo info{};
        if (!renderer) return sdl_error("cannot draw into the window");
        SDL_GetRendererInfo(renderer.get(), &info);
        const bool by_processor =
            (info.flags & SDL_RENDERER_SOFTWARE) || (!is_chosen && is_imitated_by_processor());
        if (!by_processor)
            return std::unique_ptr<RenderBackend>(std::make_unique<AcceleratedBackend>(
                window, std::move(renderer), (info.flags & SDL_RENDERER_PRESENTVSYNC) != 0));
    }
    if (shown_by(window) == nullptr) return sdl_error("cannot draw into the window");
    return std::unique_ptr<RenderBackend>(std::make_unique<UnacceleratedBackend>(window));
}

}  // namespace cairn::engine
