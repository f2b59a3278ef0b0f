#include "bench/accuracy/spawned_rays.h"

#include <cmath>
#include <numbers>

#include "core/intersect/kernels.h"

namespace etalon::accuracy {

std::optional<Spawned> spawn(const hard::CaseSetup& setup, const Ray& ray, const Answer& answer,
                             Random& random) {
    if (answer.primitive == no_index) return std::nullopt;
    const SurfacePoint p = surface_at(setup.scene.geometry, ray, answer);
    const double side = random.sign();
    const bool grazing = random.index(2) == 0;
    const double cosine = grazing ? random.magnitude(-6, 0) : random.uniform(0.01, 1);
    const double angle = random.uniform(0, 2 * std::numbers::pi),
                 sine = std::sqrt(1 - cosine * cosine);
    Vec3 u, v;
    orthonormal_basis(p.normal, u, v);
    const Vec3 direction =
        side * cosine * p.normal + sine * (std::cos(angle) * u + std::sin(angle) * v);
    const Vec3 origin = spawn_origin(p, direction);
    const double shift = (origin - p.position).length() / setup.size;
    Ray left{origin, direction};
    left.set_time(p.time);
    return Spawned{left, key_of(answer.primitive, answer.instance), side > 0, shift};
}

bool is_self_hit(const Scene& scene, const Spawned& spawned, const Answer& answer) {
    if (key_of(answer.primitive, answer.instance) != spawned.from) return false;
    if (spawned.outward) return true;
    return surface_at(scene.geometry, spawned.ray, answer).normal.dot(spawned.ray.direction) <= 0;
}

}  // namespace etalon::accuracy
