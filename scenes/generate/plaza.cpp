// A plaza of nested sizes: rings of columns, steps and domes about its middle, from 1e-4 to 1e4
// high, each as far away as it is large.
#include <array>

#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"
#include "scenes/generate/instances.h"

namespace etalon::generate {
namespace {

constexpr std::array decades = {1e-4, 1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3};
constexpr std::uint32_t objects = 3;

/// A column 1 high, with a foot and a head.
Mesh column() {
    Mesh mesh;
    mesh.add_prism(16, 0, 0.08, 0.16, 0.14);
    mesh.add_prism(16, 0.08, 0.9, 0.1, 0.08);
    mesh.add_prism(16, 0.9, 1, 0.12, 0.16);
    mesh.add_prism(16, 1, 1, 0.16, 0);
    return mesh;
}

/// Five steps, each a quarter of a square narrower than the one below.
Mesh steps() {
    Mesh mesh;
    for (int i = 0; i < 5; ++i) {
        const double radius = 0.6 - 0.1 * i, low = 0.2 * i;
        mesh.add_prism(4, low, low + 0.2, radius, radius);
        mesh.add_prism(4, low + 0.2, low + 0.2, radius, i < 4 ? radius - 0.1 : 0);
    }
    return mesh;
}

/// Returns half a ball of bands.
Mesh dome() {
    constexpr int bands = 6;
    Mesh mesh;
    for (int i = 0; i < bands; ++i) {
        const Vec2 low = on_circle(0.25 * i / bands), high = on_circle(0.25 * (i + 1) / bands);
        mesh.add_prism(24, low.y, high.y, low.x, high.x);
    }
    return mesh;
}

void write_object(LineWriter& out, std::uint32_t number, const Color& color, const Mesh& mesh) {
    out.line("ObjectBegin \"{}\"", number);
    matte(out, color);
    mesh.write(out);
    out.line("ObjectEnd");
}

/// A size of any decade with equal probability.
double size_of(std::uint64_t i) {
    const double decade = decades[scramble(i) % decades.size()];
    return decade * (5.5 + 4.5 * noise(i, 0));
}

}  // namespace

void plaza(LineWriter& out, std::int64_t size) {
    begin_world(out, {0.3, 0.5, 0.2}, {1.3, 0.42, 0.8}, 60);
    write_ground(out, 1e5);
    write_object(out, 0, {0.7F, 0.65F, 0.55F}, column());
    write_object(out, 1, {0.55F, 0.55F, 0.6F}, steps());
    write_object(out, 2, {0.6F, 0.4F, 0.3F}, dome());
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(size); ++i) {
        const double height = size_of(i), away = height * (4.5 + 2.5 * noise(i, 1));
        const Vec2 at = on_circle(noise(i, 2)), turn = on_circle(noise(i, 3));
        write_instance(out, static_cast<std::uint32_t>(i % objects),
                       {height * Vec3(turn.x, 0, -turn.y), Vec3(0, height, 0),
                        height * Vec3(turn.y, 0, turn.x), Vec3(away * at.x, 0, away * at.y)});
    }
    out.line("WorldEnd");
}

}  // namespace etalon::generate
