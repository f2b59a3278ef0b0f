// Lights, transformed by the current matrix.
#include "core/formats/sce/sce_loader.h"

namespace etalon::sce {
namespace {

bool is_placed(Reader& in, const Vec3& a, const Vec3& b = Vec3(0), const Vec3& c = Vec3(0)) {
    if (is_finite(a) && is_finite(b) && is_finite(c)) return true;
    in.warn("matrix", "'{}' left out: its position is not finite", in.keyword());
    return false;
}

}  // namespace

void read_point_light(Loader& loader, Reader& in) {
    const Vec3 position = loader.state.matrix.point(in.vector("position"));
    const Color color = in.color("colour");
    if (!in.ok() || !is_placed(in, position)) return;
    loader.scene.whitted().lights.emplace_back(PointLight{position, color});
}

/// Reads a square about the origin in the plane of x and y. Each sample of a pixel uses one point
/// of it. The points of a pixel are well distributed over the square, and a single one is its
/// centre.
void read_area_light(Loader& loader, Reader& in) {
    const double w = in.number("half side");
    const Color color = in.color("colour");
    const Affine& m = loader.state.matrix;
    const QuadLight light{m.point({-w, -w, 0}), m.vector({2 * w, 0, 0}), m.vector({0, 2 * w, 0}),
                          color, 1};
    if (!in.ok() || !is_placed(in, light.corner, light.edge1, light.edge2)) return;
    loader.scene.whitted().lights.emplace_back(light);
}

}  // namespace etalon::sce
