// Compares surface points computed for several hits at a time with single ones, for every
// instruction set that the code is compiled for and this machine has.
#include "core/intersect/surface_group.h"

#include <cstring>

#include "core/intersect/kernels.h"
#include "tests/each_instruction_set.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

bool same_bits(const Vec3& a, const Vec3& b) {
    return std::memcmp(&a, &b, sizeof(Vec3)) == 0;
}

/// Compares the points of some of the hits with surface_at(). Returns the number computed together.
int check_group(const Geometry& geometry, std::span<const Ray> rays, std::span<const Hit> hits,
                std::span<const std::uint32_t> numbers) {
    RayBuffer columns;
    Vec3Buffer directions, positions, errors, normals, shading_normals;
    columns.make_room(rays.size());
    for (auto* to : {&directions, &positions, &errors, &normals, &shading_normals}) {
        to->make_room(rays.size());
    }
    for (std::size_t i = 0; i < rays.size(); ++i) columns.set(i, rays[i]);
    std::vector<std::uint32_t> padded_numbers(numbers.begin(), numbers.end());
    padded_numbers.resize(numbers.size() + padded_doubles, 0);
    const SurfaceGroup group{
        columns.view(rays.size()), hits.data(),      padded_numbers.data(), numbers.size(),
        directions.span(),         positions.span(), errors.span(),         normals.span(),
        shading_normals.span()};
    const SurfacePoint any = surface_at(geometry, rays[numbers[0]], hits[numbers[0]]);
    const std::uint64_t decided = find_surfaces(geometry, geometry.primitives[0], any, group);
    int together = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if ((decided >> i & 1) == 0) continue;
        ++together;
        const Ray& ray = rays[numbers[i]];
        const Hit& hit = hits[numbers[i]];
        const SurfacePoint alone = surface_at(geometry, ray, hit);
        CAPTURE(i, numbers.size(), ray.origin, ray.direction, hit.t);
        CAPTURE(alone.position, positions[i], alone.normal, normals[i]);
        REQUIRE(same_bits(directions[i], ray.direction));
        REQUIRE(same_bits(positions[i], alone.position));
        REQUIRE(same_bits(errors[i], alone.error));
        REQUIRE(same_bits(normals[i], alone.normal));
        REQUIRE(same_bits(shading_normals[i], alone.shading_normal));
    }
    return together;
}

/// Returns the numbers of `count` rays, consecutive or with gaps between them.
std::vector<std::uint32_t> some_numbers(std::uint32_t count, bool all, Random& random) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (all || i == 0 || !random.one_in(6)) numbers.push_back(i);
    }
    return numbers;
}

/// These include rays with components so small that a RayQuery takes them as 0, and rays from very
/// far away.
Ray ray_at(const ShapeCase& shape, int i, Random& random) {
    Ray ray = aimed_ray(shape, i, random).ray;
    if (i % 50 == 0) ray.direction.x = 1e-200 * ray.direction.z;
    if (i % 50 == 1) ray.origin -= random.magnitude(9, 20) * ray.direction;
    return ray;
}

}  // namespace

TEST_CASE("Surfaces: points of hits found together are those found alone, to the bit") {
    for_each_target([] {
        for (const ShapeCase& shape : shape_cases()) {
            int found = 0, together = 0;
            const Geometry& geometry = shape.scene.geometry;
            if (!has_surface_group(geometry, geometry.primitives[0])) continue;
            CAPTURE(shape.name);
            Random random(21);
            std::vector<Ray> rays;
            std::vector<Hit> hits;
            std::size_t size = 1;
            for (int i = 0; i < 8000; ++i) {
                const Ray ray = ray_at(shape, i, random);
                if (!is_valid(ray)) continue;
                const double t = primitive_first_hit(geometry, 0, RayQuery(ray));
                if (!(t <= ray.tmax)) continue;
                rays.push_back(ray);
                hits.push_back({t, 0});
                if (rays.size() < size) continue;
                const auto numbers =
                    some_numbers(static_cast<std::uint32_t>(rays.size()), random.one_in(2), random);
                together += check_group(geometry, rays, hits, numbers);
                found += static_cast<int>(numbers.size());
                size = size % SurfaceGroup::most + 1;
                rays.clear();
                hits.clear();
            }
            // All but those on edges, and of triangles that are thin or seen from the side.
            const bool is_sliver = shape.name == "triangle, sliver";
            if (!is_sliver) CHECK(5 * together > found);
        }
    });
}
