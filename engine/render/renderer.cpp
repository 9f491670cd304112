// The renderer's assets, frames and drawing state. Invariant: between frames nothing is left in the batch,
// and the stack of transforms holds the identity only.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include <cairn/engine/log.h>
#include <cairn/engine/renderer.h>

#include "render/renderer_state.h"

namespace cairn::engine {
namespace {

constexpr int kMaxTransforms = 64;

PixelRect whole(Size size) {
    return {0, 0, size.width, size.height};
}

/// The pixels whose middle lies in the area between two corners, cut to `bounds`. Written so that NaN gives
/// no pixels.
PixelRect pixels_between(Vec2 low, Vec2 high, Size bounds) {
    const auto clamp = [](float value, int limit) {
        return value > 0 ? static_cast<int>(std::lround(std::min(value, static_cast<float>(limit)))) : 0;
    };
    const int x = clamp(low.x, bounds.width);
    const int y = clamp(low.y, bounds.height);
    return {x, y, std::max(clamp(high.x, bounds.width) - x, 0),
            std::max(clamp(high.y, bounds.height) - y, 0)};
}

PixelRect logical_pixels(const Viewport& viewport, const Rect& area) {
    const Affine2 map = viewport.output_from_logical();
    return pixels_between(map.apply({area.x, area.y}), map.apply({area.x + area.width, area.y + area.height}),
                          viewport.output);
}

/// Pixels of a color, whatever their alpha.
void make_transparent(Image& image, const std::array<std::uint8_t, 3>& color) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        if (std::equal(color.begin(), color.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(i)))
            image.rgba[i + 3] = 0;
    }
}

Rect logical_area(const Viewport& viewport) {
    return {0, 0, static_cast<float>(viewport.logical.width), static_cast<float>(viewport.logical.height)};
}

}  // namespace

Renderer::State::State(const Files& files_to_read, std::unique_ptr<RenderBackend> chosen)
    : files(files_to_read),
      backend(std::move(chosen)),
      viewport(backend->viewport()),
      batch(*backend),
      glyphs(*backend, batch) {}

Renderer::Renderer(const Files& files, std::unique_ptr<RenderBackend> backend)
    : state_(std::make_unique<State>(files, std::move(backend))) {}

Renderer::~Renderer() = default;

// ---- Assets

Result<Texture> Renderer::State::read_texture(const TextureSource& source) {
    const std::string& path = source.path;
    const Result<std::vector<std::byte>> file = files.read_bytes(path);
    if (!file) return Error{"image '" + path + "' cannot be loaded: " + file.error().message};

    Texture texture;
    texture.source = source;
    if (backend->keeps_pixels()) {
        Result<Image> image = decode_image(*file, path);
        if (!image) return image.error();
        if (source.transparent) make_transparent(*image, *source.transparent);
        premultiply(*image);
        const Result<BackendTexture> made = backend->create_texture(*image, source.filter);
        if (!made) return Error{"image '" + path + "': " + made.error().message};
        texture.size = image->size;
        texture.backend_texture = *made;
    } else {
        const Result<Size> size = check_image(*file, path);
        if (!size) return size.error();
        texture.size = *size;
    }
    return texture;
}

Result<TextureId> Renderer::load_texture(std::string_view path, TextureFilter filter,
                                         std::optional<Color> transparent) {
    TextureSource source{std::string(path), filter};
    if (transparent) {
        const Rgba8 color = to_rgba8({transparent->r, transparent->g, transparent->b, 1});
        source.transparent = {color.r, color.g, color.b};
    }
    const auto known = state_->textures_by_source.find(source);
    if (known != state_->textures_by_source.end()) return known->second;
    Result<Texture> texture = state_->read_texture(source);
    if (!texture) return texture.error();
    const TextureId id = state_->textures.insert(*std::move(texture));
    state_->textures_by_source.emplace(std::move(source), id);
    return id;
}

Result<bool> Renderer::reload_texture(std::string_view path) {
    State& s = *state_;
    bool is_known = false;
    for (const auto& [source, id] : s.textures_by_source) {
        if (source.path != path) continue;
        Result<Texture> texture = s.read_texture(source);
        if (!texture) return texture.error();
        Texture* old = s.textures.find(id);
        s.batch.flush();
        if (old->backend_texture) s.backend->destroy_texture(old->backend_texture);
        *old = *std::move(texture);
        is_known = true;
    }
    return is_known;
}

void Renderer::forget_files(std::string_view folder) {
    const std::string prefix = std::string(folder) + '/';
    std::erase_if(state_->textures_by_source,
                  [&](const auto& known) { return known.first.path.starts_with(prefix); });
    state_->fonts.forget_files(prefix);
}

Result<TextureId> Renderer::create_texture(const Image& image, TextureFilter filter) {
    const auto [width, height] = image.size;
    if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide)
        return Error{"texture: the size " + std::to_string(width) + " x " + std::to_string(height) +
                     " must be 1 to " + std::to_string(kMaxImageSide) + " on each side"};
    assert(image.rgba.size() == 4 * static_cast<std::size_t>(width) * height);
    Texture texture;
    texture.size = image.size;
    if (state_->backend->keeps_pixels()) {
        Image premultiplied = image;
        premultiply(premultiplied);
        const Result<BackendTexture> made = state_->backend->create_texture(premultiplied, filter);
        if (!made) return made.error();
        texture.backend_texture = *made;
    }
    return state_->textures.insert(std::move(texture));
}

