#include "tests/intersect/shapes/families.h"

namespace etalon {

ShapeCase cone_case(const std::string& name, const Cone& shape) {
    const Vec3 h = shape.top - shape.base;
    const double length = std::sqrt(h.dot(h));
    const double widest = std::max(shape.base_radius, shape.top_radius);
    ShapeCase c{name, {}, 0.5 * (shape.base + shape.top), length + widest, true, {}, {}};
    c.scene.geometry.add(shape, 0);
    const auto on_circle = [shape, h, length](double s, double angle) {
        Vec3 u, v;
        orthonormal_basis(h / length, u, v);
        const double r = shape.base_radius + s * (shape.top_radius - shape.base_radius);
        return shape.base + s * h + r * (std::cos(angle) * u + std::sin(angle) * v);
    };
    c.targets.push_back({"surface", [=](Random& random, const Vec3&) {
                             return on_circle(random.uniform(), random.uniform(0, 2 * pi));
                         }});
    c.targets.push_back({"axis", [=](Random& random, const Vec3&) {
                             return shape.base + random.uniform(-0.1, 1.1) * h;
                         }});
    c.targets.push_back({"rim", [=](Random& random, const Vec3&) {
                             const double end = random.index(2) == 0 ? 0 : nearly_one(random);
                             return on_circle(end, random.uniform(0, 2 * pi));
                         }});
    c.targets.push_back({"silhouette", [=](Random& random, const Vec3& from) {
                             // Where the normal, outward - (spread / length) axis, is perpendicular
                             // to the line of sight: outward . f = r + spread (f . h) / length^2.
                             Vec3 u, v;
                             orthonormal_basis(h / length, u, v);
                             const double s = random.uniform();
                             const double spread = shape.top_radius - shape.base_radius;
                             const Vec3 f = from - (shape.base + s * h);
                             const double x = f.dot(u), y = f.dot(v);
                             const double needed = shape.base_radius + s * spread +
                                                   spread * f.dot(h) / (length * length);
                             const double cosine = needed / std::hypot(x, y) * nearly_one(random);
                             const double opening = std::acos(std::clamp(cosine, -1.0, 1.0));
                             return on_circle(s, std::atan2(y, x) + random.sign() * opening);
                         }});
    if (shape.top_radius == 0) {
        c.tips.push_back(shape.top);
        c.targets.push_back({"apex", [=](Random& random, const Vec3&) {
                                 const double miss = std::pow(10.0, random.uniform(-18, 0));
                                 return shape.top + miss * widest * random.direction();
                             }});
    }
    return c;
}

std::vector<ShapeCase> cone_cases() {
    return {
        cone_case("cylinder", {base, base + tilted(0, 0, 21.4), 1, 1}),
        cone_case("cylinder along an axis", {{0, 0, 0}, {0, 3, 0}, 0.5, 0.5}),
        cone_case("cylinder, needle", {base, base + tilted(0, 0, 1e3), 1e-3, 1e-3}),
        cone_case("cone", {base, base + tilted(0, 0, 2), 1, 0}),
        cone_case("cone along an axis", {{0, 0, 0}, {0, 0, 2}, 1, 0}),
        cone_case("cone, truncated", {base, base + tilted(0, 0, 3), 0.5, 1.5}),
        cone_case("cone, all but a cylinder", {base, base + tilted(0, 0, 3), 1, 1 + 0x1p-40}),
        cone_case("cone, all but a disk", {base, base + tilted(0, 0, 1e-4), 1, 0}),
        cone_case("cone, far from the origin", {far_away, far_away + tilted(0, 0, 3), 2, 1}),
    };
}

}  // namespace etalon
