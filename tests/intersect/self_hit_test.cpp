#include "core/intersect/kernels.h"
#include "core/numerics/exact.h"
#include "tests/catch.h"
#include "tests/intersect/kernel_classification.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

namespace {

/// Returns a direction in the hemisphere of `up`; half of them are grazing, with cosines from 1e-6.
Vec3 grazing_direction(const Vec3& up, Random& random) {
    Vec3 u, v;
    orthonormal_basis(up, u, v);
    const double cosine =
        random.index(2) == 0 ? random.uniform(0.01, 1) : std::pow(10.0, random.uniform(-6, 0));
    const double angle = random.uniform(0, 6.283185307179586);
    return cosine * up +
           std::sqrt(1 - cosine * cosine) * (std::cos(angle) * u + std::sin(angle) * v);
}

struct Spawned {
    Ray ray;
    bool outward;
};

std::optional<Spawned> spawn(const ShapeCase& shape, const Ray& ray, Random& random) {
    const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(ray));
    if (!(t <= infinity)) return std::nullopt;
    const SurfacePoint p = surface_at(shape.scene.geometry, ray, {t, 0});
    for (const Vec3& tip : shape.tips) {
        if ((p.position - tip).length() < 1e-9 * shape.size) return std::nullopt;
    }
    const double side = random.sign();
    const Vec3 direction = grazing_direction(side * p.normal, random);
    return Spawned{{spawn_origin(p, direction), direction}, side > 0};
}

/// Returns whether the hit is on another part of a quadric or a surface of revolution, which may be
/// in any direction but not so close.
bool is_elsewhere(const ShapeCase& shape, const Spawned& s, double t) {
    const ShapeKind kind = shape.scene.geometry.primitives[0].kind;
    const bool is_curved = kind == kind_of<Quadric>() || kind == kind_of<Revolved>();
    return is_curved && t * s.ray.direction.length() > 1e-9 * shape.size;
}

/// No other shape of the table is hit again from outside. A ray inside a closed shape leaves it
/// elsewhere: it must hit the inner side, where the oracle finds it.
bool hits_itself(const ShapeCase& shape, const Oracle& oracle, const Spawned& s) {
    const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(s.ray));
    const bool hit = t <= infinity;
    const OracleAnswer answer = oracle.closest(s.ray);
    const bool truly_hit = answer.kind == OracleAnswer::hit;
    if (hit && is_elsewhere(shape, s, t))
        return classify(shape, oracle, s.ray, t) == Classification::wrong;
    if (s.outward) return hit || truly_hit;
    if (hit && surface_at(shape.scene.geometry, s.ray, {t, 0}).normal.dot(s.ray.direction) < 0)
        return true;
    return classify(shape, oracle, s.ray, t) == Classification::wrong;
}

void require_no_self_hits(int rays_per_case) {
    for (const ShapeCase& shape : shape_cases()) {
        const Oracle oracle(shape.scene.geometry);
        Random random(2);
        int spawned = 0;
        for (int i = 0; i < rays_per_case; ++i) {
            const AimedRay aimed = aimed_ray(shape, i, random);
            const auto s = spawn(shape, aimed.ray, random);
            if (!s) continue;
            ++spawned;
            const Vec3 &o = s->ray.origin, &d = s->ray.direction;
            CAPTURE(shape.name, *aimed.target, aimed.ray_generator, i, s->outward, o, d);
            REQUIRE_FALSE(hits_itself(shape, oracle, *s));
        }
        CAPTURE(shape.name);
        REQUIRE(spawned > rays_per_case / 5);
    }
}

}  // namespace

TEST_CASE(
    "spawn_origin: given a hit, then the ray that leaves it does not meet its surface again") {
    require_no_self_hits(800);
}

TEST_CASE("spawn_origin: given very many hits, then none is hit again", "[long]") {
    require_no_self_hits(80000);
}

TEST_CASE("spawn_origin: given shapes of unit size at the origin, then the shift is small") {
    for (const ShapeCase& shape : shape_cases()) {
        // Rays leave a curve by its width.
        if (shape.scene.geometry.primitives[0].kind == kind_of<Curve>()) continue;
        if (max_abs(shape.centre) > 100 || shape.size > 100) continue;
        Random random(3);
        for (int i = 0; i < 200; ++i) {
            const Ray ray = aimed_ray(shape, i, random).ray;
            const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(ray));
            if (!(t <= infinity)) continue;
            const SurfacePoint p = surface_at(shape.scene.geometry, ray, {t, 0});
            const double shift = (spawn_origin(p, p.normal) - p.position).length();
            const double extent = shape.size + max_abs(shape.centre) + max_abs(p.position);
            CAPTURE(shape.name, shift);
            REQUIRE(shift <= 5e-14 * extent);
        }
    }
}

TEST_CASE("spawn_origin: given planes tilted by a rounding, then a ray leaves on its own side") {
    constexpr double rounding = 6.123233995736766e-17;  // the cosine of a right angle in doubles
    Random random(5);
    for (const Vec3& normal : {Vec3(0, 1, rounding), Vec3(rounding, 1, -rounding),
                               Vec3(0, rounding, 1), Vec3(1, 0, rounding)}) {
        for (const Ring& ring : {Ring{{0, 0, 0}, normal, 0, 20}, Ring{{3, -2, 1}, normal, 0, 20}}) {
            Scene scene;
            scene.geometry.add(ring, 0);
            for (int i = 0; i < 20000; ++i) {
                const Vec3 origin = 5.0 * random.in_cube();
                const Vec3 target =
                    ring.centre + std::pow(10.0, random.uniform(-4, 1)) * random.in_cube();
                const Ray ray{origin, target - origin};
                const double t = primitive_first_hit(scene.geometry, 0, RayQuery(ray));
                if (!(t <= infinity)) continue;
                const SurfacePoint p = surface_at(scene.geometry, ray, {t, 0});
                for (const double side : {1.0, -1.0}) {
                    const Vec3 start = spawn_origin(p, side * p.normal);
                    CAPTURE(normal, ring.centre, i, ray.origin, ray.direction, side);
                    REQUIRE(side * exact_dot(normal, start, ring.centre) > 0);
                }
            }
        }
    }
}
