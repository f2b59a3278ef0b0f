#include "scenes/generate/generator_families.h"

#include <algorithm>
#include <array>

namespace etalon::generate {
namespace {

template <void (*family)(Writer& out, std::int64_t size)>
void p3f(const LineWriter::Sink& sink, const std::string& comment, std::int64_t size) {
    Writer out(sink);
    out.comment(comment);
    family(out, size);
    out.flush();
}

template <void (*family)(LineWriter& out, std::int64_t size)>
void pbrt(const LineWriter::Sink& sink, const std::string& comment, std::int64_t size) {
    LineWriter out(sink);
    out.line("# {}", comment);
    family(out, size);
    out.flush();
}

// The largest sizes keep the number of primitives under 2^32. The default sizes are those of SPD.
constexpr std::array table{
    Family{"sphereflake", p3f<sphereflake>, ".p3f",
           "spheres that each carry nine of a third of their radius, N levels deep: (9^(N+1) - 1) "
           "/ 8 spheres",
           4, 0, 10},
    Family{"tetra", p3f<tetra>, ".p3f", "Sierpinski's tetrahedron: 4^N tetrahedra of 4 triangles",
           6, 0, 14},
    Family{"mountain", p3f<mountain>, ".p3f",
           "a fractal height field under four glass spheres: 2 * 4^N triangles", 6, 0, 15},
    Family{"rings", p3f<rings>, ".p3f",
           "a pyramid of N layers of knots, each of six interlocked pentagons: "
           "10 N (N+1) (2N+1) cylinders and spheres",
           7, 1, 500},
    Family{"gears", p3f<gears>, ".p3f",
           "N x N x N meshing gears, each of two polygons with 144 corners and 144 quadrilaterals",
           4, 1, 300},
    Family{"tree", p3f<tree>, ".p3f",
           "a tree that forks N times: 2^(N+1) - 1 cones and as many spheres", 11, 0, 29},
    Family{"soup", p3f<soup>, ".p3f", "N small random triangles in a cube", 100'000, 1,
           4'000'000'000},
    Family{"spheres", p3f<spheres>, ".p3f", "N random spheres in a cube", 100'000, 1,
           4'000'000'000},
    Family{"forest", pbrt<forest>, ".pbrt", "N instances of twenty trees of 400 triangles; PBRT",
           1'000'000, 1, 100'000'000},
    Family{"plaza", pbrt<plaza>, ".pbrt",
           "N instances of a column, steps and a dome, from 1e-4 to 1e4 high; PBRT", 10'000, 1,
           100'000'000},
};

}  // namespace

std::span<const Family> families() {
    return table;
}

const Family* find_family(std::string_view name) {
    const auto* found = std::ranges::find(table, name, &Family::name);
    return found == table.end() ? nullptr : found;
}

void ground(Writer& out, const P3fMaterial& material) {
    out.material(material);
    constexpr double half = 24;
    const std::array<Vec3, 4> corners{Vec3(-half, 0, -half), Vec3(-half, 0, half),
                                      Vec3(half, 0, half), Vec3(half, 0, -half)};
    out.polygon(corners);
}

}  // namespace etalon::generate
