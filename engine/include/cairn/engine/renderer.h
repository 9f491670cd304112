// Draws shapes, images and text into a window, into memory, or nowhere, with one interface and one geometry.
// Invariant: all geometry is made here, in output pixels after the transform, so the back-ends see only
// triangles and the null back-end measures and counts exactly what the others draw.
//
// A frame: begin_frame, drawing, (capture,) end_frame. Coordinates are logical pixels, y down, moved by the
// transform on top of the stack. Edges are anti-aliased by a rim one output pixel wide whose outer vertices
// are transparent. Coordinates that are not finite draw nothing. A null or stale handle draws nothing and
// logs an error once.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/camera.h>
#include <cairn/engine/geometry.h>
#include <cairn/engine/handle.h>
#include <cairn/engine/image.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

class Files;
class RenderBackend;

enum class BlendMode {
    Alpha,     ///< covers by its alpha
    Add,       ///< adds light: sparks, glows
    Multiply,  ///< darkens by its color: shadows, tinted glass
    Screen,    ///< lightens without ever reaching beyond white: fog, soft glows
    Replace,   ///< puts itself in place of what was there, transparency too: holes in canvases
};

/// What is seen between the pixels of a texture that is not drawn pixel by pixel.
enum class TextureFilter {
    Linear,   ///< a mixture: photographs, painted sprites
    Nearest,  ///< the pixels as they are: pixel art
};

enum class LineCap {
    Butt,   ///< ends at the end point
    Round,  ///< ends in a half circle around the end point
};

enum class TextAlign { Left, Center, Right };

struct MeshVertex {
    Vec2 position = {};
    Color color = {};
    Vec2 uv = {};  ///< (0, 0) is the texture's top left, (1, 1) its bottom right; values outside are clamped
};

struct ImageDraw {
    Vec2 position = {};               ///< where the origin lands
    float rotation_rad = 0;           ///< from x towards y: clockwise on a screen with y down
    Vec2 scale = {1, 1};              ///< negative mirrors
    Vec2 origin = {};                 ///< in pixels of the source rectangle, from its top left
    std::optional<Rect> source = {};  ///< in pixels of the image; absent: the whole image
    Color tint = {1, 1, 1, 1};        ///< multiplies the image's colors
};

/// From a character on, text has another color.
struct TextSpan {
    int first = 0;  ///< counted in characters from 0, line ends too
    Color color = {};
};

struct TextDraw {
    /// Top left of the text with TextAlign::Left. Without wrap_width, Center and Right put the middle or the
    /// right end of each line at position.x; with it, the lines are aligned inside position.x .. position.x +
    /// wrap_width.
    Vec2 position = {};
    Color color = {1, 1, 1, 1};
    TextAlign align = TextAlign::Left;
    float wrap_width = 0;    ///< lines are broken at spaces to be no wider than this; 0: only at '\n'
    float line_spacing = 1;  ///< times the font's line height
    std::span<const TextSpan> spans = {};  ///< by `first`; each is multiplied by `color`
    int shown = -1;  ///< only so many characters are drawn, where they will stand; -1: all
};

/// A picture whose corners keep their size, whose sides are stretched along themselves, and whose middle is
/// stretched both ways: frames and buttons of any size.
struct NinePatchDraw {
    Rect area = {};  ///< what the picture fills
    float left = 0;  ///< the borders, in pixels of the source
    float top = 0;
    float right = 0;
    float bottom = 0;
    float scale = 1;  ///< drawing units per pixel of the borders; they shrink where the area is less
    std::optional<Rect> source = {};  ///< in pixels of the image; absent: the whole image
    Color tint = {1, 1, 1, 1};
};

/// The work of the last finished frame.
struct RenderStats {
    int draw_calls = 0;
    int vertices = 0;
    int triangles = 0;
};

/// A texture that is loaded, for tools.
struct TextureInfo {
    std::string path;  ///< empty when it was made in memory
    Size size;
    bool is_canvas = false;
};

class Renderer {
  public:
    /// Platform::create_renderer makes them.
    Renderer(const Files& files, std::unique_ptr<RenderBackend> backend);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // ---- Assets

    /// The same path, filter and color give the same handle. Pixels of the color `transparent` are not seen,
    /// whatever its alpha and theirs. The error names the path and the reason.
    Result<TextureId> load_texture(std::string_view path, TextureFilter filter = TextureFilter::Linear,
                                   std::optional<Color> transparent = std::nullopt);
    /// Reads an image anew; its handles show what the file holds now. False when no texture is of that file.
    /// With an error the old picture stays. Not within a frame.
    Result<bool> reload_texture(std::string_view path);
    Result<TextureId> create_texture(const Image& image, TextureFilter filter = TextureFilter::Linear);
    /// A white disc that fades from its middle to its rim, 64 pixels wide; made when it is first asked for.
    Result<TextureId> soft_disc();
    /// The size in the image's pixels; {0, 0} for a null or stale handle.
    Size texture_size(TextureId texture) const;
    bool is_valid(TextureId texture) const;
    /// A canvas in use stays until the frame ends.
    void destroy_texture(TextureId texture);
    /// All there are, in order of creation as far as places were not used again.
    std::vector<TextureInfo> loaded_textures() const;

    /// A transparent picture to draw into, which then is drawn like any other; its pixels are logical ones.
    Result<TextureId> create_canvas(Size size, TextureFilter filter = TextureFilter::Linear);

