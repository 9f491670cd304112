// Text. Invariant: lines are broken and aligned with the font's nominal measures; only the letters' pictures
// depend on the output's scale. They are made at the size in which they appear, so that text is sharp at any
// zoom.
#include <algorithm>
#include <array>
#include <cmath>

#include <cairn/engine/renderer.h>
#include <cairn/engine/utf8.h>

#include "render/renderer_state.h"
#include "render/text_layout.h"

namespace cairn::engine {
namespace {

float aligned_start(const TextLine& line, const TextDraw& draw) {
    const float room = draw.wrap_width > 0 ? draw.wrap_width : 0;
    switch (draw.align) {
        case TextAlign::Left:
            return 0;
        case TextAlign::Center:
            return 0.5f * (room - line.width);
        case TextAlign::Right:
            return room - line.width;
    }
    return 0;
}

/// Whether the map neither turns nor mirrors nor distorts, so that letters can be put on whole pixels.
bool is_upright(const Affine2& map) {
    return map.b == 0 && map.c == 0 && map.a > 0 && map.a == map.d;
}

/// Of a character in a text with spans.
Color span_color(const TextDraw& draw, int index) {
    const auto behind = std::upper_bound(draw.spans.begin(), draw.spans.end(), index,
                                         [](int i, const TextSpan& span) { return i < span.first; });
    if (behind == draw.spans.begin()) return draw.color;
    const Color& c = (behind - 1)->color;
    return {c.r * draw.color.r, c.g * draw.color.g, c.b * draw.color.b, c.a * draw.color.a};
}

}  // namespace

Result<FontId> Renderer::load_font(std::string_view path, float size) {
    return state_->fonts.load(state_->files, path, size);
}

bool Renderer::is_valid(FontId font) const {
    return state_->fonts.is_valid(font);
}

float Renderer::line_height(FontId font) const {
    const FontFace* face = state_->fonts.nominal(font);
    return face ? static_cast<float>(face->line_height()) : 0;
}

Vec2 Renderer::measure_text(FontId font, std::string_view text, float wrap_width, float line_spacing) const {
    const FontFace* face = state_->fonts.nominal(font);
    if (!face || text.empty()) return {};
    const std::vector<TextLine> lines = layout_text(*face, text, wrap_width);
    float width = 0;
    for (const TextLine& line : lines) width = std::max(width, line.width);
    const auto between = static_cast<float>(lines.size() - 1) * line_spacing;
    return {width, (between + 1) * static_cast<float>(face->line_height())};
}

std::vector<std::string> Renderer::wrap_text(FontId font, std::string_view text, float wrap_width) const {
    std::vector<std::string> wrapped;
    const FontFace* face = state_->fonts.nominal(font);
    if (!face) return wrapped;
    std::vector<std::size_t> starts;  // in bytes, by character
    for (std::string_view rest = text; !rest.empty(); take_character(rest))
        starts.push_back(text.size() - rest.size());
    starts.push_back(text.size());
    for (const TextLine& line : layout_text(*face, text, wrap_width)) {
        if (line.characters.empty()) {
            wrapped.emplace_back();
            continue;
        }
        const std::size_t begin = starts[static_cast<std::size_t>(line.characters.front().index)];
        const std::size_t end = starts[static_cast<std::size_t>(line.characters.back().index) + 1];
        wrapped.emplace_back(text.substr(begin, end - begin));
    }
    return wrapped;
}

void Renderer::draw_text(FontId font, std::string_view text, const TextDraw& draw) {
    State& s = *state_;
    const FontFace* nominal = s.fonts.nominal(font);
    if (!nominal) {
        s.complain_once("font", "draw_text");
        return;
    }
    const Affine2 map = s.output_transform();
    const int nominal_pixels = s.fonts.nominal_pixels(font);
    const float wanted = static_cast<float>(nominal_pixels) * map.mean_scale();
    if (!(wanted > 0) || !std::isfinite(wanted)) return;
    const int pixels = std::clamp(static_cast<int>(std::lround(std::min(wanted, 1e6f))),
                                  FontStore::kMinPixels, FontStore::kMaxPixels);
    const FontFace* face = s.fonts.at_pixels(font, pixels);
    if (!face) return;

    // A letter's picture is drawn pixel by pixel where that is possible, and scaled where it is not.
    const bool snapped = is_upright(map) && std::fabs(wanted - static_cast<float>(pixels)) < 0.5f;
    const float picture_scale = static_cast<float>(nominal_pixels) / static_cast<float>(pixels);
    const bool replaces = s.batch.blend_mode() == BlendMode::Replace;
    // Letters are coverage: they replace by that share, where shapes do; and lie on top in a canvas else.
    const auto ink = [&](Color color) {
        const bool keeps_alpha = s.canvas.is_null() || color.a >= 1;
        if (replaces && keeps_alpha) color = {color.r * color.a, color.g * color.a, color.b * color.a, 1};
        return to_rgba8(color);
    };
    const BlendMode mode = replaces ? BlendMode::Alpha : s.batch.blend_mode();
    const Rgba8 plain = ink(draw.color);

    const std::vector<TextLine> lines = layout_text(*nominal, text, draw.wrap_width);
    float baseline = draw.position.y + static_cast<float>(nominal->ascent());
    for (const TextLine& line : lines) {
        const float start = draw.position.x + aligned_start(line, draw);
        for (const PlacedCharacter& placed : line.characters) {
            if (draw.shown >= 0 && placed.index >= draw.shown) continue;
            const Rgba8 color = draw.spans.empty() ? plain : ink(span_color(draw, placed.index));
            const std::optional<GlyphCache::Entry> glyph =
                s.glyphs.find(font, pixels, *face, placed.character);
            if (!glyph || glyph->size.width == 0) continue;
            const Vec2 pen = {start + placed.x, baseline};
            const Vec2 offset = {static_cast<float>(glyph->left),
                                 static_cast<float>(glyph->top - face->ascent())};
            const Vec2 size = {static_cast<float>(glyph->size.width), static_cast<float>(glyph->size.height)};
            Vec2 corner;
            Vec2 x_axis;
            Vec2 y_axis;
            if (snapped) {
                const Vec2 exact = map.apply(pen);
                corner = Vec2{std::round(exact.x), std::round(exact.y)} + offset;
                x_axis = {size.x, 0};
                y_axis = {0, size.y};
            } else {
                corner = map.apply(pen + offset * picture_scale);
                x_axis = map.apply_vector({size.x * picture_scale, 0});
                y_axis = map.apply_vector({0, size.y * picture_scale});
            }
            std::array corners = {corner, corner + x_axis, corner + x_axis + y_axis, corner + y_axis};
            if (!s.prepare(corners, 0)) continue;

            TriangleList& out = s.batch.triangles(glyph->texture, mode);
            const Rect& uv = glyph->uv;
            const int first = out.add({corners[0], color, {uv.x, uv.y}});
            out.add({corners[1], color, {uv.x + uv.width, uv.y}});
            out.add({corners[2], color, {uv.x + uv.width, uv.y + uv.height}});
            out.add({corners[3], color, {uv.x, uv.y + uv.height}});
            out.add_quad(first, first + 1, first + 2, first + 3);
        }
        baseline += draw.line_spacing * static_cast<float>(nominal->line_height());
    }
}

}  // namespace cairn::engine
