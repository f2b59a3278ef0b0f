// Lattices, for the traversal of grids: every number is a small multiple of a power of two, so rays
// run exactly along cell planes and through cell corners.
#include "bench/hard_cases/add_face.h"
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {
namespace {

constexpr int cells = 12;

enum class Knots { spheres, boxes };

/// Returns a scene of small shapes at all points of the lattice 0 ... 11. Their half-extent is 1/4,
/// so that the outermost faces of the scene are at -1/4 and 11 1/4.
Scene lattice(Knots knots) {
    Scene scene;
    for (int i = 0; i < cells * cells * cells; ++i) {
        const Vec3 p(i % cells, i / cells % cells, i / cells / cells);
        if (knots == Knots::spheres) scene.geometry.add(Sphere{p, 0.25}, 0);
        if (knots == Knots::boxes) scene.geometry.add(Box{p - Vec3(0.25), p + Vec3(0.25)}, 0);
    }
    return scene;
}

/// Returns a multiple of 1 / steps between 0 and `end`.
double fraction(int end, int steps, Random& random) {
    const auto count = static_cast<std::size_t>(end * steps + 1);
    return static_cast<double>(random.index(count)) / steps;
}

Vec3 lattice_point(int end, int steps, Random& random) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = fraction(end, steps, random);
    return p;
}

/// Returns a ray along an axis at quarters and halves of cells: on faces of shapes and on cell
/// planes.
Ray along_axis(Random& random) {
    const Vec3 d = axis_direction(random);
    const Vec3 point = lattice_point(cells - 1, 4, random);
    return {point - 32.0 * d, d};
}

/// Returns a ray along a diagonal of a face or of a cell.
Ray along_diagonal(Random& random) {
    Vec3 d;
    for (int k = 0; k < 3; ++k) d[k] = random.sign();
    if (random.index(2) == 0) d[random.axis()] = random.sign() * 0.0;
    return {lattice_point(cells - 1, 2, random) - 16.0 * d, d};
}

/// Returns a ray from one corner of a cell through another.
Ray through_corners(Random& random) {
    const Vec3 a = lattice_point(cells - 1, 2, random), b = lattice_point(cells - 1, 2, random);
    const Vec3 d = a == b ? Vec3(1, 0, 0) : b - a;
    return {a - fraction(2, 1, random) * d, d};
}

using MakeLatticeRay = Ray (*)(Random&);

CaseSetup traversed(Knots knots, MakeLatticeRay ray) {
    return {lattice(knots), 1, ray};
}

/// Returns squares and boxes without thickness in the planes between cells, including the outermost
/// ones.
CaseSetup on_planes() {
    CaseSetup setup{{}, 1, through_corners};
    Random random(1, 0);
    while (setup.scene.geometry.primitives.size() < 500) {
        const Vec3 low = lattice_point(cells - 2, 1, random);
        const int k = random.axis();
        Vec3 across(1), along(0);
        across[k] = 0;
        along[(k + 1) % 3] = 1;
        const Vec3 high = low + across;
        if (random.index(2) == 0) {
            setup.scene.geometry.add(Box{low, high}, 0);
        } else {
            add_face(setup.scene, {low, low + along, high});
        }
    }
    return setup;
}

/// Returns a ray from up to about 1e8 extents away through a corner, an edge or a face of the
/// scene's bounds.
Ray from_outside(Random& random) {
    const double low = -0.25, high = cells - 0.75;
    const std::size_t fixed = 1 + random.index(3), first = random.index(3);
    Vec3 target;
    for (std::size_t i = 0; i < 3; ++i) {
        const double on_face = random.index(2) == 0 ? low : high;
        target[static_cast<int>((first + i) % 3)] =
            i < fixed ? on_face : low + fraction(cells, 4, random);
    }
    const Vec3 within = lattice_point(cells - 1, 2, random);
    Vec3 d = target - within;
    if (random.index(2) == 0) d = random.direction();
    const double distance = std::ldexp(1.0, static_cast<int>(random.index(28)));
    return {target + distance * d, -d};
}

}  // namespace

std::vector<HardCase> grid_cases() {
    Rows rows("scene");
    for (const Knots knots : {Knots::spheres, Knots::boxes}) {
        const std::string name = knots == Knots::spheres ? "spheres: " : "boxes: ";
        rows.add_both("GRD-1", name + "along axes", [=] { return traversed(knots, along_axis); });
        rows.add_both("GRD-1", name + "along diagonals",
                      [=] { return traversed(knots, along_diagonal); });
        rows.add_both("GRD-1", name + "through corners",
                      [=] { return traversed(knots, through_corners); });
        rows.add_both("GRD-3", name + "from outside",
                      [=] { return traversed(knots, from_outside); });
    }
    rows.add_both("GRD-2", "primitives on cell planes", on_planes);
    return rows.take();
}

}  // namespace etalon::hard
