#include <set>

#include "core/intersect/kernels.h"
#include "tests/catch.h"
#include "tests/intersect/kernel_classification.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

namespace {

void require_right_answers(int rays_per_case) {
    for (ShapeCase& shape : shape_cases()) {
        const Oracle oracle(shape.scene.geometry);
        Random random(1);
        int undecidable = 0, hits = 0;
        for (int i = 0; i < rays_per_case; ++i) {
            std::vector<Primitive> primitives = shape.scene.geometry.primitives.list();
            primitives[0].sides = static_cast<Sides>(random.index(3));
            shape.scene.geometry.primitives = PrimitiveRuns(primitives);
            const AimedRay aimed = aimed_ray(shape, i, random);
            const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(aimed.ray));
            const Classification classification = classify(shape, oracle, aimed.ray, t);
            CAPTURE(shape.name, *aimed.target, aimed.ray_generator, i, t);
            REQUIRE(classification != Classification::wrong);
            undecidable += classification == Classification::undecidable;
            hits += t <= infinity;
        }
        CAPTURE(shape.name, undecidable, hits, rays_per_case);
        REQUIRE(undecidable <= rays_per_case / 6);  // rays nearly parallel to their target
        REQUIRE(hits >= rays_per_case / 10);
    }
}

}  // namespace

TEST_CASE("Shape cases: given any kind of shape, then the table has rows of it") {
    std::set<std::string_view> kinds;
    for (const ShapeCase& shape : shape_cases()) {
        kinds.insert(kind_name(shape.scene.geometry.primitives[0].kind));
    }
    for (std::size_t kind = 0; kind < shape_kinds; ++kind) {
        const std::string_view name = kind_name(static_cast<ShapeKind>(kind));
        CAPTURE(name);
        CHECK(kinds.count(name) == 1);
    }
}

TEST_CASE("Kernels: given aimed rays, then hit, miss and t are the oracle's") {
    require_right_answers(1000);
}

TEST_CASE("Cones: given rays next to the tip, then t is right for a ray a few roundings away") {
    for (const ShapeCase& shape : shape_cases()) {
        const auto& targets = shape.targets;
        const auto tip = std::ranges::find(targets, "tip", &Target::name);
        if (tip == targets.end()) continue;
        const Oracle oracle(shape.scene.geometry);
        Random random(1);
        const int kinds = static_cast<int>(targets.size()),
                  kind = static_cast<int>(tip - targets.begin());
        for (int i = 0; i < 20000; ++i) {
            const Ray ray = aimed_ray(shape, kind + i * kinds, random).ray;
            const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(ray));
            CAPTURE(shape.name, i, t);
            REQUIRE(classify(shape, oracle, ray, t) != Classification::wrong);
        }
    }
}

TEST_CASE("Kernels: given very many aimed rays, then hit, miss and t are the oracle's", "[long]") {
    require_right_answers(100000);
}
