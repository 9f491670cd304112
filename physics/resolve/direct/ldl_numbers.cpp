// The passes over a sparse L D L^T, with whatever SIMD there is: lanes are rows of a strip.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/direct/ldl_numbers.cpp"
#include "resolve/direct/ldl_numbers.h"

#include <array>
#include <cstddef>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Column = LdlNumbers::Column;
using Strip = LdlNumbers::Strip;
using Update = LdlNumbers::Update;

using D = hn::CappedTag<double, kStripRows>;
using V = hn::Vec<D>;
inline constexpr std::size_t kLanes = hn::MaxLanes(D());  // that one register holds
inline constexpr std::size_t kRegisters = kStripRows / kLanes;

HWY_INLINE std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

// A column of a strip.
struct Four {
    std::array<V, kRegisters> part;
};

template <class Of>
HWY_INLINE Four four(const Of& of) {
    Four result;
    for (std::size_t i = 0; i < kRegisters; ++i) result.part[i] = of(i);
    return result;
}
HWY_INLINE Four load(const double* from) {
    return four([=](std::size_t i) HWY_ATTR { return hn::LoadU(D(), from + i * kLanes); });
}
HWY_INLINE void store(const Four& four, double* to) {
    for (std::size_t i = 0; i < kRegisters; ++i) hn::StoreU(four.part[i], D(), to + i * kLanes);
}
HWY_INLINE Four all(double x) {
    return four([=](std::size_t) HWY_ATTR { return hn::Set(D(), x); });
}
HWY_INLINE Four operator*(const Four& a, const Four& b) {
    return four([&](std::size_t i) HWY_ATTR { return hn::Mul(a.part[i], b.part[i]); });
}
HWY_INLINE Four operator+(const Four& a, const Four& b) {
    return four([&](std::size_t i) HWY_ATTR { return hn::Add(a.part[i], b.part[i]); });
}
HWY_INLINE Four operator-(const Four& a, const Four& b) {
    return four([&](std::size_t i) HWY_ATTR { return hn::Sub(a.part[i], b.part[i]); });
}
// Those that are two apart first, at every level.
HWY_INLINE double sum(const Four& x) {
#if HWY_TARGET == HWY_SCALAR
    const auto number = [&](std::size_t i) HWY_ATTR { return hn::GetLane(x.part[i]); };
    return (number(0) + number(2)) + (number(1) + number(3));
#else
#if HWY_MAX_BYTES >= 32
    const hn::Half<D> half;
    const auto two = hn::Add(hn::LowerHalf(half, x.part[0]), hn::UpperHalf(half, x.part[0]));
#else
    const auto two = hn::Add(x.part[0], x.part[1]);
#endif
    return hn::GetLane(two) + hn::ExtractLane(two, 1);
#endif
}

// Calls work(size) with the size as a constant.
template <class Work>
HWY_INLINE void with_size(int size, const Work& work) {
    switch (size) {
        case 1:
            return work(std::integral_constant<int, 1>{});
        case 2:
            return work(std::integral_constant<int, 2>{});
        case 3:
            return work(std::integral_constant<int, 3>{});
        case 4:
            return work(std::integral_constant<int, 4>{});
        case 5:
            return work(std::integral_constant<int, 5>{});
        case 6:
            return work(std::integral_constant<int, 6>{});
        case 7:
            return work(std::integral_constant<int, 7>{});
        default:
            return work(std::integral_constant<int, 8>{});
    }
}

// The same where it is that of most nodes: of pins, bodies and contacts.
template <class Work>
HWY_INLINE void with_usual(int size, const Work& work) {
    if (size == 3) return work(std::integral_constant<int, 3>{});
    if (size == 2) return work(std::integral_constant<int, 2>{});
    work(size);
}

// Where a number stands in the strips of a block of so many columns.
HWY_INLINE constexpr int place(int row, int column, int columns) {
    return row / kStripRows * kStripRows * columns + column * kStripRows + row % kStripRows;
}

template <int N>
using Dense = std::array<std::array<double, N>, N>;  // by rows

// The pivots of a block on the diagonal: L below, 1/D on the diagonal.
template <int N>
HWY_INLINE Dense<N> factor_dense(const double* block) {
    Dense<N> a;
    std::array<double, N> scaled{};  // L D of the row in work
    for (int i = 0; i < N; ++i) {
        double pivot = block[place(i, i, N)];
        for (int j = 0; j < i; ++j) {
            double rest = block[place(i, j, N)];
            for (int k = 0; k < j; ++k) rest -= scaled[index(k)] * a[index(j)][index(k)];
            scaled[index(j)] = rest;
            a[index(i)][index(j)] = rest * a[index(j)][index(j)];
            pivot -= a[index(i)][index(j)] * rest;
        }
        a[index(i)][index(i)] = 1 / pivot;
    }
    return a;
}

// b := A^-1 b, of numbers or of many at once; a(row, column) is what factor_dense left.
template <int N, class T, class Factors>
HWY_INLINE void solve_dense(const Factors& a, std::array<T, N>& b) {
    for (int i = 1; i < N; ++i) {
        for (int j = 0; j < i; ++j) b[index(i)] = b[index(i)] - b[index(j)] * a(i, j);
    }
    for (int i = 0; i < N; ++i) b[index(i)] = b[index(i)] * a(i, i);
    for (int i = N - 2; i >= 0; --i) {
        for (int j = i + 1; j < N; ++j) b[index(i)] = b[index(i)] - b[index(j)] * a(j, i);
    }
}

