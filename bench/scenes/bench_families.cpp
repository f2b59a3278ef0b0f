#include "bench/scenes/bench_families.h"

namespace etalon::bench {
namespace {

constexpr std::size_t most = 100'000'000;

constexpr Family table[] = {
    {"soup", "N", 1'000'000, most, "small random triangles in a cube", soup},
    {"spheres", "N", 100'000, most, "small random spheres in a cube", spheres},
    {"duplicates", "N", 10'000, most, "the same triangle N times", duplicates, 64},
    {"terrain", "N", 250'000, most, "a fractal heightfield", terrain},
    {"flake", "N", 432'962, most, "a sphereflake of triangles on a floor", flake},
    {"stadium", "N", 268'000, most,
     "needles of length 7 to 10 around a finely tessellated torus of diameter 0.2", stadium, 128},
    {"slivers", "N", 50'000, most, "random needles, 120 times as long as wide", slivers},
    {"sphereflake", "DEPTH", 4, 8, "spheres on spheres: 7381 at depth 4", sphereflake},
    {"mixed", "N", 100'000, most, "spheres, cones, boxes, triangles, polygons in turn", mixed},
    {"flat", "N", 100'000, most, "random triangles in one plane", flat},
    {"equal", "N", 10'000, most, "triangles of all sizes about one centre", equal, 64},
    {"hair", "N", 100'000, most / 8, "curves on a ball, in eight parts each", hair},
    {"forest", "N", 1'000'000, most, "instances of 20 trees of 400 triangles", forest},
    {"forest_copies", "N", 2'000, most / 400, "forest without instances: N trees", forest_copies},
    {"plaza", "N", 10'000, most, "instances from 1e-4 to 1e4 high about one place", plaza},
    {"plaza_copies", "N", 10'000, most / 400, "plaza without instances", plaza_copies},
    {"nan", "N", 100'000, most, "soup, every tenth triangle with a NaN", nan_soup},
};

}  // namespace

std::span<const Family> families() {
    return table;
}

}  // namespace etalon::bench
