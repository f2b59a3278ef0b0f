#include <algorithm>
#include <array>

#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"

namespace etalon::generate {
namespace {

constexpr int teeth = 24;  ///< a multiple of four: neighbours in both directions mesh

/// Corner of a tooth: where, as a fraction of the pitch, and how far from the pitch circle, as a
/// fraction of its radius. Teeth reach less far out than the gaps between them reach in.
struct Corner {
    double along, out;
};
constexpr double module = 2.0 / teeth;
constexpr std::array<Corner, 6> tooth{{{-0.30, -1.0 * module},
                                       {-0.19, 0.0},
                                       {-0.09, 0.8 * module},
                                       {0.09, 0.8 * module},
                                       {0.19, 0.0},
                                       {0.30, -1.0 * module}}};
using Outline = std::array<Vec3, teeth * tooth.size()>;

/// Returns the outline of a gear, clockwise seen from above; `phase` turns the gear by that
/// fraction of the pitch.
Outline outline(const Vec3& centre, double radius, double phase) {
    Outline corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Corner& c = tooth[k % tooth.size()];
        const auto index = static_cast<double>(k / tooth.size());
        const Vec2 direction = on_circle((index + phase + c.along) / teeth);
        corners[k] = centre + radius * (1 + c.out) * Vec3(direction.x, 0, direction.y);
    }
    return corners;
}

void gear(Writer& out, const Vec3& centre, double radius, double thickness, double phase) {
    const Outline bottom = outline(centre, radius, phase);
    Outline top = bottom;
    for (Vec3& corner : top) corner.y += thickness;
    for (std::size_t k = 0; k < top.size(); ++k) {
        const std::size_t next = (k + 1) % top.size();
        out.polygon(std::array{top[k], top[next], bottom[next], bottom[k]});
    }
    out.polygon(bottom);
    std::reverse(top.begin(), top.end());
    out.polygon(top);
}

/// The gears of one colour of a three-dimensional chessboard; the other colour's teeth are in
/// their gaps. The board is two units wide.
void half_of_the_gears(Writer& out, std::int64_t size, int colour) {
    const double radius = 1.0 / static_cast<double>(size);
    for (std::int64_t i = 0; i < size * size * size; ++i) {
        const std::int64_t x = i % size;
        const std::int64_t z = i / size % size;
        const std::int64_t y = i / size / size;
        if ((x + y + z) % 2 != colour) continue;
        const Vec3 centre(radius * static_cast<double>(2 * x - size + 1),
                          radius * static_cast<double>(y) * 0.7,
                          radius * static_cast<double>(2 * z - size + 1));
        gear(out, centre, radius, 0.4 * radius, colour == 0 ? 0 : 0.5);
    }
}

}  // namespace

void gears(Writer& out, std::int64_t size) {
    out.background({0.08F, 0.36F, 0.75F});
    out.camera({{1.9, 2.2, 3.6}, {0, 0.25, 0}, {0, 1, 0}, 36}, {512, 512});
    out.light({4, 7, 1}, {0.6F, 0.57F, 0.5F});
    out.light({-5, 6, 4}, {0.35F, 0.37F, 0.42F});
    ground(out);
    out.material({.diffuse = {0.9F, 0.66F, 0.28F},
                  .kd = 0.8,
                  .specular = {1.0F, 0.8F, 0.45F},
                  .ks = 0.15,
                  .shine = 60});
    half_of_the_gears(out, size, 0);
    out.material({.diffuse = {0.62F, 0.67F, 0.72F}, .kd = 0.8, .ks = 0.15, .shine = 60});
    half_of_the_gears(out, size, 1);
}

}  // namespace etalon::generate
