// Colors are kept apart in lanes, one register for the red of several pixels, one for their green, and so on.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/surface/textured_rows.cpp"
#include "render/surface/textured_rows.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cairn::engine {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// More lanes would gain little: most of the time goes into fetching texels, one by one.
constexpr std::size_t kMostLanes = 8;
using D = hn::CappedTag<float, kMostLanes>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(D()));

HWY_INLINE V set(float value) {
    return hn::Set(D(), value);
}

/// Added to a whole number below it, it leaves the number in the low bits. ConvertTo also heeds numbers that
/// are too large for an integer, and takes three times as long.
constexpr float kWholes = 1 << 23;

HWY_INLINE VI to_int(V whole) {
    const VI bits = hn::BitCast(DI(), hn::Add(whole, set(kWholes)));
    return hn::Sub(bits, hn::BitCast(DI(), set(kWholes)));
}

struct Colors {
    V r, g, b, a;
};

/// Bytes r, g, b, a, as they lie in memory.
HWY_INLINE Colors colors_of(VI pixels) {
    static_assert(std::endian::native == std::endian::little);
    const VI low = hn::Set(DI(), 255);
    return {hn::ConvertTo(D(), hn::And(pixels, low)),
            hn::ConvertTo(D(), hn::And(hn::ShiftRight<8>(pixels), low)),
            hn::ConvertTo(D(), hn::And(hn::ShiftRight<16>(pixels), low)),
            hn::ConvertTo(D(), hn::And(hn::ShiftRight<24>(pixels), low))};
}

/// Rounded and clamped.
HWY_INLINE V to_byte(V value) {
    return hn::Floor(hn::Min(hn::Max(hn::Add(value, set(0.5f)), set(0)), set(255)));
}
HWY_INLINE VI pixels_of(const Colors& c) {
    const auto pair = [](V low, V high) HWY_ATTR {
        const V both = hn::Add(to_byte(low), hn::Mul(to_byte(high), set(256)));
        return hn::BitCast(DI(), hn::Add(both, set(kWholes)));
    };
    return hn::Or(hn::And(pair(c.r, c.g), hn::Set(DI(), 0xffff)), hn::ShiftLeft<16>(pair(c.b, c.a)));
}

HWY_INLINE V mixed(V from, V to, V share) {
    return hn::Add(from, hn::Mul(hn::Sub(to, from), share));
}
HWY_INLINE Colors mixed(const Colors& from, const Colors& to, V share) {
    return {mixed(from.r, to.r, share), mixed(from.g, to.g, share), mixed(from.b, to.b, share),
            mixed(from.a, to.a, share)};
}

/// Where texels are fetched.
struct Texels {
    const std::int32_t* first;
    int width;
    V columns;
    V rows;

    explicit HWY_INLINE Texels(const Image& image)
        : first(reinterpret_cast<const std::int32_t*>(image.rgba.data())),
          width(image.size.width),
          columns(set(static_cast<float>(image.size.width))),
          rows(set(static_cast<float>(image.size.height))) {}

    [[nodiscard]] HWY_INLINE VI at(VI x, VI y) const {
        return hn::GatherIndex(DI(), first, hn::Add(hn::Mul(y, hn::Set(DI(), width)), x));
    }
};

/// Two neighbours along an axis, clamped at the edges, and how far it is from the first to the second.
struct Neighbours {
    VI first;
    VI second;
    V share;

    HWY_INLINE Neighbours(V place, V size) {
        const V at = hn::Sub(hn::Mul(hn::Min(hn::Max(place, set(0)), set(1)), size), set(0.5f));
        const V floor = hn::Floor(at);
        share = hn::Sub(at, floor);
        first = to_int(hn::Max(floor, set(0)));
        second = to_int(hn::Min(hn::Add(floor, set(1)), hn::Sub(size, set(1))));
    }
};

HWY_INLINE bool is_nothing(VI texels) {
    return hn::AllTrue(DI(), hn::Eq(texels, hn::Zero(DI())));
}

/// Two by two texels.
struct Square {
    VI t00, t10, t01, t11;

    /// What lies between them; false when they are nothing, with no color.
    HWY_INLINE bool mix(V share_x, V share_y, Colors& colors) const {
        if (is_nothing(hn::Or(hn::Or(t00, t10), hn::Or(t01, t11)))) return false;
        const Colors upper = mixed(colors_of(t00), colors_of(t10), share_x);
        const Colors lower = mixed(colors_of(t01), colors_of(t11), share_x);
        colors = mixed(upper, lower, share_y);
        return true;
    }
};

