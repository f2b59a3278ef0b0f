#include "core/texture/gradient_noise.h"

#include <array>
#include <cmath>
#include <cstdint>

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

/// Position of a coordinate in the lattice, which repeats after 256 cells.
struct LatticePlace {
    unsigned cell;
    double offset;  ///< from the cell's lower end, 0 to 1
    double weight;  ///< weight of the cell's upper end

    explicit LatticePlace(double x) {
        const double floor = std::floor(x);
        cell = static_cast<unsigned>(floor - 256 * std::floor(floor / 256));
        offset = x - floor;
        weight = offset * offset * offset * (offset * (offset * 6 - 15) + 10);
    }
};

unsigned permuted(unsigned i) {
    return permutation[i % 256];
}

/// Returns the value at the offset (x, y, z) from a lattice point of that point's gradient.
double gradient_value(unsigned hash, double x, double y, double z) {
    const auto& g = gradients[hash % 16];
    return g[0] * x + g[1] * y + g[2] * z;
}

}  // namespace

double gradient_noise(const Vec3& p) {
    if (!is_finite(p)) return 0;
    const LatticePlace x(p.x), y(p.y), z(p.z);
    const auto corner = [&](unsigned i, unsigned j, unsigned k) {
        const unsigned hash = permuted(permuted(permuted(x.cell + i) + y.cell + j) + z.cell + k);
        return gradient_value(hash, x.offset - i, y.offset - j, z.offset - k);
    };
    const auto along_x = [&](unsigned j, unsigned k) {
        return std::lerp(corner(0, j, k), corner(1, j, k), x.weight);
    };
    const auto along_y = [&](unsigned k) {
        return std::lerp(along_x(0, k), along_x(1, k), y.weight);
    };
    return std::lerp(along_y(0), along_y(1), z.weight);
}

}  // namespace etalon
