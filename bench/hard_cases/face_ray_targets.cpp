#include "bench/hard_cases/face_ray_targets.h"

#include <memory>

#include "bench/hard_cases/add_face.h"
#include "bench/hard_cases/ray_targets.h"
#include "core/test_rays/outline.h"

namespace etalon::hard {
namespace {

/// Returns a scene that ray generators can keep: they do not own the scene of a case setup.
std::shared_ptr<const Scene> scene_of(const Corners& corners) {
    const auto scene = std::make_shared<Scene>();
    add_face(*scene, corners);
    return scene;
}

}  // namespace

Corners rounded(Corners corners) {
    for (Vec3& corner : corners) corner = rounded(corner);
    return corners;
}

Corners moved(Corners corners, const Vec3& by) {
    for (Vec3& corner : corners) corner += by;
    return corners;
}

Corners star(int points, double inner) {
    Corners corners;
    for (int i = 0; i < 2 * points; ++i) {
        const double radius = i % 2 == 0 ? 1 : inner, angle = turn / 2 * i / points;
        corners.push_back(tilted(radius * std::cos(angle), radius * std::sin(angle), 0.25));
    }
    return corners;
}

CaseSetup only_face(const Corners& corners, double size, MakeRay ray) {
    CaseSetup setup{{}, size, std::move(ray)};
    add_face(setup.scene, corners);
    return setup;
}

CaseSetup aimed_at_face(const Corners& corners, double size) {
    return only_face(corners, size, [scene = scene_of(corners), size](Random& random) {
        const Feature feature = features[random.index(features.size())];
        const Vec3 target = point_of(Outline(scene->geometry, 0), feature, random);
        const double distance = size * random.magnitude(-1, 3);
        Ray ray = towards(target + distance * random.direction(), target);
        if (random.index(2) == 0) ray.direction *= random.uniform(0.5, 1);
        return ray;
    });
}

CaseSetup along_face(const Corners& corners, double size) {
    return only_face(corners, size, [scene = scene_of(corners)](Random& random) {
        const Outline face(scene->geometry, 0);
        const Feature feature = features[random.index(features.size())];
        const Vec3 target = point_of(face, feature, random);
        const Vec3 along = face[1] - face[0], across = face[2] - face[0];
        const double x = random.uniform(-2, 2), y = random.uniform(-2, 2);
        return towards(face[0] + x * along + y * across, target);
    });
}

}  // namespace etalon::hard
