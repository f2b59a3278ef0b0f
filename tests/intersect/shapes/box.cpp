#include "tests/intersect/shapes/families.h"

namespace etalon {
namespace {

ShapeCase box(const std::string& name, const Box& b) {
    const Vec3 size = b.max - b.min;
    ShapeCase c{name, {}, 0.5 * (b.min + b.max), size.length() / 2, true, {}, {}};
    c.scene.geometry.add(b, 0);
    // A point with `fixed` of its coordinates on faces: 1 a face, 2 an edge, 3 a corner.
    const auto on_faces = [b, size](Random& random, int fixed) {
        const int first = random.axis();
        Vec3 p;
        for (int i = 0; i < 3; ++i) {
            const int k = (first + i) % 3;
            const double inside = b.min[k] + random.uniform() * size[k];
            p[k] = i >= fixed ? inside : random.index(2) == 0 ? b.min[k] : b.max[k];
        }
        return p;
    };
    const char* const names[] = {"inside", "face", "edge", "corner"};
    for (int fixed = 0; fixed < 4; ++fixed) {
        c.targets.push_back(
            {names[fixed], [=](Random& random, const Vec3&) { return on_faces(random, fixed); }});
    }
    return c;
}

}  // namespace

std::vector<ShapeCase> box_cases() {
    return {
        box("box", {{-1, -1, -1}, {1, 1, 1}}),
        box("box, odd", {{0.1, -0.7, 0.3}, {0.2, 1.9, 7.7}}),
        box("box, no thickness", {{-1, 0.1, -1}, {1, 0.1, 2}}),
        box("box, far from the origin", {far_away, far_away + Vec3(1, 2, 0.3)}),
    };
}

}  // namespace etalon
