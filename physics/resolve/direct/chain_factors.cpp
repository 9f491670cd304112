// The two recursions and where they meet. Glossary: S block of the diagonal less what was eliminated, O block
// beside it.
#include "resolve/direct/chain_factors.h"

#include "resolve/direct/numbers.h"

namespace cairn::physics {

void ChainFactors::resize(int blocks) {
    size_ = blocks;
    for (std::vector<double>* values : {&xx, &xy, &yy, &a, &b, &c, &d}) values->resize(at(blocks));
    pivots_.resize(at(blocks));
}

ChainFactors::Rest ChainFactors::rest(int block) const {
    return {xx[at(block)], xy[at(block)], yy[at(block)]};
}

void ChainFactors::invert(Pivot& p, const Rest& s) {
    p.by_x = 1 / s.xx;
    p.l = s.xy * p.by_x;
    p.by_y = 1 / (s.yy - p.l * s.xy);
}

void ChainFactors::factor() {
    if (size_ == 0) return;
    // S of the next block: its diagonal less O^T S^-1 O, with O = [o00 o01; o10 o11].
    const auto eliminate = [](Pivot& p, Rest& s, double o00, double o01, double o10, double o11, Rest next) {
        invert(p, s);
        const double y10 = o10 - p.l * o00;
        const double y11 = o11 - p.l * o01;
        const double z00 = o00 * p.by_x;
        const double z01 = o01 * p.by_x;
        p.yx = y10 * p.by_y;
        p.yy = y11 * p.by_y;
        p.xx = z00 - p.l * p.yx;
        p.xy = z01 - p.l * p.yy;
        s.xx = next.xx - (o00 * z00 + y10 * p.yx);
        s.xy = next.xy - (o00 * z01 + y10 * p.yy);
        s.yy = next.yy - (o01 * z01 + y11 * p.yy);
    };
    const int middle = size_ / 2;
    int low = 0;
    int high = size_ - 1;
    Rest from_low = rest(low);
    Rest from_high = rest(high);
    const auto rise = [&] {
        const std::size_t i = at(low);
        eliminate(pivots_[i], from_low, a[i], b[i], c[i], d[i], rest(++low));
    };
    const auto fall = [&] {
        const std::size_t i = at(high - 1);
        eliminate(pivots_[i + 1], from_high, a[i], c[i], b[i], d[i], rest(--high));
    };
    while (high > middle) {
        rise();
        fall();
    }
    if (low < middle) rise();
    // Both have left their parts of the middle.
    const Rest whole = rest(middle);
    const Rest both{from_low.xx + (from_high.xx - whole.xx), from_low.xy + (from_high.xy - whole.xy),
                    from_low.yy + (from_high.yy - whole.yy)};
    invert(pivots_[at(middle)], both);
}

void ChainFactors::solve(double* x, double* y) const {
    if (size_ == 0) return;
    const int middle = size_ / 2;
    const auto pass_on = [&](int from, int to) {
        const Pivot& p = pivots_[at(from)];
        x[to] -= p.xx * x[from] + p.yx * y[from];
        y[to] -= p.xy * x[from] + p.yy * y[from];
    };
    int low = 0;
    int high = size_ - 1;
    for (; high > middle; ++low, --high) {
        pass_on(low, low + 1);
        pass_on(high, high - 1);
    }
    if (low < middle) pass_on(low, low + 1);
    for (int i = 0; i < size_; ++i) {
        const Pivot& p = pivots_[at(i)];
        const double last = (y[i] - p.l * x[i]) * p.by_y;
        x[i] = x[i] * p.by_x - p.l * last;
        y[i] = last;
    }
    const auto take_back = [&](int from, int to) {
        const Pivot& p = pivots_[at(to)];
        x[to] -= p.xx * x[from] + p.xy * y[from];
        y[to] -= p.yx * x[from] + p.yy * y[from];
    };
    low = high = middle;
    if (size_ % 2 == 0) {
        take_back(low, low - 1);
        --low;
    }
    for (; low > 0; --low, ++high) {
        take_back(low, low - 1);
        take_back(high, high + 1);
    }
}

}  // namespace cairn::physics
