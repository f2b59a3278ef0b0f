// Scenes written as PBRT v3: camera, materials and lights.
#include <filesystem>

#include "core/color/srgb.h"
#include "core/convert/physical_scene.h"
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"
#include "tests/formats/written_pbrt.h"

using namespace etalon;
namespace fs = std::filesystem;

TEST_CASE("a scene of every feature becomes one that PBRT's parser takes") {
    for (const auto& entry : fs::directory_iterator(ETALON_SOURCE_DIR "/scenes/features")) {
        if (entry.path().extension() != ".p3f") continue;
        CAPTURE(entry.path());
        converted(load_scene(entry.path().string()));
    }
}

TEST_CASE("the camera is turned right-handed, its angle is that of the shorter side") {
    const auto wide = converted(load_statements(""));
    CHECK(find(wide, "Scale").numbers == std::vector<double>{-1, 1, 1});
    CHECK(find(wide, "LookAt").numbers == std::vector<double>{0, 0, 5, 0, 0, 0, 0, 1, 0});
    CHECK(number(find(wide, "Camera"), "float fov") == 45);
    CHECK(number(find(wide, "Film"), "integer xresolution") == 40);
    CHECK(number(find(wide, "Integrator"), "integer maxdepth") == physical_depth - 1);
    CHECK(number(find(wide, "Sampler"), "integer pixelsamples") == physical_samples);
    std::string tall = good_camera;
    tall.replace(tall.find("40 30"), 5, "30 60");
    const double fov = number(find(converted(load_p3f_text(tall)), "Camera"), "float fov");
    CHECK(std::tan(fov * M_PI / 360) == Approx(std::tan(22.5 * M_PI / 180) / 2));
}

TEST_CASE("a lens has its radius and its plane of focus") {
    std::string text = good_camera + "spp 4\n";
    text.replace(text.find("aperture 0\nfocal 1"), 18, "aperture 3\nfocal 2");
    const auto list = converted(load_p3f_text(text));
    const double pixel = 2 * 5 * std::tan(22.5 * M_PI / 180) / 30;
    CHECK(number(find(list, "Camera"), "float lensradius") == Approx(1.5 * pixel));
    CHECK(number(find(list, "Camera"), "float focaldistance") == Approx(10));
    CHECK(number(find(list, "Sampler"), "integer pixelsamples") == 4);
}

TEST_CASE("materials become the nearest of PBRT's") {
    const auto types = [](const std::string& statement) {
        Strings list;
        for (const Directive& d : converted(load_statements(statement + "\ns 0 0 0 1\n"))) {
            if (d.name == "MakeNamedMaterial") list.push_back(d.values.at("string type")[0]);
        }
        return list;
    };
    CHECK(types("mat 1 1 1 0.5 1 1 1 0 10 0 1") == Strings{"\"matte\""});
    CHECK(types("mat 0 0 0 0 1 1 1 0 10 1 1.5") == Strings{"\"glass\""});
    CHECK(types("mat 1 1 1 0.5 1 1 1 0.5 10 0 1") == Strings{"\"uber\"", "\"mirror\"", "\"mix\""});
    CHECK(types("mat 1 1 1 0.5 1 1 1 -0.5 10 0 1") == Strings{"\"matte\""});
}

TEST_CASE("a light is as bright at the point looked at as it was") {
    const auto list = converted(load_statements("l 0 0 2 0.5 0.25 1\nl 3 0 0 1 1 1"));
    const Directive& light = find(list, "LightSource");
    CHECK(light.type == "point");
    CHECK(number(light, "rgb I") == Approx(srgb_decoded(0.5) * M_PI * 4));
    const auto area = converted(load_statements("light quad 0 0 2 1 1 1 2 0 2 0 2 2 9"));
    CHECK(number(find(area, "AreaLightSource"), "rgb L") ==
          Approx(M_PI * 6 / 4 / (2 / std::sqrt(6.0))));
}

TEST_CASE("what PBRT cannot say is listed") {
    const LoadResult r =
        load_objects("bclr 1 1 1\nl 0 0 2 1 1 1\ns 0 0 0 -1\npl 0 0 0 1 0 0 0 1 0\n");
    CHECK(names_of(write_pbrt(*r.scene, r.settings, "").lost) ==
          Strings{"background that lights nothing, now one that does",
                  "light that does not fall off, now one that does",
                  "shape of which one side is seen", "infinite plane, now a large square"});
}
