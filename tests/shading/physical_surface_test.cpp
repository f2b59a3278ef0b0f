#include "core/shading/physical_surface.h"

#include "tests/catch.h"

using namespace etalon;

namespace {

/// A triangle in the plane z = 0 with these normals at its corners, and coordinates of a mesh.
Geometry triangle(const Vec3& normal, const std::array<std::array<float, 2>, 3>& uvs) {
    Geometry g;
    g.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)};
    g.normals = {normal, normal, normal};
    for (const auto& uv : uvs) g.uvs.push_back(uv);
    g.add(Triangle{{0, 1, 2}, 0}, 0);
    return g;
}

Parametrization coordinates(const std::array<std::array<float, 2>, 3>& uvs) {
    const Parametrization own{Vec2(0.5, 0.25), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    return with_coordinates_of_mesh(triangle(Vec3(0, 0, 1), uvs), 0, 0, own);
}

}  // namespace

TEST_CASE("Physical surface: given normals at corners, then the front is theirs if the format says",
          "[shading]") {
    const Vec3 along(0, 0, 1);  // by the order of the corners
    for (const bool flipped : {false, true}) {
        for (const bool by_corners : {false, true}) {
            for (const double side : {1.0, -1.0}) {
                const Vec3 leaning = side * normalized(Vec3(1, 0, 2));
                Scene scene;
                PhysicalLook look;
                look.bindings.resize(1);
                look.bindings[0].flipped = flipped;
                look.bindings[0].corner_normals = by_corners;
                scene.look = look;
                scene.geometry = triangle(leaning, {});
                const Ray ray{Vec3(0.75, 0.25, 1), Vec3(0, 0, -1)};
                const PhysicalSurface at = physical_surface(scene, ray, {1, 0});
                const double turned = flipped ? -1 : 1;
                CAPTURE(flipped, by_corners, side);
                CHECK((at.ns - turned * leaning).length() < 1e-15);
                CHECK(at.ng == turned * (by_corners ? side : 1) * along);
                CHECK(at.binding == &scene.physical().bindings[0]);
            }
        }
    }
}

TEST_CASE("Coordinates of a mesh: given those of the corners, then derivatives are by them",
          "[shading]") {
    // u = 2 + 4 y, v = 1 - 2 x
    const Parametrization at = coordinates({{{2, 1}, {2, -1}, {6, -1}}});
    CHECK(at.uv == Vec2(3, 0));
    CHECK(at.dpdu == Vec3(0, 0.25, 0));
    CHECK(at.dpdv == Vec3(-0.5, 0, 0));
}

TEST_CASE("Coordinates of a mesh: given nearly equal ones, then derivatives are those of pbrt-v3",
          "[shading]") {
    const Parametrization at = coordinates({{{3, 4}, {3, 4}, {3, 4}}});
    CHECK(at.uv == Vec2(3, 4));
    CHECK(at.dpdu == Vec3(0, -1, 0));
    CHECK(at.dpdv == Vec3(-1, 0, 0));
    CHECK(coordinates({{{0, 0}, {1e-4F, 0}, {1e-4F, 9e-5F}}}).dpdu == Vec3(0, -1, 0));
    CHECK(coordinates({{{0, 0}, {1e-4F, 0}, {1e-4F, 2e-4F}}}).dpdu.x == Approx(1e4));
}
