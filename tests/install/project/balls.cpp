#include "balls.h"

#include <sstream>

namespace laboratory {
namespace {

using namespace etalon;

Scene empty_scene() {
    Scene scene;
    scene.format = "balls";
    Material grey;
    grey.diffuse = Color(0.7F);
    scene.whitted().materials.push_back(grey);
    return scene;
}

/// Adds a light and a camera that sees everything.
void complete(Scene& scene) {
    Box3 all;
    for (const Sphere& ball : scene.geometry.all<Sphere>()) {
        all.extendBy(Box3(ball.centre - Vec3(ball.radius), ball.centre + Vec3(ball.radius)));
    }
    const double distance = 3 * all.size().length();
    scene.camera = {all.center() + Vec3(0, 0, distance), all.center(), Vec3(0, 1, 0), 30};
    scene.whitted().lights.push_back(PointLight{all.center() + Vec3(distance), Color(1.0F)});
}

}  // namespace

LoadResult load_balls(const std::string& text, const std::string& path) {
    Scene scene = empty_scene();
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        Sphere ball;
        std::istringstream words(line);
        words >> ball.centre.x >> ball.centre.y >> ball.centre.z >> ball.radius;
        if (!words || !(ball.radius > 0)) {
            return {{}, {}, {{Severity::error, "ball", path, number, 1, "expected x y z radius"}}};
        }
        scene.geometry.add(ball, 0);
    }
    complete(scene);
    LoadResult result{std::move(scene)};
    result.settings.resolution = {160, 120};
    return result;
}

}  // namespace laboratory
