#include "render/surface/triangle_bins.h"

namespace cairn::engine {

void TriangleBins::sort(std::span<const FixedPoint> places, std::span<const int> indices,
                        const PixelRect& clip, int bands, BandWorkers& workers) {
    clip_ = clip;
    bands_ = bands;
    parts_ = workers.threads();
    if (bins_.size() < bin(parts_, 0)) bins_.resize(bin(parts_, 0));
    const std::size_t triangles = indices.size() / 3;
    const auto start_of = [&](int part) { return 3 * (triangles * static_cast<std::size_t>(part) / parts_); };
    workers.run(parts_, [&](int part) {
        for (int band = 0; band < bands_; ++band) bins_[bin(part, band)].clear();
        for (std::size_t i = start_of(part); i < start_of(part + 1); i += 3) {
            const Corners corners = {places[indices[i]], places[indices[i + 1]], places[indices[i + 2]]};
            const PixelBox box = pixels_near(corners, clip_);
            if (box.is_empty()) continue;
            const int last = band_of(box.last_row);
            for (int band = band_of(box.first_row); band <= last; ++band)
                bins_[bin(part, band)].push_back(static_cast<int>(i));
        }
    });
}

PixelRect TriangleBins::rows(int band) const {
    PixelRect rows = clip_;
    rows.y = clip_.y + clip_.height * band / bands_;
    rows.height = clip_.y + clip_.height * (band + 1) / bands_ - rows.y;
    return rows;
}

// The last band that does not begin behind the row.
int TriangleBins::band_of(int row) const {
    return ((row - clip_.y + 1) * bands_ - 1) / clip_.height;
}

}  // namespace cairn::engine
