// Interpolation of images with subsampled chroma, in vectors: the same bits as
// SubsampledImage::color().
#include "core/image/bilinear.h"
#include "core/image/stored_around.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/image/bilinear_subsampled.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using IntTag = hn::CappedTag<std::int32_t, 16>;
using Ints = hn::Vec<IntTag>;
using IntMask = hn::Mask<IntTag>;
using FloatTag = hn::Rebind<float, IntTag>;
using Floats = hn::Vec<FloatTag>;

HWY_INLINE Ints broadcast(int x) {
    return hn::Set(IntTag(), x);
}

/// Three quarters of chroma in a row and one in another, times four, of three columns.
struct ColumnSums {
    HWY_INLINE ColumnSums(Ints near, Ints far) {
        const Ints bytes = broadcast(0x00ff00ff);  // of the first and the third column
        const auto sum = [](Ints a, Ints b) { return a + a + a + b; };
        const Ints outer = sum(hn::And(near, bytes), hn::And(far, bytes));
        const Ints inner =
            sum(hn::And(hn::ShiftRight<8>(near), bytes), hn::And(hn::ShiftRight<8>(far), bytes));
        first = hn::And(outer, broadcast(0xffff));
        second = hn::And(inner, broadcast(0xffff));
        third = hn::ShiftRight<16>(outer);
    }
    Ints first, second, third;
};

/// Chroma of a pixel and of the one to its right.
struct PixelPair {
    HWY_INLINE PixelPair(const ColumnSums& sums, IntMask is_odd) {
        const auto choose = [&](Ints a, Ints b) { return hn::IfThenElse(is_odd, a, b); };
        const Ints seven = broadcast(7), eight = broadcast(8), middle = broadcast(128);
        const Ints near = choose(sums.first, sums.second);
        const Ints left = sums.first + sums.second + near + near + choose(seven, eight);
        const Ints right = sums.second + sums.second + sums.second +
                           choose(sums.first, sums.third) + choose(eight, seven);
        at[0] = hn::ShiftRight<4>(left) - middle;
        at[1] = hn::ShiftRight<4>(right) - middle;
    }
    Ints at[2];
};

/// Chroma of the pixels of two rows.
struct PixelQuad {
    HWY_INLINE PixelQuad(const std::array<StoredAround::Column, 3>& rows, std::size_t first,
                         IntMask x_is_odd, IntMask y_is_odd)
        : PixelQuad(hn::Load(IntTag(), &rows[0][first]), hn::Load(IntTag(), &rows[1][first]),
                    hn::Load(IntTag(), &rows[2][first]), x_is_odd, y_is_odd) {}

    PixelPair top, bottom;

  private:
    HWY_INLINE PixelQuad(Ints before, Ints next, Ints last, IntMask x_is_odd, IntMask y_is_odd)
        : top(ColumnSums(hn::IfThenElse(y_is_odd, before, next),
                         hn::IfThenElse(y_is_odd, next, before)),
              x_is_odd),
          bottom(ColumnSums(next, last), x_is_odd) {}
};

struct Colors {
    Floats red, green, blue;

    HWY_INLINE Colors operator*(Floats f) const { return {red * f, green * f, blue * f}; }
    HWY_INLINE Colors operator+(const Colors& c) const {
        return {red + c.red, green + c.green, blue + c.blue};
    }
};

HWY_INLINE Colors rgb(Ints luma, Ints cb, Ints cr) {
    using F = YcbcrFactors;
    const auto channel = [&](Ints difference) {
        const Ints byte = luma + hn::ShiftRight<F::bits>(difference + broadcast(F::half));
        const Ints clamped = hn::Min(hn::Max(byte, broadcast(0)), broadcast(255));
        return hn::ConvertTo(FloatTag(), clamped) / hn::Set(FloatTag(), 255.0F);
    };
    return {channel(cr * broadcast(F::red_of_cr)),
            channel(cb * broadcast(F::green_of_cb) + cr * broadcast(F::green_of_cr)),
            channel(cb * broadcast(F::blue_of_cb))};
}

/// Interpolates between two pixels of a row, of which `luma` has both values.
HWY_INLINE Colors between(Ints luma, const PixelPair& cb, const PixelPair& cr, Floats fx) {
    const Ints byte = broadcast(255);
    const Colors left = rgb(hn::And(luma, byte), cb.at[0], cr.at[0]);
    const Colors right = rgb(hn::And(hn::ShiftRight<8>(luma), byte), cb.at[1], cr.at[1]);
    return left * (hn::Set(FloatTag(), 1.0F) - fx) + right * fx;
}

void interpolate(const StoredAround& stored, const BilinearPoints& points, Color* colors) {
    const IntTag tag;
    const auto is_odd = [&](const std::int32_t* numbers) {
        return hn::TestBit(hn::Load(tag, numbers), broadcast(1));
    };
    for (std::size_t i = 0; i < points.count; i += hn::Lanes(tag)) {
        const IntMask x_is_odd = is_odd(&points.x[i]), y_is_odd = is_odd(&points.y[i]);
        const PixelQuad cb(stored.cb, i, x_is_odd, y_is_odd);
        const PixelQuad cr(stored.cr, i, x_is_odd, y_is_odd);
        const Floats fx = hn::Load(FloatTag(), &points.fx[i]);
        const Floats fy = hn::Load(FloatTag(), &points.fy[i]);
        const Colors top = between(hn::Load(tag, &stored.luma[0][i]), cb.top, cr.top, fx);
        const Colors bottom = between(hn::Load(tag, &stored.luma[1][i]), cb.bottom, cr.bottom, fx);
        const Colors color = top * (hn::Set(FloatTag(), 1.0F) - fy) + bottom * fy;
        hn::StoreInterleaved3(color.red, color.green, color.blue, FloatTag(), &colors[i].x);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {
HWY_EXPORT(interpolate);

void interpolate(const SubsampledImage& image, const BilinearPoints& points,
                 BilinearColors& colors) {
    StoredAround stored;
    const AroundPoints around(image, points, stored);
    for (std::size_t i = 0; i < points.count; ++i) around.read(i);
    HWY_DYNAMIC_DISPATCH(interpolate)(stored, points, colors.data());
}

}  // namespace etalon
#endif
