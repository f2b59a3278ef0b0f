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

/// How the points of a pixel lie: evenly, or, to compare with, each wherever it falls.
enum class Sampler : std::uint8_t { sobol, random };

/// Place of the rays of an image without samples (spp 0).
enum class PixelRays : std::uint8_t {
    centre,         ///< one through each pixel's centre
    upper_left,     ///< one through each pixel's upper left corner
    shared_corners  ///< one through each corner, which counts for all the pixels about it
};

/// How the Whitted integrator follows the rules of a scene's format where formats differ.
struct WhittedRules {
    bool schlick = false;         ///< Schlick's approximation instead of the Fresnel equations
    bool clamp_each_ray = false;  ///< clamp to [0,1] what each ray returns
    bool normalize_camera_rays =
        false;  ///< divide what a camera ray returns by its largest part above 1
    /// Counts rays by the rules of the Standard Procedural Databases: a mirrored ray wherever
    /// light passes through a surface, even one of no weight.
    bool mirror_all_glass = false;
    /// Distance, in units of the scene, at which new rays start from the surface along its normal,
    /// only to reproduce old programs. 0: as far as the surface's own error bound asks.
    double fixed_bias = 0;
};

struct RenderSettings {
    // Film
    Imath::V2i resolution{0, 0};  ///< width and height in pixels
    Imath::Box2i crop;            ///< pixels to render, inclusive on both ends; empty: all
    PixelFilter filter;
    double max_sample_luminance = infinity;  ///< brighter samples are darkened to it
    double film_scale = 1;                   ///< factor of the image's values, after that
    bool variance = false;                   ///< keep what the variance of each pixel needs
    bool display_colors = false;  ///< colours are display values already: no sRGB curve for PNG
    /// Images and their errors are in those values, not in the light that they stand for.
    bool keep_display_values = false;

    // Samples
    int samples_per_pixel = 0;                 ///< 0: one deterministic ray, see pixel_rays
    PixelRays pixel_rays = PixelRays::centre;  ///< no effect above 0 samples per pixel
    Sampler sampler = Sampler::sobol;
    std::uint64_t seed = 0;
    /// Of the samples of each pixel the share number `part`, from 1, of `parts`.
    int part = 1, parts = 1;
    double target_error = 0;  ///< above 0: the relMSE at which the image is good enough; samples
                              ///< go where they help, samples_per_pixel at most

    // Integrator
    std::string integrator = "whitted";  ///< a name of core/integrators/integrators.h
    int max_depth = 5;                   ///< maximum path length, including the camera ray
    double max_distance = infinity;      ///< range of occluders, for ambient occlusion
    bool direct_lighting = false;        ///< light from lights alone, and in mirrors and glass
    bool ask_all_lights = false;         ///< at each vertex, instead of one
    /// What a path must expect to carry lest it may be ended by chance.
    float roulette_threshold = 1;
    WhittedRules whitted;

    std::string backend;  ///< name of the intersection backend; empty: the program's default

    /// Returns whether an image has the light that the film's display values stand for.
    bool decodes() const { return display_colors && !keep_display_values; }

    /// The first sample of the part, and the one after its last; of an image without a number of
    /// samples there is one.
    std::pair<std::uint32_t, std::uint32_t> sample_range() const {
        const std::uint64_t all = std::max(1, samples_per_pixel);
        return {static_cast<std::uint32_t>(all * (part - 1) / parts),
                static_cast<std::uint32_t>(all * part / parts)};
    }

    /// Pixels to render, inclusive on both ends.
    Imath::Box2i window() const {
        return crop.isEmpty() ? Imath::Box2i({0, 0}, resolution - Imath::V2i(1)) : crop;
    }
};

}  // namespace etalon
