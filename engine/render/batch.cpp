// The collector of triangles. Invariant: flush leaves it empty, with its memory kept for the next batch.
#include "render/batch.h"

namespace cairn::engine {

TriangleList& Batch::triangles(BackendTexture texture, BlendMode mode) {
    if (texture != texture_ || mode != collected_) {
        flush();
        texture_ = texture;
        collected_ = mode;
    }
    return triangles_;
}

void Batch::set_scissor(const PixelRect& scissor) {
    if (scissor == scissor_) return;
    flush();
    scissor_ = scissor;
}

void Batch::flush() {
    const bool visible = scissor_.width > 0 && scissor_.height > 0;
    if (!triangles_.indices.empty() && visible) {
        backend_.draw(triangles_.vertices, triangles_.indices, texture_, collected_, scissor_);
        ++stats_.draw_calls;
        stats_.vertices += static_cast<int>(triangles_.vertices.size());
        stats_.triangles += static_cast<int>(triangles_.indices.size() / 3);
    }
    triangles_.clear();
}

}  // namespace cairn::engine
