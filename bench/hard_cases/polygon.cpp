#include "bench/hard_cases/add_face.h"
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/face_ray_targets.h"
#include "bench/hard_cases/ray_targets.h"

namespace etalon::hard {
namespace {

const Corners notched{{0, 0, 3}, {4, 0, 3}, {4, 4, 3}, {2, 2, 3}, {0, 4, 3}};

/// A horizontal square with two more corners on each side.
const Corners collinear{{0, 0, 3}, {1, 0, 3}, {3, 0, 3}, {4, 0, 3}, {4, 1, 3}, {4, 3, 3},
                        {4, 4, 3}, {3, 4, 3}, {1, 4, 3}, {0, 4, 3}, {0, 3, 3}, {0, 1, 3}};

/// A unit square with its corners displaced from its plane by `gap`, alternately up and down.
Corners bent(double gap) {
    return {tilted(0, 0, gap), tilted(2, 0, -gap), tilted(2, 1, gap), tilted(0.5, 1.5, 0),
            tilted(0, 1, -gap)};
}

/// Rays through points of a lattice that contains the corners: through corners and edges, and along
/// lines on which an edge starts or ends.
CaseSetup at_lattice(const Corners& corners) {
    return only_face(corners, 4, [](Random& random) {
        const double x = static_cast<double>(random.index(13)) / 2 - 1;
        const double y = static_cast<double>(random.index(13)) / 2 - 1;
        const Vec3 up{static_cast<double>(random.index(5)) - 2,
                      static_cast<double>(random.index(5)) - 2, random.sign()};
        return Ray{Vec3(x, y, 3) + 2.0 * up, -up};
    });
}

/// A quad and a pentagon that share a slanted edge, folded along it; rays hit the edge, except for
/// its ends, from within the angle between the two.
CaseSetup shared_edge(const Vec3& place) {
    const Vec3 a = rounded(tilted(0.1, -1, 0) + place), b = rounded(tilted(-0.2, 1, 0.1) + place);
    const Vec3 left = tilted(-1, 0, 0.3), right = tilted(1, 0, 0.5), ahead = tilted(0, 0, 1);
    CaseSetup setup{{}, 1, [=](Random& random) {
                        const double s = random.index(4) == 0 ? 0.5 : random.uniform(0.1, 0.9);
                        const Vec3 target = a + s * (b - a);
                        const Vec3 aside = 0.5 * in_ball(random);
                        return towards(target + random.magnitude(-1, 2) * (ahead + aside), target);
                    }};
    const Vec3 middle = 0.5 * (a + b);
    add_face(setup.scene, rounded({a, a + left, b + left, b}));
    add_face(setup.scene, rounded({a, b, b + right, middle + 1.25 * right, a + right}));
    return setup;
}

/// Degenerate outlines without area, and valid ones, in a row.
CaseSetup degenerate_neighbours() {
    CaseSetup setup{{}, 1, [](Random& random) {
                        const double x = random.uniform(0, 24);
                        Vec3 target(x, random.uniform(0, 1), 0);
                        if (random.index(2) == 0) target.x = std::round(target.x);
                        if (random.index(4) == 0) target.y = std::round(target.y);
                        const double distance = random.magnitude(-1, 3);
                        return towards(target + distance * random.direction(), target);
                    }};
    for (int i = 0; i < 24; ++i) {
        const Vec3 a(i, 0, 0), b(i + 1, 0, 0), c(i + 1, 1, 0), d(i, 1, 0), none(nan_value);
        const Corners adversarial[] = {{a, a, a, a}, {a, b, a, b},    {a, 0.5 * (a + b), b, b},
                                       {a, c, b, d}, {a, b, c, none}, {a, b, Vec3(infinity), d}};
        add_face(setup.scene, adversarial[i % std::size(adversarial)]);
        add_face(setup.scene, {a, b, c, c, d});
    }
    return setup;
}

}  // namespace

std::vector<HardCase> polygon_cases() {
    struct Named {
        const char* name;
        Corners corners;
    };
    Rows rows("polygon");
    for (const Named& p :
         {Named{"quad", {tilted(0, 0, 1), tilted(2, 0, 1), tilted(2, 1, 1), tilted(0, 1, 1)}},
          Named{"star", star(7, 0.4)}, Named{"circle of 1e3", star(500, std::cos(turn / 1000))},
          Named{"notched", notched}, Named{"collinear corners", collinear},
          Named{"star at 3e5", moved(star(5, 0.3), far_place())}}) {
        const Corners corners = rounded(p.corners);
        rows.add_both("POL-1", p.name, [=] { return aimed_at_face(corners, 1); });
    }
    rows.add_both("POL-1", "notched, at its lattice", [] { return at_lattice(notched); });
    rows.add_both("POL-1", "collinear corners, at their lattice",
                  [] { return at_lattice(collinear); });
    rows.add_both("POL-1", "within the plane", [] { return along_face(notched, 4); });
    for (const int k : {6, 3}) {
        rows.add_both("POL-2", "off the plane by " + power_of_ten(-k),
                      [k] { return aimed_at_face(rounded(bent(std::pow(10.0, -k))), 1); });
    }
    rows.add(
        "SPN-5", "star", [] { return aimed_at_face(star(7, 0.4), 1); }, Criterion::spawned);
    rows.add(
        "SPN-5", "off the plane by 1e-6", [] { return aimed_at_face(bent(1e-6), 1); },
        Criterion::spawned);
    rows.add(
        "SPN-5", "star at 3e5", [] { return aimed_at_face(moved(star(5, 0.3), far_place()), 1); },
        Criterion::spawned);
    return rows.take();
}

std::vector<HardCase> polygon_group_cases() {
    Rows rows("scene");
    for (const auto& [name, place] : {std::pair{"two with a shared edge", Vec3(0)},
                                      std::pair{"two with a shared edge at 3e5", far_place()}}) {
        const auto make = [place = place] { return shared_edge(place); };
        rows.add_both("POL-1", name, make);
        rows.add_both("POL-1", std::string(name) + ": leaks", make, Criterion::enclosed);
    }
    rows.add("POL-2", "degenerate neighbours", degenerate_neighbours);
    return rows.take();
}

}  // namespace etalon::hard