// Filters are made for a row that begins at some v; `sample` gives what is at some places of it, and is false
// when nothing is at any, with no color.

struct Linear {
    const Texels& texels;

    HWY_INLINE Linear(const Texels& of, float) : texels(of) {}

    HWY_INLINE bool sample(V u, V v, Colors& colors) const {
        const Neighbours x(u, texels.columns);
        const Neighbours y(v, texels.rows);
        return Square{texels.at(x.first, y.first), texels.at(x.second, y.first), texels.at(x.first, y.second),
                      texels.at(x.second, y.second)}
            .mix(x.share, y.share, colors);
    }
};

/// Some of two registers' worth of texels that lie side by side.
struct Choice {
    decltype(hn::IndicesFromVec(DI(), VI())) lanes;
    hn::Mask<DI> is_second;
    bool needs_second;

    /// `along`: how far each is from the first one.
    explicit HWY_INLINE Choice(VI along)
        : lanes(hn::IndicesFromVec(DI(), hn::And(along, hn::Set(DI(), kLanes - 1)))),
          is_second(hn::Gt(along, hn::Set(DI(), kLanes - 1))),
          needs_second(!hn::AllFalse(DI(), is_second)) {}

    [[nodiscard]] HWY_INLINE VI of(const std::int32_t* texels) const {
        const VI first = hn::TableLookupLanes(hn::LoadU(DI(), texels), lanes);
        if (!needs_second) return first;
        return hn::IfThenElse(is_second, hn::TableLookupLanes(hn::LoadU(DI(), texels + kLanes), lanes),
                              first);
    }
};

/// Where v is the same in all of the row, as in pictures that are not turned. If they are not shown smaller
/// than half besides, the texels of neighbours lie close by: to choose from some that are loaded at once
/// takes a fraction of the time that fetching takes.
struct LevelLinear {
    const std::int32_t* upper;
    const std::int32_t* lower;
    int width;
    V columns;
    V share;

    HWY_INLINE LevelLinear(const Texels& texels, float v) : width(texels.width), columns(texels.columns) {
        const Neighbours y(set(v), texels.rows);
        const auto row = [&](VI number) HWY_ATTR {
            return texels.first + static_cast<std::ptrdiff_t>(hn::GetLane(number)) * width;
        };
        upper = row(y.first);
        lower = row(y.second);
        share = y.share;
    }

    HWY_INLINE bool sample(V u, V, Colors& colors) const {
        constexpr int kLoaded = 2 * kLanes;
        const Neighbours x(u, columns);
        const int from = hn::GetLane(x.first);
        const VI along = hn::Sub(x.first, hn::Set(DI(), from));
        const VI gap = hn::Sub(hn::Sub(x.second, x.first), hn::Set(DI(), 1));  // not 0 at the edges
        const VI beyond = hn::And(hn::Or(along, gap), hn::Set(DI(), ~(kLoaded - 1)));
        if (from + kLoaded >= width || !is_nothing(beyond))
            return Square{hn::GatherIndex(DI(), upper, x.first), hn::GatherIndex(DI(), upper, x.second),
                          hn::GatherIndex(DI(), lower, x.first), hn::GatherIndex(DI(), lower, x.second)}
                .mix(x.share, share, colors);
        const Choice choice(along);
        return Square{choice.of(upper + from), choice.of(upper + from + 1), choice.of(lower + from),
                      choice.of(lower + from + 1)}
            .mix(x.share, share, colors);
    }
};

/// The texel that holds a place.
struct Nearest {
    const Texels& texels;

    HWY_INLINE Nearest(const Texels& of, float) : texels(of) {}

    static HWY_INLINE VI index(V place, V size) {
        return to_int(hn::Floor(hn::Min(hn::Max(hn::Mul(place, size), set(0)), hn::Sub(size, set(1)))));
    }
    HWY_INLINE bool sample(V u, V v, Colors& colors) const {
        const VI texel = texels.at(index(u, texels.columns), index(v, texels.rows));
        if (is_nothing(texel)) return false;
        colors = colors_of(texel);
        return true;
    }
};

constexpr float kShare = 1.0f / 255;

