// Sorts the triangles of a draw call into bands of rows, which threads can then draw side by side.
// Invariant: a band holds each triangle that may cover one of its pixels, in the order of the call.
#pragma once

#include <span>
#include <vector>

#include "render/surface/band_workers.h"
#include "render/surface/triangle_spans.h"

namespace cairn::engine {

class TriangleBins {
  public:
    /// `places` are those of the vertices, `indices` name three for each triangle.
    void sort(std::span<const FixedPoint> places, std::span<const int> indices, const PixelRect& clip,
              int bands, BandWorkers& workers);

    /// The rows of a band.
    [[nodiscard]] PixelRect rows(int band) const;

    /// Calls `use(i)` for each triangle of a band, i being where its indices start.
    template <class Use>
    void for_each(int band, const Use& use) const {
        for (int part = 0; part < parts_; ++part)
            for (const int triangle : bins_[bin(part, band)]) use(static_cast<std::size_t>(triangle));
    }

  private:
    [[nodiscard]] std::size_t bin(int part, int band) const {
        return static_cast<std::size_t>(part * bands_ + band);
    }
    [[nodiscard]] int band_of(int row) const;

    PixelRect clip_;
    int bands_ = 0;
    int parts_ = 0;                       ///< of the triangles, which are sorted side by side
    std::vector<std::vector<int>> bins_;  ///< by part, then by band; kept for the next call
};

}  // namespace cairn::engine
