#pragma once

#include <vector>

#include "core/intersect/ray_stream.h"
#include "core/render/camera_rays.h"
#include "tests/catch.h"
#include "tests/each_instruction_set.h"

namespace etalon::test {

/// Checks, for every instruction set, that rays that a camera makes together are those that it
/// makes one by one.
inline void check_rays_together(const CameraRays& camera) {
    std::vector<Vec2> pixels, lens;
    std::vector<Ray> alone;
    for (int i = 0; i < 131; ++i) {
        pixels.emplace_back(i * 1.37, 100 - i * 0.71);
        lens.emplace_back(i * 7 % 131 / 131.0, i / 131.0);
        alone.push_back(camera.ray(pixels.back(), lens.back()));
    }
    for_each_target([&] {
        RayBuffer together;
        together.make_room(alone.size());
        camera.rays(pixels, lens, together);
        for (std::size_t i = 0; i < alone.size(); ++i) {
            const Ray ray = together.view(alone.size())[i];
            CHECK(ray.origin == alone[i].origin);
            CHECK(ray.direction == alone[i].direction);
            CHECK(ray.exclude == no_index);
        }
    });
}

}  // namespace etalon::test
