// Images and nine-patches. Invariant: an image drawn at whole pixels, without rotation and in its own size,
// is shown pixel by pixel.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <cairn/engine/renderer.h>

#include "render/renderer_state.h"

namespace cairn::engine {

std::vector<TextureInfo> Renderer::loaded_textures() const {
    std::vector<TextureInfo> list;
    state_->textures.for_each([&](TextureId, const Texture& texture) {
        list.push_back({texture.source.path, texture.size, texture.is_canvas});
    });
    return list;
}

void Renderer::draw_image(TextureId texture, const ImageDraw& draw) {
    const Texture* found = state_->find_texture(texture, "draw_image");
    if (!found) return;
    const auto image_width = static_cast<float>(found->size.width);
    const auto image_height = static_cast<float>(found->size.height);
    const Rect source = draw.source.value_or(Rect{0, 0, image_width, image_height});
    if (!(source.width > 0 && source.height > 0)) return;

    // From the source rectangle's pixels, counted from its top left, to output pixels.
    const Affine2 placed = Affine2::translation(draw.position) * Affine2::rotation(draw.rotation_rad) *
                           Affine2::scaling(draw.scale) * Affine2::translation(-draw.origin);
    const Affine2 output_from_source = state_->output_transform() * placed;
    std::vector<Vec2> corners = {
        {0, 0}, {source.width, 0}, {source.width, source.height}, {0, source.height}};
    for (Vec2& corner : corners) corner = output_from_source.apply(corner);

    const Affine2 uv_from_image = Affine2::scaling({1 / image_width, 1 / image_height});
    const Affine2 uv_from_source = uv_from_image * Affine2::translation({source.x, source.y});
    // Half a texel inside the source rectangle the linear filter does not see what lies beside it; the
    // nearest one must only not step over the edge.
    const float inset = found->source.filter == TextureFilter::Nearest ? 1.0f / 64 : 0.5f;
    const Vec2 margin = {std::min(inset, 0.5f * source.width), std::min(inset, 0.5f * source.height)};
    const Vec2 low = uv_from_source.apply(margin);
    const Vec2 size = uv_from_image.apply_vector({source.width - 2 * margin.x, source.height - 2 * margin.y});
    const Rect bounds = {std::clamp(low.x, 0.0f, 1.0f), std::clamp(low.y, 0.0f, 1.0f),
                         std::clamp(size.x, 0.0f, 1.0f - std::clamp(low.x, 0.0f, 1.0f)),
                         std::clamp(size.y, 0.0f, 1.0f - std::clamp(low.y, 0.0f, 1.0f))};
    state_->fill(std::move(corners), Brush(draw.tint, uv_from_source * output_from_source.inverse(), bounds),
                 found->backend_texture);
}

void Renderer::draw_nine_patch(TextureId texture, const NinePatchDraw& draw) {
    const Texture* found = state_->find_texture(texture, "draw_nine_patch");
    if (!found) return;
    const auto image_width = static_cast<float>(found->size.width);
    const auto image_height = static_cast<float>(found->size.height);
    const Rect source = draw.source.value_or(Rect{0, 0, image_width, image_height});
    const Rect& area = draw.area;
    if (!(source.width > 0 && source.height > 0 && area.width > 0 && area.height > 0)) return;

    // Four cuts each way; borders that do not fit share what there is.
    const auto cuts = [&](float start, float length, float near, float far) {
        const float fit = near + far > length ? length / (near + far) : 1;
        return std::array{start, start + near * fit, start + length - far * fit, start + length};
    };
    const auto xs = cuts(area.x, area.width, draw.left * draw.scale, draw.right * draw.scale);
    const auto ys = cuts(area.y, area.height, draw.top * draw.scale, draw.bottom * draw.scale);
    const auto us = cuts(source.x, source.width, draw.left, draw.right);
    const auto vs = cuts(source.y, source.height, draw.top, draw.bottom);

    const Affine2 map = state_->output_transform();
    std::array<Vec2, 16> points;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = map.apply({xs[i % 4], ys[i / 4]});
    if (!state_->prepare(points, 0)) return;
    const Rgba8 color = to_rgba8(draw.tint);
    TriangleList& out = state_->batch.triangles(found->backend_texture);
    const auto unit = [](float v) { return std::clamp(v, 0.0f, 1.0f); };
    const int first = static_cast<int>(out.vertices.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        out.add({points[i], color, {unit(us[i % 4] / image_width), unit(vs[i / 4] / image_height)}});
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const int corner = first + 4 * row + column;
            out.add_quad(corner, corner + 1, corner + 5, corner + 4);
        }
}

}  // namespace cairn::engine
