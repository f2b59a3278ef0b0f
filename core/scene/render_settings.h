// Settings of a rendering: filled by a loader, overridden by the command line, read by the
// renderer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "core/numerics/vec.h"
#include "core/scene/pixel_filter.h"

namespace etalon {

/// Sample generator of a pixel's points: well distributed (sobol), or independent (random), for
/// comparison.
enum class Sampler : std::uint8_t { sobol, random };

/// Place of the rays of an image without samples (spp 0).
enum class PixelRays : std::uint8_t {
    centre,         ///< one through each pixel's centre
    upper_left,     ///< one through each pixel's upper left corner
    shared_corners  ///< one through each corner, which counts for all pixels around it
};

/// Rules of the Whitted integrator where scene formats differ.
struct WhittedRules {
    bool schlick = false;         ///< Schlick's approximation instead of the Fresnel equations
    bool clamp_each_ray = false;  ///< clamp the colour of each ray to [0,1]
    bool normalize_camera_rays =
        false;  ///< divide the colour of a camera ray by its largest component above 1
    /// Counts rays by the rules of the Standard Procedural Databases: a reflected ray wherever
    /// light passes through a surface, even one of no weight.
    bool mirror_all_glass = false;
    /// Distance, in units of the scene, by which new rays are offset from the surface along its
    /// normal, only to reproduce old programs. 0 means: by the surface's own error bound.
    double fixed_bias = 0;
};

struct RenderSettings {
    // Film
    Imath::V2i resolution{0, 0};  ///< width and height in pixels
    Imath::Box2i crop;            ///< pixels to render, inclusive on both ends; empty: all
    PixelFilter filter;
    double max_sample_luminance = infinity;  ///< brighter samples are scaled down to it
    double film_scale = 1;                   ///< factor of the image's values, after that
    bool variance = false;                   ///< keep the sums that pixel variances need
    bool display_colors = false;  ///< colours are display values already: no sRGB curve for PNG
    /// Images and their errors are in display values, not in the light that they stand for.
    bool keep_display_values = false;

    // Samples
    int samples_per_pixel = 0;                 ///< 0: one deterministic ray, see pixel_rays
    PixelRays pixel_rays = PixelRays::centre;  ///< used if samples_per_pixel is 0
    Sampler sampler = Sampler::sobol;
    std::uint64_t seed = 0;
    /// Share number `part`, from 1, of `parts` shares of each pixel's samples.
    int part = 1, parts = 1;
    double target_error = 0;  ///< relMSE at which to stop, if above 0; samples go where they help
    ///< most, at most samples_per_pixel for each pixel

    // Integrator
    std::string integrator = "whitted";  ///< a name of core/integrators/integrators.h
    int max_depth = 5;                   ///< maximum path length, including the camera ray
    double max_distance = infinity;      ///< range of occluders, for ambient occlusion
    bool direct_lighting = false;        ///< only direct light, also in mirrors and glass
    bool sample_all_lights = false;      ///< sample all lights at each vertex, instead of one
    /// Expected contribution of a path below which Russian roulette may end it.
    float roulette_threshold = 1;
    WhittedRules whitted;

    std::string backend;  ///< name of the intersection backend; empty for the program's default

    /// Returns whether the image has the light for which the film's display values stand.
    bool decodes() const { return display_colors && !keep_display_values; }

    /// Returns the first sample of the part, and the one after its last. Without samples per pixel
    /// there is one.
    std::pair<std::uint32_t, std::uint32_t> sample_range() const {
        const std::uint64_t all = std::max(1, samples_per_pixel);
        return {static_cast<std::uint32_t>(all * (part - 1) / parts),
                static_cast<std::uint32_t>(all * part / parts)};
    }

    /// Returns the pixels to render, inclusive on both ends.
    Imath::Box2i window() const {
        return crop.isEmpty() ? Imath::Box2i({0, 0}, resolution - Imath::V2i(1)) : crop;
    }
};

}  // namespace etalon
