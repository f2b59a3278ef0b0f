// Small scenes made in memory, for tests of the renderer.
#pragma once

#include "core/scene/render_settings.h"
#include "core/scene/transformed.h"

namespace etalon::test {

/// A scene with its settings.
struct TestScene : Scene {
    RenderSettings settings{};
};

inline TestScene transformed(TestScene scene, double factor, const Vec3& offset = Vec3(0)) {
    static_cast<Scene&>(scene) = etalon::transformed(std::move(scene), factor, offset);
    return scene;
}

inline Material matte(const Color& color) {
    Material m;
    m.diffuse = color;
    return m;
}

inline Material glass(double ior) {
    Material m;
    m.reflection = m.transmission = Color(1.0F);
    m.fresnel = true;
    m.ior = ior;
    return m;
}

/// Returns a scene with a camera at (0, 0, 5) that looks at the origin, and nothing else.
inline TestScene empty_scene(int width = 32, int height = 24) {
    TestScene scene;
    scene.format = "test";
    scene.camera = {Vec3(0, 0, 5), Vec3(0), Vec3(0, 1, 0), 45, 0, 1};
    scene.settings.resolution = {width, height};
    scene.whitted().environment.background = Color(0.25F, 0.5F, 1.0F);
    return scene;
}

/// Returns a scene with some of everything: mirror, glass, matte; spheres, a box, a cone, a mesh, a
/// plane; a point light and a quad light; a lens.
inline TestScene mixed_scene(int width = 48, int height = 36) {
    TestScene s = empty_scene(width, height);
    s.whitted().lights = {PointLight{Vec3(3, 6, 4), Color(0.6F)},
                          QuadLight{Vec3(-3, 4, 1), Vec3(1, 0, 0), Vec3(0, 0, 1), Color(0.5F), 9}};
    Material mirror = matte(Color(0.2F));
    mirror.specular = mirror.reflection = Color(0.7F);
    mirror.shininess = 40;
    s.whitted().materials = {matte(Color(0.8F, 0.6F, 0.3F)), mirror, glass(1.5)};
    s.geometry.vertices = {Vec3(-2, -1, -1), Vec3(-1, 1.3, -1.5), Vec3(0.2, -1, -1),
                           Vec3(1.7, 0.9, -2)};
    s.geometry.add(Plane{Vec3(0, -1, 0), Vec3(0, 1, 0)}, 0);
    s.geometry.add(Sphere{Vec3(-0.9, 0, 0), 0.7}, 2);
    s.geometry.add(Sphere{Vec3(0.9, 0.2, -0.5), 0.8}, 1);
    s.geometry.add(Triangle{{0, 1, 2}}, 0);
    s.geometry.add(Triangle{{1, 2, 3}}, 1);
    s.geometry.add(Box{Vec3(-0.2, -1, 0.8), Vec3(0.3, -0.4, 1.2)}, 0);
    s.geometry.add(Cone{Vec3(1.2, -1, 1), Vec3(1.3, 0.1, 1.1), 0.3, 0.1}, 1);
    const Vec3 across(0.2, 0.1, 0), forth(0, 0.05, -0.3);
    s.geometry.add(Ellipsoid({across, {-0.1, 0.4, 0}, forth, {0.2, 0.9, 0.3}}), 0);
    s.geometry.add(ClosedCylinder({across, forth, {0.1, 0.5, 0.2}, {-1.6, -0.9, 0.5}}), 2);
    s.camera.aperture = 3;
    s.settings.samples_per_pixel = 5;
    return s;
}

}  // namespace etalon::test
