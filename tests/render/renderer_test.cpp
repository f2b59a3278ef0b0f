#include <cmath>
#include <numbers>

#include "core/parallel/parallel.h"
#include "core/shading/fresnel.h"
#include "tests/catch.h"
#include "tests/render/test_images.h"
#include "tests/render/test_scenes.h"

using namespace etalon;
using namespace etalon::test;

TEST_CASE("Every exact backend and any thread count give the same bits by every integrator",
          "[render]") {
    TestScene scene = mixed_scene();
    scene.settings.integrator = GENERATE(from_range(integrators_for(mixed_scene())));
    CAPTURE(scene.settings.integrator);
    const Rendering reference = rendered(scene, reference_backend);
    for (const Backend& backend : all_backends()) {
        if (!backend.exact) continue;
        for (const int threads : {1, 2}) {
            INFO(backend.name << " with " << threads << " threads");
            const ThreadLimit limit(threads);
            const Rendering other = rendered(scene, backend.name);
            CHECK(other.film.pixels() == reference.film.pixels());
            CHECK(other.counts == reference.counts);
        }
    }
}

TEST_CASE("A scene scaled by a power of two gives the same bits by every integrator", "[render]") {
    TestScene scene = mixed_scene();
    scene.settings.integrator = GENERATE(from_range(integrators_for(mixed_scene())));
    CAPTURE(scene.settings.integrator);
    for (const double factor : {0x1p20, 0x1p-20}) {
        const TestScene other = transformed(scene, factor);
        for (const Backend& backend : all_backends()) {
            if (!backend.exact) continue;
            INFO(backend.name << " scaled by " << factor);
            CHECK(image(other, backend.name) == image(scene));
        }
    }
}

TEST_CASE("A scene scaled by any power of two from 2^-20 to 2^20 gives the same bits", "[render]") {
    const TestScene scene = mixed_scene(24, 18);
    for (int k = -20; k <= 20; ++k) {
        INFO("scaled by 2^" << k);
        CHECK(image(transformed(scene, std::ldexp(1.0, k))) == image(scene));
    }
}

// Camera rays hit the same to the bit (tests/backends); secondary rays start from positions that
// are rounded to 2^-33 of the scene.
TEST_CASE("A scene moved by 2^20 of its extents gives nearly the same image", "[render]") {
    const Vec3 far_away(0x1p20, -0x1p20, 0x1p20);
    const TestScene moved = transformed(mixed_scene(), 1, far_away);
    const TestScene scene = transformed(moved, 1, -far_away);
    const std::vector<Color> here = image(scene), there = image(moved);
    int different = 0;
    double sum = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
        const Color d = there[i] - here[i];
        const double off = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        different += off > 1e-5;
        sum += off;
    }
    const double mean = sum / static_cast<double>(here.size());
    CAPTURE(different, mean);
    CHECK(different == 0);
    CHECK(mean < 1e-7);
}

TEST_CASE("A crop holds the same pixels as the whole", "[render]") {
    TestScene scene = mixed_scene();
    const std::vector<Color> all = image(scene);
    scene.settings.crop = {{7, 5}, {20, 30}};
    const std::vector<Color> part = image(scene);
    std::size_t i = 0;
    for (int y = 5; y <= 30; ++y) {
        for (int x = 7; x <= 20; ++x) CHECK(part[i++] == all[y * scene.settings.resolution.x + x]);
    }
}

TEST_CASE("An integrator is found by its name, no two have the same", "[render]") {
    CHECK(find_integrator("paths") == nullptr);
    for (const IntegratorType& type : all_integrators()) {
        CHECK(find_integrator(type.name) == &type);
        CHECK_FALSE(type.summary.empty());
    }
    CHECK(find_integrator(RenderSettings().integrator) != nullptr);
}