// c -= a b^T, with strips c and a, and a block b of N rows.
template <int N, class Inner>
HWY_INLINE void subtract(double* c, const double* a, const double* b, Inner inner) {
    for (int j = 0; j < N; ++j) {
        Four product = load(a) * all(b[place(j, 0, inner)]);
        for (int k = 1; k < inner; ++k)
            product = product + load(a + k * kStripRows) * all(b[place(j, k, inner)]);
        store(load(c + j * kStripRows) - product, c + j * kStripRows);
    }
}

template <int N>
void factor_column(LdlNumbers& n, const Column& column) {
    double* const values = n.values.data();
    double* const scaled = n.scaled.data();
    const double* const source = n.source.data();
    for (int i = column.diagonal; i < column.end; i += kStripRows) store(load(source + i), values + i);
    const Update* const last = n.updates.data() + column.last_update;
    for (const Update* u = n.updates.data() + column.first_update; u != last; ++u) {
        with_usual(u->inner, [&](auto inner) HWY_ATTR {
            subtract<N>(values + u->target, values + u->left, scaled + u->right, inner);
        });
    }
    const Dense<N> pivots = factor_dense<N>(values + column.diagonal);
    for (int i = 0; i < N; ++i) {
        for (int j = 0; j <= i; ++j) values[column.diagonal + place(i, j, N)] = pivots[index(i)][index(j)];
    }
    for (int strip = column.below; strip < column.end; strip += N * kStripRows) {
        std::array<Four, N> l;
        for (int k = 0; k < N; ++k) {
            l[index(k)] = load(values + strip + k * kStripRows);
            store(l[index(k)], scaled + strip + k * kStripRows);
        }
        solve_dense<N>([&](int i, int j) HWY_ATTR { return all(pivots[index(i)][index(j)]); }, l);
        for (int k = 0; k < N; ++k) store(l[index(k)], values + strip + k * kStripRows);
    }
}

// The strips of a column.
struct Below {
    const Strip* first;
    const Strip* last;
    const double* values;
};

// Of the later unknowns, what the column leaves of them.
template <int N>
HWY_INLINE void forward(const Below& below, const double* from, double* x) {
    std::array<Four, N> unknowns;
    for (int k = 0; k < N; ++k) unknowns[index(k)] = all(from[k]);
    const double* l = below.values;
    for (const Strip* strip = below.first; strip != below.last; ++strip, l += N * kStripRows) {
        Four product = load(l) * unknowns[0];
        for (int k = 1; k < N; ++k) product = product + load(l + k * kStripRows) * unknowns[index(k)];
        double* const to = x + strip->offset;
        store(load(to) - product, to);
    }
}

template <int N>
HWY_INLINE void backward(const Below& below, const double* diagonal, double* to, const double* x) {
    std::array<double, N> unknowns;
    for (int k = 0; k < N; ++k) unknowns[index(k)] = to[k];
    solve_dense<N>([=](int i, int j) { return diagonal[place(i, j, N)]; }, unknowns);
    std::array<Four, N> products;
    for (Four& product : products) product = all(0);
    const double* l = below.values;
    for (const Strip* strip = below.first; strip != below.last; ++strip, l += N * kStripRows) {
        const Four from = load(x + strip->offset);
        for (int k = 0; k < N; ++k) products[index(k)] = products[index(k)] + load(l + k * kStripRows) * from;
    }
    for (int k = 0; k < N; ++k) to[k] = unknowns[index(k)] - sum(products[index(k)]);
}

void factor_changed(LdlNumbers& n) {
    for (std::size_t c = 0; c < n.columns.size(); ++c) {
        if (n.changed[c] == 0) continue;
        n.changed[c] = 0;
        const Column& column = n.columns[c];
        with_size(column.size, [&](auto size) HWY_ATTR { factor_column<size>(n, column); });
        if (column.parent >= 0) n.changed[index(column.parent)] = 1;
    }
}

void solve_all(const LdlNumbers& n, double* x) {
    const Column* const first = n.columns.data();
    const Column* const last = first + n.columns.size();
    const Strip* const strips = n.strips.data();
    const double* const values = n.values.data();
    const auto below = [=](const Column& column) HWY_ATTR {
        return Below{strips + column.first_strip, strips + column.last_strip, values + column.below};
    };
    for (const Column* c = first; c != last; ++c) {
        with_size(c->size, [=](auto size) HWY_ATTR { forward<size>(below(*c), x + c->offset, x); });
    }
    for (const Column* c = last; c-- != first;) {
        with_size(c->size, [=](auto size) HWY_ATTR {
            backward<size>(below(*c), values + c->diagonal, x + c->offset, x);
        });
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(factor_changed);
HWY_EXPORT(solve_all);

void LdlNumbers::resize(int count) {
    source.assign(static_cast<std::size_t>(count), 0);
    values.assign(static_cast<std::size_t>(count), 0);
    scaled.assign(static_cast<std::size_t>(count), 0);
    changed.assign(columns.size(), 1);
}

void factor(LdlNumbers& numbers) {
    HWY_DYNAMIC_DISPATCH(factor_changed)(numbers);
}
void solve(const LdlNumbers& numbers, double* x) {
    HWY_DYNAMIC_DISPATCH(solve_all)(numbers, x);
}

}  // namespace cairn::physics
#endif