    /// The same path and size give the same handle. Size is the height of a line's letters, in logical
    /// pixels, in 4 .. 256.
    Result<FontId> load_font(std::string_view path, float size);
    bool is_valid(FontId font) const;
    /// Images and fonts of files below a folder are read anew when they are loaded the next time. The handles
    /// that there are show what they did.
    void forget_files(std::string_view folder);
    /// From one line's top to the next one's, in logical pixels.
    float line_height(FontId font) const;

    // ---- Frame

    Size logical_size() const;
    /// How many output pixels one logical pixel is wide.
    float pixel_scale() const;
    void begin_frame(Color clear);
    void end_frame();
    /// Whether end_frame waits until the display shows the picture, so that pictures keep its rhythm by
    /// themselves.
    bool waits_for_display() const;
    /// The picture as drawn so far, between begin_frame and end_frame. The null renderer has none: an error.
    Result<Image> capture();
    const RenderStats& stats() const;

    /// From here on drawing goes into the canvas, with a state of its own, until the end_canvas that belongs
    /// to it; with `clear` it loses what was in it. At most 8 deep, and no canvas twice. A canvas does not
    /// show itself: drawing it then draws nothing.
    Result<void> begin_canvas(TextureId canvas, std::optional<Color> clear);
    Result<void> end_canvas();
    /// The canvas in use, or null.
    TextureId current_canvas() const;
    /// Of what is drawn into: the canvas in use, or the picture's logical size.
    Size target_size() const;

    // ---- State; begin_frame resets it

    /// At most 64 deep.
    Result<void> push_transform();
    Result<void> pop_transform();
    int transform_depth() const;
    void translate(Vec2 offset);
    void rotate(float angle_rad);
    void scale(Vec2 factors);
    /// Multiplies the current transform from the right: what is drawn next goes through `local` first.
    void apply_transform(const Affine2& local);
    /// Forgets all transforms of this level of the stack: drawing is in logical pixels again.
    void reset_transform();
    /// From drawing coordinates to logical pixels.
    Affine2 transform() const;

    /// As apply_transform; and from here on y points up, until the transform is reset or the stack is popped.
    void apply_camera(const Camera2D& camera);
    /// What should stand upright has to be put on its head then. A mirror does not change it: mirrored
    /// pictures are meant to be.
    bool is_y_up() const;
    void set_blend_mode(BlendMode mode);
    BlendMode blend_mode() const;
    /// In logical pixels, not moved by the transform; absent: the whole picture.
    void set_scissor(std::optional<Rect> area);
    /// What set_scissor was given last.
    std::optional<Rect> scissor() const;

    // ---- Shapes; widths and radii are in the coordinates of the current transform

    void fill_rectangle(const Rect& rect, Color color);
    void fill_circle(Vec2 center, float radius, Color color);
    void fill_ellipse(Vec2 center, Vec2 radii, Color color);
    /// The slice of a disc that lies between two angles, seen from its center.
    void fill_sector(Vec2 center, float radius, float from_rad, float to_rad, Color color);
    void fill_capsule(Vec2 a, Vec2 b, float radius, Color color);
    /// Either winding; fewer than 3 points draw nothing.
    void fill_convex_polygon(std::span<const Vec2> points, Color color);
    /// uv = uv_from_local applied to each point, as in MeshVertex::uv.
    void fill_convex_polygon(std::span<const Vec2> points, TextureId texture, const Affine2& uv_from_local,
                             Color tint = {});
    /// The same for polygons that may have dents; an error, and nothing drawn, where two sides cross.
    Result<void> fill_polygon(std::span<const Vec2> points, Color color);
    Result<void> fill_polygon(std::span<const Vec2> points, TextureId texture, const Affine2& uv_from_local,
                              Color tint = {});

    /// Outlines lie half inside and half outside of the true edge.
    void outline_rectangle(const Rect& rect, float width, Color color);
    void outline_circle(Vec2 center, float radius, float width, Color color);
    void outline_ellipse(Vec2 center, Vec2 radii, float width, Color color);
    void draw_arc(Vec2 center, float radius, float from_rad, float to_rad, float width, Color color);
    void outline_capsule(Vec2 a, Vec2 b, float radius, float width, Color color);
    void outline_polygon(std::span<const Vec2> points, float width, Color color);
    void draw_polyline(std::span<const Vec2> points, float width, Color color, LineCap cap = LineCap::Round);
    void draw_line(Vec2 a, Vec2 b, float width, Color color, LineCap cap = LineCap::Round);

    /// Plain triangles without anti-aliasing. Every three indices are a triangle; a null texture draws plain
    /// colors. Asserts that the indices lie inside the vertices and that their number is a multiple of 3.
    void draw_mesh(std::span<const MeshVertex> vertices, std::span<const std::uint32_t> indices,
                   TextureId texture = {});

    // ---- Images and text

    void draw_image(TextureId texture, const ImageDraw& draw);
    void draw_nine_patch(TextureId texture, const NinePatchDraw& draw);
    /// UTF-8; a byte that is not, and a character that the font lacks, draw a replacement mark.
    void draw_text(FontId font, std::string_view text, const TextDraw& draw);
    /// The width of the longest line and the height of all lines, the same numbers in every back-end.
    Vec2 measure_text(FontId font, std::string_view text, float wrap_width = 0, float line_spacing = 1) const;
    /// The lines as they are drawn, without the spaces at which they were broken.
    std::vector<std::string> wrap_text(FontId font, std::string_view text, float wrap_width) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace cairn::engine