TEST_CASE("Every part is played by a backend that can", "[render]") {
    for (const char* name : {default_backend, reference_backend, second_backend}) {
        REQUIRE(find_backend(name) != nullptr);
        CHECK(find_backend(name)->exact);
    }
    CHECK(default_backend != std::string(second_backend));
    REQUIRE(find_backend(baseline_backend) != nullptr);
    CHECK_FALSE(find_backend(baseline_backend)->exact);
    CHECK(&chosen_backend(RenderSettings()) == find_backend(default_backend));
}

TEST_CASE("Another seed gives another image of the same scene", "[render]") {
    TestScene scene = mixed_scene();
    const std::vector<Color> first = image(scene);
    scene.settings.seed = 1;
    CHECK(image(scene) != first);
}

TEST_CASE("A stop before the start renders nothing and is reported", "[render]") {
    const TestScene scene = mixed_scene();
    const std::atomic<bool> stop = true;
    RunControl control;
    control.stop = &stop;
    const Rendering r = render_with(scene, *find_backend(default_backend), scene.settings, control);
    CHECK_FALSE(r.complete);
    CHECK(r.samples == 0);
    CHECK(r.counts.camera == 0);
}

TEST_CASE("A matte surface sends back diffuse times cosine of each light", "[shading]") {
    TestScene scene = empty_scene();
    scene.whitted().materials = {matte(Color(0.5F))};
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 0, -1)}, 0);  // two-sided: seen from its back
    scene.whitted().lights = {PointLight{Vec3(3, 0, 4), Color(1.0F, 0.5F, 0.0F)}};
    CHECK(centre(scene).x == Approx(0.5 * 0.8));
    CHECK(centre(scene).y == Approx(0.25 * 0.8));
    scene.whitted().lights.push_back(PointLight{Vec3(0, 0, -4), Color(1.0F)});  // on the other side
    CHECK(centre(scene).x == Approx(0.5 * 0.8));
    scene.geometry.add(Sphere{Vec3(1.5, 0, 2), 0.1}, 0);  // in the way of the first
    CHECK(centre(scene) == Color(0.0F));
}

TEST_CASE("A light that lies on a surface is not hidden by it", "[shading]") {
    TestScene scene = empty_scene();
    scene.whitted().materials = {matte(Color(1.0F))};
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 0, 1)}, 0);
    scene.geometry.add(Plane{Vec3(0, 0, 10), Vec3(0, 0, 1)}, 0);  // behind the camera
    scene.whitted().lights = {PointLight{Vec3(0, 0, 10), Color(1.0F)}};
    CHECK(centre(scene).x == Approx(1));
}

TEST_CASE("A highlight is specular times (N.H)^shininess", "[shading]") {
    TestScene scene = empty_scene();
    Material shiny;
    shiny.specular = Color(0.5F);
    shiny.shininess = 10;
    scene.whitted().materials = {shiny};
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 0, 1)}, 0);
    scene.whitted().lights = {PointLight{Vec3(3, 0, 4), Color(1.0F)}};
    const double cosine = std::sqrt((1 + 0.8) / 2);  // cosine of half the angle between L and V
    CHECK(centre(scene).x == Approx(0.5 * std::pow(cosine, 10)));
}

TEST_CASE("A corner normal that leans away from the eye does not turn the light around",
          "[shading]") {
    TestScene scene = empty_scene();
    scene.whitted().materials = {matte(Color(1.0F))};
    scene.geometry.vertices = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 2, 0)};
    const Vec3 leaning = Vec3(-0.95, 0, 0.1).normalized();
    scene.geometry.normals = {leaning, leaning, leaning};
    scene.geometry.add(Triangle{{0, 1, 2}, 0}, 0);
    scene.camera.eye = Vec3(5, 0, 0.2);  // in front of the triangle, behind the normals' plane
    scene.whitted().lights = {PointLight{Vec3(-3, 0, 4), Color(1.0F)}};
    CHECK(centre(scene).x == Approx(leaning.dot(Vec3(-0.6, 0, 0.8))));
}

