#include "core/texture/gradient_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/texture/gradient_noise.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

#ifndef ETALON_GRADIENT_NOISE_ONCE
#define ETALON_GRADIENT_NOISE_ONCE
namespace etalon {
namespace {

/// The permutation of Perlin's reference implementation.
constexpr std::array<std::uint8_t, 256> permutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180,
};

/// Directions to the twelve edges of a cube, four of them twice, in pbrt-v3's order. The repeated
/// ones are not all those of Perlin's paper.
constexpr std::array<std::array<std::int8_t, 3>, 16> gradients = {{
    {1, 1, 0},
    {-1, 1, 0},
    {1, -1, 0},
    {-1, -1, 0},
    {1, 0, 1},
    {-1, 0, 1},
    {1, 0, -1},
    {-1, 0, -1},
    {0, 1, 1},
    {0, -1, 1},
    {0, 1, -1},
    {0, -1, -1},
    {1, 1, 0},
    {-1, 1, 0},
    {0, 1, -1},
    {0, -1, -1},
}};

/// Bits of a gradient's code: of its two components that are not 0, which are negative, and which
/// they are: the first is x or y, the second y or z.
enum GradientCode : unsigned { first_negative = 1, second_negative = 2, first_y = 4, second_z = 8 };

/// The code of the gradient that belongs to each entry of the permutation.
constexpr auto gradient_codes = [] {
    std::array<std::uint8_t, 256> codes{};
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const auto& g = gradients[permutation[i] % gradients.size()];
        const int first = g[0] == 0 ? g[1] : g[0], second = g[2] == 0 ? g[1] : g[2];
        codes[i] = static_cast<std::uint8_t>(
            (first < 0 ? first_negative : 0) | (second < 0 ? second_negative : 0) |
            (g[0] == 0 ? first_y : 0) | (g[2] == 0 ? 0 : second_z));
    }
    return codes;
}();

unsigned permuted(unsigned i) {
    return permutation[i % 256];
}

/// Sets the codes of the gradients at the eight corners of a cell, x first, `stride` apart.
void find_gradients(unsigned x, unsigned y, unsigned z, std::size_t stride, std::uint64_t* codes) {
    for (unsigned i = 0; i < 2; ++i) {
        const unsigned plane = permuted(x + i) + y;
        for (unsigned j = 0; j < 2; ++j) {
            const unsigned row = permuted(plane + j) + z;
            for (unsigned k = 0; k < 2; ++k) {
                codes[(i + 2 * j + 4 * k) * stride] = gradient_codes[(row + k) % 256];
            }
        }
    }
}

}  // namespace
}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

using WordTag = hn::RebindToUnsigned<DoubleTag>;

/// Positions of coordinates in the lattice, which repeats after 256 cells.
struct LatticePlaces {
    HWY_INLINE explicit LatticePlaces(Doubles x) {
        const Doubles floor = hn::Floor(x);
        const Doubles cell = floor - broadcast(256) * hn::Floor(floor / broadcast(256));
        const hn::Rebind<std::int32_t, DoubleTag> ints;
        hn::StoreU(hn::DemoteTo(ints, cell), ints, cells.data());
        offset = x - floor;
        const Doubles quintic = offset * (offset * broadcast(6) - broadcast(15)) + broadcast(10);
        weight = offset * offset * offset * quintic;
    }

    Doubles offset;  ///< from the cells' lower ends, 0 to 1
    Doubles weight;  ///< weights of the cells' upper ends
    std::array<std::int32_t, most_doubles> cells;
};

/// Returns the values at the offset `v` from lattice points of these points' gradients.
HWY_INLINE Doubles gradient_values(hn::Vec<WordTag> codes, const Vec3Lanes& v) {
    const DoubleTag tag;
    const WordTag words;
    const auto has = [&](unsigned bit) HWY_ATTR {
        return hn::RebindMask(tag, hn::TestBit(codes, hn::Set(words, bit)));
    };
    const Doubles first_sign = hn::BitCast(tag, hn::ShiftLeft<63>(codes));
    const Doubles second_sign =
        hn::And(hn::BitCast(tag, hn::ShiftLeft<62>(codes)), broadcast(-0.0));
    return hn::Xor(hn::IfThenElse(has(first_y), v.y, v.x), first_sign) +
           hn::Xor(hn::IfThenElse(has(second_z), v.z, v.y), second_sign);
}

/// Interpolates by the rules of std::lerp(), which is monotonic in t and exact at 0 and 1.
HWY_INLINE Doubles interpolated(Doubles a, Doubles b, Doubles t) {
    const Doubles zero = broadcast(0), one = broadcast(1);
    const DoubleMask differ_in_sign =
        hn::Or(hn::And(a <= zero, b >= zero), hn::And(a >= zero, b <= zero));
    const Doubles x = a + t * (b - a);
    const Doubles least = hn::IfThenElse(b < x, x, b), most = hn::IfThenElse(b > x, x, b);
    const Doubles on_way = hn::IfThenElse(hn::Xor(t > one, b > a), most, least);
    return hn::IfThenElse(differ_in_sign, t * b + (one - t) * a,
                          hn::IfThenElse(t == one, b, on_way));
}

/// Returns the noise at points with finite coordinates, of which the first `used` count.
HWY_INLINE Doubles noise_at(const Vec3Lanes& p, std::size_t used) {
    constexpr std::size_t lanes = most_doubles;
    const LatticePlaces x(p.x), y(p.y), z(p.z);
    std::array<std::uint64_t, 8 * lanes> codes;
    for (std::size_t i = 0; i < std::min(used, hn::Lanes(DoubleTag())); ++i) {
        find_gradients(x.cells[i], y.cells[i], z.cells[i], lanes, &codes[i]);
    }
    const auto corner = [&](int i, int j, int k) HWY_ATTR {
        return gradient_values(
            hn::LoadU(WordTag(), &codes[(i + 2 * j + 4 * k) * lanes]),
            {x.offset - broadcast(i), y.offset - broadcast(j), z.offset - broadcast(k)});
    };
    const auto along_x = [&](int j, int k) HWY_ATTR {
        return interpolated(corner(0, j, k), corner(1, j, k), x.weight);
    };
    const auto along_y = [&](int k) HWY_ATTR {
        return interpolated(along_x(0, k), along_x(1, k), y.weight);
    };
    return interpolated(along_y(0), along_y(1), z.weight);
}

HWY_INLINE Doubles zero_unless_finite(Doubles v, DoubleMask finite) {
    return hn::IfThenElseZero(finite, v);
}

void find_noise(const Vec3Span& points, std::size_t count, double* values) {
    const DoubleTag tag;
    const Doubles end = broadcast(infinity);
    for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
        const Vec3Lanes p = load(points, i), size = abs(p);
        const DoubleMask finite = hn::And(size.x < end, hn::And(size.y < end, size.z < end));
        const Doubles noise =
            noise_at({zero_unless_finite(p.x, finite), zero_unless_finite(p.y, finite),
                      zero_unless_finite(p.z, finite)},
                     count - i);
        hn::StoreU(zero_unless_finite(noise, finite), tag, values + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(find_noise);

void gradient_noise(const Vec3Span& points, std::size_t count, double* values) {
    HWY_DYNAMIC_DISPATCH(find_noise)(points, count, values);
}

double gradient_noise(const Vec3& p) {
    Vec3Columns<padded_doubles> points;
    for (std::size_t i = 0; i < padded_doubles; ++i) points.set(i, p);
    std::array<double, padded_doubles> values;
    gradient_noise(points.span(), 1, values.data());
    return values[0];
}

}  // namespace etalon
#endif
