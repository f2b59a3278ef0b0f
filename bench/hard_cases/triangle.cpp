#include "bench/hard_cases/add_face.h"
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/face_ray_targets.h"
#include "bench/hard_cases/ray_targets.h"

namespace etalon::hard {
namespace {

Corners usual() {
    return {tilted(0, 0, 1), tilted(2, 0.25, 1), tilted(0.5, 1.5, 1)};
}

const Corners level{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};

/// Returns a triangle of length 1 and height `height`, horizontal or in a generic plane.
Corners sliver(double height, bool is_tilted) {
    if (!is_tilted) return {{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}};
    return {tilted(0, 0, 0), tilted(1, 0, 0), tilted(0.5, height, 0)};
}

/// Rays in the plane of a horizontal triangle, through points of a lattice that contains its
/// vertices: exactly along edges and through vertices.
CaseSetup in_level_plane() {
    return only_face(level, 4, [](Random& random) {
        const auto lattice = [&random](double z) {
            const double x = static_cast<double>(random.index(9)) - 2;
            const double y = static_cast<double>(random.index(9)) - 2;
            return Vec3(x, y, z);
        };
        const Vec3 origin = lattice(2), target = lattice(2);
        return origin == target ? Ray{origin, {1, 0, 0}} : towards(origin, target);
    });
}

/// Degenerate triangles, which cannot be hit, among the valid ones of a square of 16 x 16.
CaseSetup degenerate_neighbours() {
    CaseSetup setup{{}, 1, [](Random& random) {
                        Vec3 target{random.uniform(0, 16), random.uniform(0, 16), 0};
                        if (random.index(2) == 0) target.x = std::round(target.x);
                        if (random.index(2) == 0) target.y = std::round(target.y);
                        const double distance = random.magnitude(-1, 3);
                        return towards(target + distance * random.direction(), target);
                    }};
    for (int i = 0; i < 256; ++i) {
        const Vec3 a(i % 16, i / 16, 0), b = a + Vec3(1, 0, 0), c = a + Vec3(0, 1, 0);
        const Vec3 none(nan_value), beyond(infinity);
        const Corners adversarial[] = {{a, b, none},   {a, a, a},      {a, b, b},
                                       {a, b, beyond}, {a, c, c},      {a, 0.5 * (a + b), b},
                                       {none, b, c},   {-beyond, b, c}};
        add_face(setup.scene, adversarial[i % std::size(adversarial)]);
        add_face(setup.scene, {a, b, c});
    }
    return setup;
}

/// Overlapping triangles with small integer coordinates in one plane, hit at points of a finer
/// lattice: several are hit everywhere, at exactly the same distance.
CaseSetup coplanar() {
    CaseSetup setup{{}, 8, [](Random& random) {
                        const double x = static_cast<double>(random.index(33)) / 4;
                        const double y = static_cast<double>(random.index(33)) / 4;
                        const Vec3 target(x, y, 4);
                        const Vec3 up{static_cast<double>(random.index(5)) - 2,
                                      static_cast<double>(random.index(5)) - 2, random.sign()};
                        return Ray{target + 4.0 * up, -up};
                    }};
    Random random(1, 0);
    while (setup.scene.geometry.primitives.size() < 200) {
        Corners corners;
        for (int i = 0; i < 3; ++i) {
            const auto x = static_cast<double>(random.index(9));
            corners.emplace_back(x, static_cast<double>(random.index(9)), 4);
        }
        add_face(setup.scene, corners);
    }
    return setup;
}

}  // namespace

std::vector<HardCase> triangle_cases() {
    Rows rows("triangle");
    rows.add_both("TRI-1", "usual", [] { return aimed_at_face(rounded(usual()), 1); });
    for (const bool is_tilted : {false, true}) {
        const std::string name = is_tilted ? "tilted, height " : "level, height ";
        for (const int k : {3, 6}) {
            rows.add_both("TRI-1", name + power_of_ten(-k), [=] {
                return aimed_at_face(rounded(sliver(std::pow(10.0, -k), is_tilted)), 1);
            });
        }
        for (const int k : {9, 12}) {
            rows.add("TRI-1", name + power_of_ten(-k),
                     [=] { return aimed_at_face(sliver(std::pow(10.0, -k), is_tilted), 1); });
        }
    }
    rows.add_both("TRI-1", "at 3e5",
                  [] { return aimed_at_face(rounded(moved(usual(), far_place())), 1); });
    rows.add_both("TRI-6", "level", in_level_plane);
    rows.add_both("TRI-6", "tilted", [] { return along_face(rounded(usual()), 1); });
    rows.add(
        "SPN-4", "usual", [] { return aimed_at_face(usual(), 1); }, Criterion::spawned);
    rows.add(
        "SPN-4", "sliver", [] { return aimed_at_face(sliver(1e-6, true), 1); }, Criterion::spawned);
    rows.add(
        "SPN-4", "at 3e5", [] { return aimed_at_face(moved(usual(), far_place()), 1); },
        Criterion::spawned);
    return rows.take();
}

std::vector<HardCase> triangle_group_cases() {
    Rows rows("scene");
    rows.add("TRI-7", "degenerate neighbours", degenerate_neighbours);
    rows.add_both("TRI-8", "coplanar and overlapping", coplanar);
    return rows.take();
}

}  // namespace etalon::hard
