// Scene description: plain data, filled by a loader, read by everything else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/environment.h"
#include "core/scene/geometry.h"
#include "core/scene/light.h"
#include "core/scene/material.h"

namespace etalon {

/// How surfaces and light look, as the Whitted-style formats mean it: a light has neither falloff
/// nor cosine.
struct WhittedLook {
    std::vector<Material> materials;
    std::vector<Light> lights;
    Environment environment;
};

struct Scene {
    std::string format;  ///< "p3f", ...
    Camera camera;
    Geometry geometry;
    WhittedLook look;
};

/// Bytes held by the scene's arrays.
std::size_t memory_bytes(const Scene& scene);

}  // namespace etalon
