// Hard cases of the grid: rays along its planes and through its corners, dense meshes in large
// scenes, and its memory limit.
#include "native_accel/grid/grid.h"

#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns primitives whose bounds are at n^3 points of a cube, where grids have their planes, and
/// at the cube's corners.
Scene lattice(int n, bool spheres) {
    Scene scene;
    for (int i = 0; i < n * n * n; ++i) {
        const Vec3 place(i % n, i / n % n, i / (n * n));
        if (spheres) {
            scene.geometry.add(Sphere{place + Vec3(0.5), 0.5}, 0);
        } else {
            const auto first = static_cast<std::uint32_t>(scene.geometry.vertices.size());
            for (const Vec3& corner : {Vec3(0), Vec3(0.5, 0, 0), Vec3(0, 0.5, 0)}) {
                scene.geometry.vertices.push_back(place + corner);
            }
            scene.geometry.add(Triangle{{first, first + 1, first + 2}}, 0);
        }
    }
    return scene;
}

/// Returns rays along planes, and diagonals of faces and cubes, through corners, from inside, next
/// to the scene and far away.
std::vector<Ray> rays_along_planes(int n, std::size_t count) {
    Random random(count);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const auto whole = [&](int below) { return static_cast<double>(random.index(below)); };
        const Vec3 direction(whole(3) - 1, whole(3) - 1, whole(3) - 1);
        if (max_abs(direction) == 0) continue;
        const Vec3 through(whole(2 * n + 1) / 2, whole(2 * n + 1) / 2, whole(2 * n + 1) / 2);
        const double back = random.one_in(8) ? 1e7 * n : whole(2 * n);
        const double aside = random.one_in(2) ? 0 : random.magnitude(-16, -5);
        rays.push_back({through - back * direction, direction + aside * random.direction()});
    }
    return rays;
}

void require_hits_of_brute_force(const Scene& scene, const std::vector<Ray>& rays) {
    const Grid grid(scene.geometry);
    std::size_t different = 0, hits = 0;
    std::string first;
    for (const Ray& ray : rays) {
        const std::optional<Hit> expected = brute_force(scene, ray);
        hits += expected ? 1 : 0;
        const std::string text = difference(grid, ray, expected);
        if (!text.empty() && different++ == 0) first = text;
    }
    INFO(first);
    CHECK(different == 0);
    CHECK(hits > rays.size() / 100);
}

/// Returns a mesh of a unit sphere, with a floor and walls of triangles 100 times as large.
Scene teapot_in_stadium(std::size_t count) {
    Scene scene = make_scene("closed_mesh", count);
    Random random(1);
    for (int i = 0; i < 40; ++i) {
        const auto first = static_cast<std::uint32_t>(scene.geometry.vertices.size());
        for (int corner = 0; corner < 3; ++corner) {
            scene.geometry.vertices.push_back(100.0 * Vec3(Vec3f(random.direction())));
        }
        scene.geometry.add(Triangle{{first, first + 1, first + 2}}, 0);
    }
    return scene;
}

std::vector<BoxItem> box_items(const Scene& scene) {
    std::vector<BoxItem> items;
    for (const BoundedPrimitive& p : SceneBounds::of(scene.geometry).bounded)
        items.push_back({p.box(), p.id});
    return items;
}

GridTree tree_of(const std::vector<BoxItem>& items) {
    return GridBuilder<BoxItem>(items, {BoxPack::cost}).build(Box3(Vec3(-1), Vec3(1)));
}

bool same(const GridTree& a, const GridTree& b) {
    const auto equal = [](const GridCell& x, const GridCell& y) {
        return x.first == y.first && x.count == y.count;
    };
    const auto same_start = [](const GridNode& x, const GridNode& y) {
        return x.first_cell == y.first_cell && x.resolution() == y.resolution();
    };
    return a.items == b.items && equal(a.root, b.root) &&
           std::equal(a.cells.begin(), a.cells.end(), b.cells.begin(), b.cells.end(), equal) &&
           std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_start);
}

}  // namespace

TEST_CASE("Given rays along planes, diagonals and corners of cells, the grid loses no hit",
          "[grid]") {
    for_each_target([] {
        for (const bool spheres : {false, true}) {
            for (const int n : {2, 8, 13, 16, 24}) {
                INFO((spheres ? "spheres" : "triangles") << ", " << n << " an edge");
                require_hits_of_brute_force(lattice(n, spheres), rays_along_planes(n, 1000));
            }
        }
    });
}

TEST_CASE("Given a dense mesh in a hundred times larger scene, the grid finds all in little memory",
          "[grid]") {
    const Scene scene = teapot_in_stadium(20000);
    Random random(2);
    std::vector<Ray> rays = make_rays(scene, 300, random);
    for (int i = 0; i < 300; ++i) {
        const Vec3 origin = 100.0 * random.direction();
        rays.push_back({origin, random.in_cube(0.7) - origin});
    }
    require_hits_of_brute_force(scene, rays);
    CHECK(Grid(scene.geometry).memory_bytes() < 400 * scene.geometry.primitives.size());
}

TEST_CASE("Given any scene, the grid lists no more references and cells than it says", "[grid]") {
    for (const SceneFamily& family : scene_families()) {
        const std::vector<BoxItem> items = box_items(family.make(5000));
        const GridConfig config{BoxPack::cost};
        const GridTree tree = tree_of(items);
        INFO(family.name);
        const double most = config.max_references * static_cast<double>(items.size());
        CHECK(static_cast<double>(tree.items.size()) <= most);
        CHECK(static_cast<double>(tree.cells.size()) <= config.max_depth * most);
    }
}

TEST_CASE("Given a hull a thousand times as long as wide, a ray along it is spared most of it",
          "[grid]") {
    std::vector<BoxItem> items;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const double z = (i % 100) / 50.0 - 0.99, angle = i / 100 * 0.0314159265;
        const Vec3 place = 1e-3 * std::sqrt(1 - z * z) * Vec3(std::cos(angle), std::sin(angle), 0);
        const Vec3 reach(2e-5, 2e-5, 0.01), centre = place + Vec3(0, 0, z);
        items.push_back({Box3f(Vec3f(centre - reach), Vec3f(centre + reach)), i});
    }
    const GridTree tree = GridBuilder<BoxItem>(items, {BoxPack::cost})
                              .build(Box3(Vec3(-1e-3, -1e-3, -1), Vec3(1e-3, 1e-3, 1)));
    REQUIRE(tree.root.is_grid());
    const CellIndex cut = tree.nodes[tree.root.first].resolution();
    CHECK(cut[0] >= 8);
    CHECK(cut[1] >= 8);
}

TEST_CASE("Given one thread or several, the grid is the same", "[grid][needs_two_cores]") {
    SKIP_UNLESS(max_threads() >= 2, "a single core");
    for (const char* family : {"spheres", "triangles", "closed_mesh", "slivers"}) {
        INFO(family);
        const std::vector<BoxItem> items = box_items(make_scene(family, 60000));
        const GridTree several = tree_of(items);
        const ThreadLimit one_thread(1);
        CHECK(same(tree_of(items), several));
        CHECK(!several.nodes.empty());
    }
}
