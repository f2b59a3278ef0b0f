// Rays whose tmin or tmax is exactly at a hit, or at the next number.
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {
namespace {

constexpr int count = 6;

/// Returns unit boxes on a lattice of spacing 2: faces are at integers.
Scene boxes() {
    Scene scene;
    for (int i = 0; i < count * count * count; ++i) {
        const Vec3 p(i % count, i / count % count, i / count / count);
        scene.geometry.add(Box{2.0 * p, 2.0 * p + Vec3(1)}, 0);
    }
    return scene;
}

/// Returns a number, or the float or double before or after it.
template <class Number>
double beside(double t, std::size_t step) {
    const auto limit = static_cast<Number>(infinity);
    const auto number = static_cast<Number>(t);
    if (step == 0) return number;
    return std::nextafter(number, step == 1 ? -limit : limit);
}

/// A line along an axis from an integer distance, through the centre of a box: it hits faces at an
/// integer t, times a power of two.
struct Passage {
    explicit Passage(Random& random) {
        Vec3 d = axis_direction(random);
        const int axis = dominant_axis(d);
        Vec3 through;
        for (int k = 0; k < 3; ++k)
            through[k] = 2.0 * static_cast<double>(random.index(count)) + 0.5;
        const double face = 2.0 * static_cast<double>(random.index(count)) + (d[axis] > 0 ? 0 : 1);
        const auto distance = static_cast<double>(1 + random.index(1000));
        through[axis] = face - distance * d[axis];
        const double speed = std::ldexp(1.0, static_cast<int>(random.index(21)) - 10);
        ray = {through, speed * d};
        entry = distance / speed;
        exit = (distance + 1) / speed;
    }

    Ray ray;
    double entry, exit;  ///< t at which it enters and leaves one of the boxes
};

template <class Number>
Ray ending_at_hit(Random& random) {
    Passage p(random);
    const double t = random.index(2) == 0 ? p.entry : p.exit;
    p.ray.tmax = beside<Number>(t, random.index(3));
    return p.ray;
}

template <class Number>
Ray starting_at_hit(Random& random) {
    Passage p(random);
    const double t = random.index(2) == 0 ? p.entry : p.exit;
    p.ray.tmin = beside<Number>(t, random.index(3));
    return p.ray;
}

/// Returns a ray with both tmin and tmax, between which there is at most one face.
template <class Number>
Ray between_neighbours(Random& random) {
    Passage p(random);
    const double t = random.index(2) == 0 ? p.entry : p.exit;
    p.ray.tmin = beside<Number>(t, random.index(3));
    p.ray.tmax = beside<Number>(t, random.index(3));
    return p.ray;
}

/// Returns a ray with a negative tmin and a box behind its origin, which must not be hit.
Ray starting_behind(Random& random) {
    Passage p(random);
    p.ray.tmin = -4 * p.exit;
    p.ray.origin += (p.exit + 0.5 * (p.exit - p.entry)) * p.ray.direction;
    return p.ray;
}

using MakeRangedRay = Ray (*)(Random&);

struct Limits {
    const char* name;
    MakeRangedRay among_doubles, among_floats;
};

constexpr Limits limits[] = {
    {"tmax at the hit", ending_at_hit<double>, ending_at_hit<float>},
    {"tmin at the hit", starting_at_hit<double>, starting_at_hit<float>},
    {"both at the hit", between_neighbours<double>, between_neighbours<float>},
    {"tmin behind the origin", starting_behind, starting_behind},
};

}  // namespace

std::vector<HardCase> range_cases() {
    Rows rows("scene");
    for (const Limits& l : limits) {
        const auto make = [](MakeRangedRay ray) {
            return [ray] { return CaseSetup{boxes(), 1, ray, 0}; };
        };
        rows.add("TRG-1", l.name, make(l.among_doubles));
        rows.add_in_float("TRG-1", l.name, make(l.among_floats));
    }
    return rows.take();
}

}  // namespace etalon::hard
