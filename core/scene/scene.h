// What a scene is: plain data, filled by a loader, read by everything else.
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

/// How the scene's format wants to be shaded where formats differ.
struct WhittedRules {
    int max_depth = 5;            ///< rays in a row, the eye's ray included
    bool schlick = false;         ///< Schlick's approximation instead of the Fresnel equations
    bool clamp_each_ray = false;  ///< clamp to [0,1] what each ray returns
    bool fit_eye_rays = false;    ///< divide what an eye's ray returns by its largest part above 1
    /// To count rays by the rules of the Standard Procedural Databases: a mirrored ray wherever
    /// light passes through a surface, even one of no weight.
    bool mirror_all_glass = false;
    /// Only to reproduce old programs: how far, in units of the scene, new rays start from the
    /// surface along its normal. 0: as far as the surface's own error bound asks.
    double fixed_bias = 0;
};

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

    WhittedRules whitted;
    int samples_per_pixel = 0;    ///< 0: one ray through each pixel's centre
    bool display_colors = false;  ///< colours are display values already: no sRGB curve for PNG
    std::string backend;          ///< the scene's own choice, or empty
};

/// Bytes held by the scene's arrays.
std::size_t memory_bytes(const Scene& scene);

}  // namespace etalon