TEST_CASE("A mirror shows objects behind the camera, up to the maximum path length", "[shading]") {
    TestScene scene = empty_scene();
    Material mirror;
    mirror.reflection = Color(0.5F);
    scene.whitted().materials = {mirror};
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 0, 1)}, 0);
    CHECK(centre(scene).z == Approx(0.5));
    CHECK(centre(scene, 1) == Color(0.0F));
    scene.geometry.add(Plane{Vec3(0, 0, 10), Vec3(0, 0, 1)},
                       0);  // a second mirror: no light at all
    CHECK(centre(scene, 1000) == Color(0.0F));
}

TEST_CASE("Glass of index 1 is not there; absorption goes with the distance inside", "[shading]") {
    TestScene scene = empty_scene();
    scene.whitted().materials = {glass(1)};
    scene.geometry.add(Sphere{Vec3(0), 1.5}, 0);
    CHECK(centre(scene).z == Approx(1));
    scene.whitted().materials[0].absorption = Color(0.5F, 0.0F, 0.25F);
    CHECK(centre(scene).x == Approx(0.25 * std::exp(-0.5 * 3)));
    CHECK(centre(scene).y == Approx(0.5));
    CHECK(centre(scene).z == Approx(std::exp(-0.25 * 3)));
    scene.whitted().materials[0].absorption = Color(0.0F, 0.0F, 0.25F);
    CHECK(centre(scene).x == Approx(0.25));
    CHECK(centre(scene).z == Approx(std::exp(-0.25 * 3)));
}

TEST_CASE("A glass plate in an even environment neither takes nor gives light", "[shading]") {
    TestScene scene = empty_scene();
    scene.whitted().environment.background = Color(1.0F);
    scene.whitted().materials = {glass(1.5)};
    scene.geometry.add(Box{Vec3(-9, -9, -1), Vec3(9, 9, 1)}, 0);
    const double lost = std::pow(0.04, 11);  // light still in the plate after 12 rays
    CHECK(centre(scene, 12).x == Approx(1).margin(lost + 1e-6));
    CHECK(centre(scene, 2).x == Approx(0.04));  // reflected at the front; the rest is cut off
}

TEST_CASE("Clamping each ray keeps highlights from glowing through a mirror", "[shading]") {
    TestScene scene = empty_scene();
    scene.whitted().environment.background = Color(4.0F);
    Material mirror;
    mirror.reflection = Color(0.5F);
    scene.whitted().materials = {mirror};
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 0, 1)}, 0);
    CHECK(centre(scene).x == Approx(2));
    scene.settings.whitted.clamp_each_ray = true;
    CHECK(centre(scene).x == Approx(0.5));
    scene.geometry = {};
    CHECK(centre(scene).x == 1);
}

TEST_CASE("An ambient colour is seen without any light", "[render]") {
    TestScene scene = empty_scene();
    Material glowing;
    glowing.ambient = Color(0.25F, 0.5F, 0.75F);
    scene.whitted().materials = {glowing};
    scene.geometry.add(Sphere{Vec3(0), 1}, 0);
    CHECK(centre(scene) == glowing.ambient);
}

TEST_CASE("A highlight is a power of Blinn's or of Phong's angle", "[render]") {
    TestScene scene = empty_scene();
    Material shiny;
    shiny.specular = Color(1.0F);
    shiny.shininess = 3;
    scene.whitted().materials = {shiny};
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 0, 1)}, 0);
    // Seen along its normal, lit at 60 degrees from it.
    scene.whitted().lights = {PointLight{Vec3(std::sqrt(3.0), 0, 1), Color(1.0F)}};
    CHECK(centre(scene).x == Approx(std::pow(std::cos(std::numbers::pi / 6), 3)));
    scene.whitted().materials[0].highlight = Highlight::phong;
    CHECK(centre(scene).x == Approx(std::pow(0.5, 3)));
}
