#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"
#include "core/test_rays/targets.h"

namespace etalon::hard {
namespace {

const Box cube{{-1, -1, -1}, {1, 1, 1}};

Box odd_box() {
    return {rounded({0.1, -0.7, 0.3}), rounded({0.2, 1.9, 7.7})};
}

double size_of(const Box& b) {
    return std::max(max_abs(b.max - b.min), 1.0);
}

/// Rays along an axis through a point with `fixed` coordinates on faces, half of them moved to the
/// adjacent double.
CaseSetup along_axes(const Box& b, int fixed, double from, bool beside) {
    return only(b, size_of(b), [=](Random& random) {
        Vec3 target = on_faces(b, fixed, random);
        const Vec3 d = axis_direction(random);
        if (beside) {
            const int k = random.axis();
            target[k] = std::nextafter(target[k], random.sign() * infinity);
        }
        const Vec3 start = (from * size_of(b)) * d;
        return Ray{target - start, d};
    });
}

CaseSetup aimed(const Box& b, int fixed, double distance) {
    return only(b, size_of(b), [=](Random& random) {
        const Vec3 target = on_faces(b, fixed, random);
        const Vec3 origin = 0.5 * (b.min + b.max) + distance * size_of(b) * random.direction();
        return towards(origin, target);
    });
}

/// Rays through a point of a box without thickness; all numbers are small multiples of 1/8, so that
/// the line hits it exactly.
CaseSetup without_thickness(int flat_axes) {
    Box b{{-1, -1, -1}, {1, 1, 1}};
    for (int k = 0; k < flat_axes; ++k) b.min[k] = b.max[k] = 0.125 * (k + 1);
    return only(b, 1, [=](Random& random) {
        Vec3 target, direction;
        for (int k = 0; k < 3; ++k) {
            const double steps = static_cast<double>(random.index(17)) / 16;
            target[k] = b.min[k] + steps * (b.max[k] - b.min[k]);
            direction[k] = (static_cast<double>(random.index(9)) - 4) / 8;
        }
        if (direction == Vec3(0)) direction.x = 1;
        const double back = static_cast<double>(random.index(16));
        return Ray{target - back * direction, direction};
    });
}

/// Rays that start inside or on a face, an edge or a corner, in a random direction or along an
/// axis.
CaseSetup from_within(const Box& b, int fixed) {
    return only(b, size_of(b), [=](Random& random) {
        const Vec3 origin = on_faces(b, fixed, random);
        const Vec3 d = random.index(2) == 0 ? axis_direction(random) : random.direction();
        return Ray{origin, d};
    });
}

/// Rays along an axis, except for components so small that their inverse overflows.
CaseSetup denormal(double smallest) {
    return only(cube, 1, [=](Random& random) {
        Vec3 d = axis_direction(random);
        const int axis = dominant_axis(d);
        for (int i = 1; i < 3; ++i) {
            d[(axis + i) % 3] = random.sign() * smallest * static_cast<double>(random.index(3));
        }
        const Vec3 target = on_faces(cube, static_cast<int>(random.index(4)), random);
        Vec3 origin = target;
        origin[axis] = -3 * d[axis];
        return Ray{origin, d};
    });
}

void add_spawned(Rows& rows) {
    struct Spawner {
        const char* name;
        Box box;
    };
    const Vec3 far = far_place();
    for (const Spawner& s : {Spawner{"box", cube}, Spawner{"odd box", odd_box()},
                             Spawner{"box at 3e5", {far, far + Vec3(1, 2, 0.3)}}}) {
        const Box b = s.box;
        for (const double distance : {0.2, 10.0}) {
            const char* const side = distance < 1 ? ", inside" : ", outside";
            rows.add(
                "SPN-3", s.name + std::string(side),
                [=] { return distance < 1 ? from_within(b, 0) : aimed(b, 1, distance); },
                Criterion::spawned);
        }
    }
}

}  // namespace

std::vector<HardCase> box_cases() {
    const char* const places[] = {"inside", "face", "edge", "corner"};
    const Box odd = odd_box();
    Rows rows("box");
    for (int fixed = 1; fixed < 4; ++fixed) {
        const std::string place = places[fixed];
        rows.add_both("BOX-1", place, [=] { return along_axes(cube, fixed, 3, false); });
        rows.add("BOX-1", place + ", a double beside",
                 [=] { return along_axes(cube, fixed, 3, true); });
        rows.add_both("BOX-1", "odd, " + place, [=] { return along_axes(odd, fixed, 3, false); });
        for (const int k : {0, 1, 5}) {
            rows.add_both("BOX-2", place + " from " + power_of_ten(k),
                          [=] { return aimed(odd, fixed, std::pow(10.0, k)); });
        }
    }
    for (int axes = 1; axes <= 3; ++axes) {
        rows.add_both("BOX-3", "flat in " + std::to_string(axes),
                      [=] { return without_thickness(axes); });
    }
    for (int fixed = 0; fixed < 4; ++fixed) {
        rows.add_both("BOX-4", std::string("from ") + places[fixed],
                      [=] { return from_within(odd, fixed); });
    }
    rows.add_both("BOX-5", "components of 1e-40", [] { return denormal(1e-40); });
    rows.add("BOX-5", "components of 1e-310", [] { return denormal(1e-310); });
    rows.add("BOX-5", "components of 5e-324", [] { return denormal(5e-324); });
    add_spawned(rows);
    return rows.take();
}

}  // namespace etalon::hard
