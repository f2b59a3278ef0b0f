#include "tests/intersect/shapes/families.h"

namespace etalon {

ShapeCase sphere_case(const std::string& name, const Sphere& s) {
    ShapeCase c{name, {}, s.centre, s.radius, true, {}, {}};
    c.scene.geometry.add(s, 0);
    c.targets.push_back({"inside", [s](Random& random, const Vec3&) {
                             return s.centre + random.uniform() * s.radius * random.direction();
                         }});
    c.targets.push_back({"surface", [s](Random& random, const Vec3&) {
                             return s.centre + s.radius * random.direction();
                         }});
    c.targets.push_back({"centre", [s](Random&, const Vec3&) { return s.centre; }});
    c.targets.push_back({"silhouette", [s](Random& random, const Vec3& from) {
                             const Vec3 f = from - s.centre;
                             const double distance = std::sqrt(f.dot(f));
                             Vec3 u, v;
                             orthonormal_basis(f / distance, u, v);
                             const double cosine = std::min(1.0, s.radius / distance);
                             const double sine = std::sqrt(1 - cosine * cosine);
                             const double angle = random.uniform(0, 2 * pi);
                             const Vec3 side = std::cos(angle) * u + std::sin(angle) * v;
                             const double reach = s.radius * nearly_one(random);
                             return s.centre + reach * (cosine * f / distance + sine * side);
                         }});
    return c;
}

std::vector<ShapeCase> sphere_cases() {
    return {
        sphere_case("sphere", {{0.3, -0.7, 0.45}, 1}),
        sphere_case("sphere, planet", {{0, 0, -6.4e6}, 6.4e6}),
        sphere_case("sphere, far from the origin", {far_away, 2}),
    };
}

}  // namespace etalon