Result<TextureId> Renderer::soft_disc() {
    if (is_valid(state_->soft_disc)) return state_->soft_disc;
    constexpr int kSide = 64;
    Image disc{{kSide, kSide}, {}};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            constexpr float kMiddle = 0.5f * kSide;
            const Vec2 from_middle = {static_cast<float>(x) + 0.5f - kMiddle,
                                      static_cast<float>(y) + 0.5f - kMiddle};
            const float inside = std::max(0.0f, 1 - length(from_middle) / kMiddle);
            const auto alpha = static_cast<std::uint8_t>(255 * inside * inside * (3 - 2 * inside));
            disc.rgba.insert(disc.rgba.end(), {255, 255, 255, alpha});
        }
    const Result<TextureId> made = create_texture(disc);
    if (made) state_->soft_disc = *made;
    return made;
}

Size Renderer::texture_size(TextureId texture) const {
    const Texture* found = state_->textures.find(texture);
    return found ? found->size : Size{};
}

bool Renderer::is_valid(TextureId texture) const {
    return state_->textures.find(texture) != nullptr;
}

void Renderer::destroy_texture(TextureId texture) {
    State& s = *state_;
    const bool is_in_use =
        texture == s.canvas || std::any_of(s.suspended.begin(), s.suspended.end(),
                                           [&](const auto& target) { return target.canvas == texture; });
    if (is_in_use && !texture.is_null()) return s.doomed.push_back(texture);
    s.destroy(texture);
}

void Renderer::State::destroy(TextureId texture) {
    const Texture* found = textures.find(texture);
    if (!found) return;
    batch.flush();
    if (found->backend_texture) backend->destroy_texture(found->backend_texture);
    const auto known = textures_by_source.find(found->source);
    if (known != textures_by_source.end() && known->second == texture) textures_by_source.erase(known);
    textures.erase(texture);
}

const Texture* Renderer::State::find_texture(TextureId texture, std::string_view function) {
    const Texture* found = textures.find(texture);
    if (!found) complain_once("texture", function);
    // A canvas that is being drawn into cannot be looked at.
    return texture == canvas ? nullptr : found;
}

void Renderer::State::complain_once(std::string_view what, std::string_view function) {
    const std::string message = std::string(function) + ": the " + std::string(what) +
                                " handle is null, or what it named was destroyed; nothing is drawn";
    if (complaints.emplace(message, true).second) log(LogLevel::Error, message);
}

// ---- Frame

Size Renderer::logical_size() const {
    return state_->backend->viewport().logical;
}

float Renderer::pixel_scale() const {
    return state_->backend->viewport().scale;
}

void Renderer::begin_frame(Color clear) {
    State& s = *state_;
    s.end_all_canvases();
    s.viewport = s.backend->viewport();
    s.batch.reset_stats();
    s.frames.assign(1, {});
    s.batch.set_blend_mode(BlendMode::Alpha);
    clear.a = 1;
    if (!s.viewport.has_bars()) {
        s.backend->clear(clear);
        s.scissor.reset();
        s.batch.set_scissor(whole(s.viewport.output));
        return;
    }
    s.backend->clear({0, 0, 0, 1});
    set_scissor(std::nullopt);
    fill_rectangle(logical_area(s.viewport), clear);
}

void Renderer::end_frame() {
    State& s = *state_;
    s.end_all_canvases();
    s.batch.flush();
    s.last_frame = s.batch.stats();
    s.frames.assign(1, {});
    s.backend->present();
}

bool Renderer::waits_for_display() const {
    return state_->backend->waits_for_display();
}

Result<Image> Renderer::capture() {
    state_->end_all_canvases();
    state_->batch.flush();
    return state_->backend->read_pixels();
}

const RenderStats& Renderer::stats() const {
    return state_->last_frame;
}

// ---- State

Result<void> Renderer::push_transform() {
    if (transform_depth() >= kMaxTransforms)
        return Error{"the stack of transforms holds " + std::to_string(kMaxTransforms) +
                     " already; is a pop missing?"};
    state_->frames.push_back(state_->frames.back());
    return {};
}

Result<void> Renderer::pop_transform() {
    if (transform_depth() == 0) return Error{"the stack of transforms is empty; there was no push to undo"};
    state_->frames.pop_back();
    return {};
}

int Renderer::transform_depth() const {
    return static_cast<int>(state_->frames.size()) - 1;
}

void Renderer::translate(Vec2 offset) {
    apply_transform(Affine2::translation(offset));
}
void Renderer::rotate(float angle_rad) {
    apply_transform(Affine2::rotation(angle_rad));
}
void Renderer::scale(Vec2 factors) {
    apply_transform(Affine2::scaling(factors));
}

void Renderer::apply_transform(const Affine2& local) {
    Affine2& current = state_->frames.back().to_logical;
    current = current * local;
}

void Renderer::reset_transform() {
    state_->frames.back() = {};
}
Affine2 Renderer::transform() const {
    return state_->frames.back().to_logical;
}

void Renderer::apply_camera(const Camera2D& camera) {
    apply_transform(camera.world_to_screen());
    state_->frames.back().is_y_up = true;
}
bool Renderer::is_y_up() const {
    return state_->frames.back().is_y_up;
}

void Renderer::set_blend_mode(BlendMode mode) {
    state_->batch.set_blend_mode(mode);
}

BlendMode Renderer::blend_mode() const {
    return state_->batch.blend_mode();
}

void Renderer::set_scissor(std::optional<Rect> area) {
    state_->scissor = area;
    // Without an area the bars stay outside, so that a game's picture ends where its logical size ends.
    state_->batch.set_scissor(
        logical_pixels(state_->viewport, area.value_or(logical_area(state_->viewport))));
}
std::optional<Rect> Renderer::scissor() const {
    return state_->scissor;
}

}  // namespace cairn::engine