/// As for plain colors: see rasterizer.cpp.
template <BlendMode kBlend>
HWY_INLINE Colors blended(const Colors& under, const Colors& c) {
    const V one = set(1);
    const V share = set(kShare);
    const V uncovered = hn::Sub(one, hn::Mul(c.a, share));
    const auto each = [&](const auto& of) HWY_ATTR {
        return Colors{of(under.r, c.r), of(under.g, c.g), of(under.b, c.b), of(under.a, c.a)};
    };
    Colors result = c;
    switch (kBlend) {
        case BlendMode::Alpha:
            return each([&](V u, V x) HWY_ATTR { return hn::Add(x, hn::Mul(u, uncovered)); });
        case BlendMode::Add:
            result = each([&](V u, V x) HWY_ATTR { return hn::Add(u, x); });
            result.a = under.a;
            return result;
        case BlendMode::Multiply:
            result =
                each([&](V u, V x) HWY_ATTR { return hn::Mul(u, hn::Add(hn::Mul(x, share), uncovered)); });
            result.a = under.a;
            return result;
        case BlendMode::Screen:
            return each([&](V u, V x)
                            HWY_ATTR { return hn::Add(x, hn::Mul(u, hn::Sub(one, hn::Mul(x, share)))); });
        case BlendMode::Replace:
            return c;
    }
    return result;
}

template <BlendMode kBlend, class Filter>
void shade_row(const TexturedRow& row, const RowSteps& steps, const Texels& texels) {
    const V lane = hn::ConvertTo(D(), hn::Iota(DI(), 0));
    const Filter filter(texels, row.uv.y);
    for (int x = 0; x < row.count; x += kLanes) {
        const V distance = hn::Add(set(static_cast<float>(x)), lane);
        const auto at = [&](float start, float step)
                            HWY_ATTR { return hn::Add(set(start), hn::Mul(set(step), distance)); };
        Colors texel{set(0), set(0), set(0), set(0)};
        const bool is_something = filter.sample(at(row.uv.x, steps.uv.x), at(row.uv.y, steps.uv.y), texel);
        // Nothing leaves everything as it is, but where it takes its place.
        if (kBlend != BlendMode::Replace && !is_something) continue;
        const auto tinted = [&](std::size_t k, V channel) HWY_ATTR {
            return hn::Mul(at(row.color[k], steps.color[k]), hn::Mul(channel, set(kShare)));
        };
        const Colors color{tinted(0, texel.r), tinted(1, texel.g), tinted(2, texel.b), tinted(3, texel.a)};
        auto* pixels = reinterpret_cast<std::int32_t*>(row.pixels) + x;
        const int left = row.count - x;
        if (left >= kLanes) {
            hn::StoreU(pixels_of(blended<kBlend>(colors_of(hn::LoadU(DI(), pixels)), color)), DI(), pixels);
        } else {
            HWY_ALIGN std::int32_t part[kMostLanes] = {};
            std::copy_n(pixels, left, part);
            hn::Store(pixels_of(blended<kBlend>(colors_of(hn::Load(DI(), part)), color)), DI(), part);
            std::copy_n(part, left, pixels);
        }
    }
}

template <BlendMode kBlend>
void shade_rows_blended(std::span<const TexturedRow> rows, const RowSteps& steps, const Paint& paint) {
    const Texels texels(*paint.texture);
    const auto shade = [&]<class Filter>() {
        for (const TexturedRow& row : rows) shade_row<kBlend, Filter>(row, steps, texels);
    };
    if (paint.filter == TextureFilter::Nearest) return shade.template operator()<Nearest>();
    if (steps.uv.y == 0) return shade.template operator()<LevelLinear>();
    shade.template operator()<Linear>();
}

void shade_rows(std::span<const TexturedRow> rows, const RowSteps& steps, const Paint& paint) {
    switch (paint.blend) {
        case BlendMode::Alpha:
            return shade_rows_blended<BlendMode::Alpha>(rows, steps, paint);
        case BlendMode::Add:
            return shade_rows_blended<BlendMode::Add>(rows, steps, paint);
        case BlendMode::Multiply:
            return shade_rows_blended<BlendMode::Multiply>(rows, steps, paint);
        case BlendMode::Screen:
            return shade_rows_blended<BlendMode::Screen>(rows, steps, paint);
        case BlendMode::Replace:
            return shade_rows_blended<BlendMode::Replace>(rows, steps, paint);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::engine
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::engine {

HWY_EXPORT(shade_rows);

void shade_textured_rows(std::span<const TexturedRow> rows, const RowSteps& steps, const Paint& paint) {
    HWY_DYNAMIC_DISPATCH(shade_rows)(rows, steps, paint);
}

}  // namespace cairn::engine
#endif
