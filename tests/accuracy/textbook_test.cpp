#include "bench/accuracy/tracer.h"
#include "core/intersect/kernels.h"
#include "core/numerics/random.h"
#include "core/scene/profiles.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::accuracy;

namespace {

template <class Shape>
Scene scene_of(const Shape& shape, LargeVector<Vec3> vertices = {}) {
    Scene scene;
    scene.geometry.vertices = std::move(vertices);
    scene.geometry.add(shape, 0);
    return scene;
}

/// One example of each shape and two cones, about a unit in size. All numbers are floats, so that a
/// kernel in float gets the same shape.
std::vector<Scene> scenes() {
    const std::array<Vec3, 5> notched = {
        {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 0, 0}, {-1, 1, 0}}};
    const Affine map{{1, 0.25, 0}, {0, -0.5, 0.25}, {0.25, 0, 1}, {0.25, 0, 0.5}};
    return {scene_of(Sphere{{0.25, 0, 0.5}, 1}),
            scene_of(Triangle{{0, 1, 2}}, {{-1, -1, 0}, {1, -0.5, 0.25}, {0, 1.5, -0.5}}),
            scene_of(Polygon{notched}), scene_of(Box{{-1, -0.5, -0.75}, {0.5, 1, 0.5}}),
            scene_of(Plane{{0, 0.5, 0}, {1, 2, -1}}),
            scene_of(Cone{{0, -1, 0.5}, {0.25, 1, 0}, 0.5, 1}),
            scene_of(Cone{{0, -1, 0.5}, {0.25, 1, 0}, 0.75, 0.75}),
            scene_of(Ring{{0.25, 0, 0.5}, {1, 2, -1}, 0.5, 1}),
            // x^2 + 2 y^2 + xy - z = 1/2
            scene_of(Quadric{
                {0.25, 0, 0}, {1, 0.5, 0, 0, 2, 0, 0, 0, -0.5, -0.5}, {{-1, -1, -1}, {1, 1, 1}}}),
            scene_of(Ellipsoid(map)), scene_of(ClosedCylinder(map)),
            scene_of(Revolved(map, profiles::cylinder(), Sector(270))),
            scene_of(Curve({{Vec3f(-1, 0, 0), Vec3f(-0.5F, 0.25F, 0), Vec3f(0.5F, 0.25F, 0.25F),
                             Vec3f(1, 0, 0)},
                            {1, 0.75F}},
                           map))};
}

Vec3 in_float(const Vec3& v) {
    return Vec3(Vec3f(v));
}

/// Returns a ray from a distance of about 3 to a point around the shape. Half of the rays have a
/// tmin and tmax, so that the first hit may be outside their range.
Ray random_ray(Random& random) {
    Ray ray{in_float(3.0 * random.direction()), {}};
    ray.direction = in_float(1.5 * random.in_cube() - ray.origin);
    if (random.sign() > 0) return ray;
    ray.tmin = static_cast<float>(random.uniform());
    ray.tmax = ray.tmin + static_cast<float>(random.uniform());
    return ray;
}

double first_t(const Scene& scene, const Ray& ray) {
    const double t = primitive_first_hit(scene.geometry, 0, RayQuery(ray));
    return t <= ray.tmax ? t : no_hit;
}

/// Returns whether the hit changes little when the ray is moved a little.
bool is_benign(const Scene& scene, const Ray& ray, Random& random) {
    const double t = first_t(scene, ray);
    for (int i = 0; i < 16; ++i) {
        Ray moved = ray;
        moved.origin += 1e-3 * random.in_cube();
        const double t_moved = first_t(scene, moved);
        if (std::isnan(t) != std::isnan(t_moved) || std::abs(t - t_moved) > 1e-2) return false;
    }
    return true;
}

RayBlock benign_rays(const Scene& scene) {
    std::vector<Ray> rays;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        Random random(7, i);
        const Ray ray = random_ray(random);
        if (is_benign(scene, ray, random)) rays.push_back(ray);
    }
    return RayBlock(std::move(rays));
}

std::vector<Answer> answers_of(const Tracer& tracer, const RayBlock& block) {
    std::vector<Answer> answers(block.rays.size());
    tracer.closest(block, answers);
    return answers;
}

}  // namespace

TEST_CASE("Every shape has a scene in this test") {
    std::array<bool, shape_kinds> seen{};
    for (const Scene& scene : scenes()) seen[scene.geometry.primitives.front().kind] = true;
    CHECK(std::count(seen.begin(), seen.end(), true) == shape_kinds);
}

TEST_CASE("Given benign rays, every textbook kernel agrees with the project's to its precision") {
    for (const Scene& scene : scenes()) {
        const RayBlock block = benign_rays(scene);
        const std::vector<Answer> expected = answers_of(*kernel_tracer(scene), block);
        for (const auto& tracer : textbook_tracers(scene)) {
            INFO(kind_name(scene.geometry.primitives.front().kind) << ", " << tracer->name());
            const std::vector<Answer> answers = answers_of(*tracer, block);
            const double tolerance = tracer->name().starts_with("double") ? 1e-13 : 5e-5;
            std::size_t hits = 0, other_class = 0;
            double worst = 0;
            for (std::size_t i = 0; i < answers.size(); ++i) {
                other_class += answers[i].primitive != expected[i].primitive;
                if (expected[i].primitive == no_index) continue;
                ++hits;
                worst = std::max(worst, std::abs(answers[i].t - expected[i].t) / expected[i].t);
            }
            CHECK(hits > 500);
            CHECK(answers.size() - hits > 500);
            CHECK(other_class == 0);
            CHECK(worst < tolerance);
        }
    }
}

TEST_CASE("The first textbook kernel of a shape is a plain one in float, and others follow") {
    for (const Scene& scene : scenes()) {
        const auto textbooks = textbook_tracers(scene);
        REQUIRE(textbooks.size() >= 2);
        CHECK_THAT(textbooks.front()->name(), ContainsSubstring("float"));
    }
}

TEST_CASE("The project's kernel as a tracer gives the bits that the backends get") {
    for (const Scene& scene : scenes()) {
        const RayBlock block = benign_rays(scene);
        const std::vector<Answer> answers = answers_of(*kernel_tracer(scene), block);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const double t = first_t(scene, block.rays[i]);
            REQUIRE(answers[i].primitive == (std::isnan(t) ? no_index : 0));
            if (!std::isnan(t)) REQUIRE(answers[i].t == t);
        }
    }
}

TEST_CASE("A kernel finds a ray occluded exactly where it finds a hit") {
    const Scene scene = scenes().front();
    const RayBlock block = benign_rays(scene);
    const auto tracer = kernel_tracer(scene);
    const std::vector<Answer> nearest = answers_of(*tracer, block);
    std::vector<char> occluded(block.rays.size());
    tracer->occluded(block, occluded);
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        REQUIRE((occluded[i] != 0) == (nearest[i].primitive != no_index));
    }
}

TEST_CASE("A scene that is not one primitive has no kernel by itself") {
    Scene two = scenes().front();
    two.geometry.add(Sphere{Vec3(0), 2}, 0);
    for (const Scene& scene : {Scene(), two}) {
        CHECK(kernel_tracer(scene) == nullptr);
        CHECK(textbook_tracers(scene).empty());
    }
}
