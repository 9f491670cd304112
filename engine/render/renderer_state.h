// What a Renderer consists of. The functions that draw are spread over renderer*.cpp by what they draw.
// Invariant: frames.back() is what is drawn in.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/renderer.h>

#include "base/handle_table.h"
#include "render/backend.h"
#include "render/batch.h"
#include "render/font_store.h"
#include "render/glyph_cache.h"

namespace cairn::engine {

/// What a texture is made from.
struct TextureSource {
    std::string path;  ///< empty when it was made from an image in memory
    TextureFilter filter = TextureFilter::Linear;
    /// Red, green and blue of the pixels that are not seen.
    std::optional<std::array<std::uint8_t, 3>> transparent = std::nullopt;

    friend auto operator<=>(const TextureSource&, const TextureSource&) = default;
};

struct Texture {
    BackendTexture backend_texture = 0;  ///< 0 when the back-end keeps no pixels
    Size size;
    TextureSource source;
    bool is_canvas = false;
};

/// A level of the stack of transforms.
struct DrawingFrame {
    Affine2 to_logical;  ///< from drawing coordinates to logical pixels
    bool is_y_up = false;
};

/// Where drawing went before a canvas was begun, and how.
struct SuspendedTarget {
    TextureId canvas;  ///< null: the output
    Viewport viewport;
    std::vector<DrawingFrame> frames;
    BlendMode blend;
    std::optional<Rect> scissor;
};

struct Renderer::State {
    State(const Files& files_to_read, std::unique_ptr<RenderBackend> chosen);

    /// Not yet among `textures`.
    Result<Texture> read_texture(const TextureSource& source);

    /// Drawing coordinates to output pixels.
    Affine2 output_transform() const { return viewport.output_from_logical() * frames.back().to_logical; }

    /// Makes the points fit to be drawn: false when one is not finite, or when all lie outside of the picture
    /// by more than `margin` pixels. Points that are far outside are pulled to where the back-ends can still
    /// compute.
    bool prepare(std::span<Vec2> output_points, float margin) const;

    /// Like textures.find, but says once which function was given a handle that names nothing.
    const Texture* find_texture(TextureId texture, std::string_view function);
    void complain_once(std::string_view what, std::string_view function);

    /// Ends every canvas that a frame has left open, and destroys those that were to go.
    void end_all_canvases();
    void destroy(TextureId texture);

    /// A brush and the blend mode to draw with, so that edges mix by coverage in the mode that is set.
    struct Paint {
        Brush brush;
        BlendMode mode;
    };
    Paint paint_for(const Brush& brush, BackendTexture texture) const;

    void fill(std::vector<Vec2> output_points, const Brush& brush, BackendTexture texture);
    Result<void> fill_dented(std::span<const Vec2> points, const Brush& brush, BackendTexture texture);
    void outline(std::vector<Vec2> output_points, bool closed, float width, LineCap cap, Color color);

    const Files& files;
    std::unique_ptr<RenderBackend> backend;
    Viewport viewport;
    std::vector<DrawingFrame> frames = {DrawingFrame{}};

    HandleTable<TextureId, Texture> textures;
    std::map<TextureSource, TextureId> textures_by_source;
    TextureId soft_disc;
    FontStore fonts;

    Batch batch;
    GlyphCache glyphs;
    std::optional<Rect> scissor;
    TextureId canvas;  ///< in use; null: the output
    std::vector<SuspendedTarget> suspended;
    std::vector<TextureId> doomed;  ///< destroyed while in use
    RenderStats last_frame;
    std::map<std::string, bool, std::less<>> complaints;
};

}  // namespace cairn::engine
