#include "bench/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/formats/load.h"
#include "core/sampling/sobol.h"

namespace etalon {
namespace {

/// Uniform numbers in [0, 1): the stream's name and the place in it decide each.
class Random {
  public:
    explicit Random(std::uint32_t stream) : stream_(stream) {}
    double next() { return hash(stream_, count_++) * 0x1p-32; }
    Vec3 in_cube() {
        const double x = next(), y = next(), z = next();
        return Vec3(2 * x - 1, 2 * y - 1, 2 * z - 1);
    }

  private:
    std::uint32_t stream_, count_ = 0;
};

Scene empty_scene() {
    Scene scene;
    scene.format = "generated";
    scene.camera = {Vec3(2.2, 1.6, 2.8), Vec3(0), Vec3(0, 1, 0), 45, 512, 512, 0, 1};
    scene.lights = {PointLight{Vec3(3, 5, 4), Color(1.0F)}};
    scene.materials = {Material()};
    return scene;
}

/// Corners within an edge of their triangle's place; the edge shrinks so that the total area, and
/// with it the number of surfaces a ray passes, stays alike for every N.
Scene soup(std::size_t count) {
    Scene scene = empty_scene();
    Random random(1);
    const double edge = 3 / std::sqrt(static_cast<double>(count));
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 place = random.in_cube();
        for (int corner = 0; corner < 3; ++corner) {
            scene.vertices.push_back(place + edge * random.in_cube());
        }
        scene.add(Triangle{{3 * i, 3 * i + 1, 3 * i + 2}}, 0);
    }
    return scene;
}

Scene spheres(std::size_t count) {
    Scene scene = empty_scene();
    Random random(2);
    const double radius = 0.5 / std::sqrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 place = random.in_cube();
        scene.add(Sphere{place, radius * (0.5 + random.next())}, 0);
    }
    return scene;
}

/// The same triangle over and over.
Scene duplicates(std::size_t count) {
    Scene scene = empty_scene();
    scene.vertices = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};
    for (std::size_t i = 0; i < count; ++i) scene.add(Triangle{{0, 1, 2}}, 0);
    return scene;
}

struct Family {
    std::string_view name;
    Scene (*make)(std::size_t count);
};

constexpr Family families[] = {{"soup", soup}, {"spheres", spheres}, {"duplicates", duplicates}};

const Family* find_family(std::string_view name) {
    const auto* found = std::find_if(std::begin(families), std::end(families),
                                     [name](const Family& f) { return f.name == name; });
    return found == std::end(families) ? nullptr : found;
}

std::optional<Scene> from_file(const std::string& path) {
    LoadResult loaded = load_scene(path);
    fmt::print(stderr, "{}", report(loaded.diagnostics));
    return std::move(loaded.scene);
}

}  // namespace

std::optional<Scene> bench_scene(const std::string& name) {
    const std::size_t colon = name.find(':');
    const Family* family = find_family(name.substr(0, colon));
    if (colon == std::string::npos || family == nullptr) return from_file(name);
    const unsigned long count = std::strtoul(name.c_str() + colon + 1, nullptr, 10);
    if (count == 0 || count > 100'000'000) {
        fmt::print(stderr, "etalon-bench: error: {}: expected a count from 1 to 1e8\n", name);
        return std::nullopt;
    }
    return family->make(count);
}

}  // namespace etalon
