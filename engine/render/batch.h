// Collects triangles that share texture, blend mode and scissor, and hands them to the back-end in one call.
// Invariant: triangles reach the back-end in the order in which they were added.
#pragma once

#include <cairn/engine/renderer.h>

#include "render/backend.h"
#include "render/tessellate.h"

namespace cairn::engine {

class Batch {
  public:
    explicit Batch(RenderBackend& backend) : backend_(backend) {}

    /// Where the triangles of the next draw go; a change sends what was collected.
    TriangleList& triangles(BackendTexture texture) { return triangles(texture, blend_); }
    /// The same for a draw that needs another blend mode than the one that is set.
    TriangleList& triangles(BackendTexture texture, BlendMode mode);
    void set_blend_mode(BlendMode mode) { blend_ = mode; }
    void set_scissor(const PixelRect& scissor);
    void flush();
    BlendMode blend_mode() const { return blend_; }
    const PixelRect& scissor() const { return scissor_; }

    /// Counts since reset_stats, without what is not flushed yet.
    const RenderStats& stats() const { return stats_; }
    void reset_stats() { stats_ = {}; }

  private:
    RenderBackend& backend_;
    TriangleList triangles_;
    BackendTexture texture_ = 0;
    BlendMode blend_ = BlendMode::Alpha;
    BlendMode collected_ = BlendMode::Alpha;  ///< of the triangles
    PixelRect scissor_;
    RenderStats stats_;
};

}  // namespace cairn::engine
