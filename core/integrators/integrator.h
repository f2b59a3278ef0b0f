// Interface between the renderer, which asks for the colour of samples, and what computes it.
#pragma once

#include "core/integrators/ray_counts.h"
#include "core/intersect/ray.h"
#include "core/sampling/sample_source.h"

namespace etalon {

/// Computes what a camera ray sees. Thread-safe.
class Integrator {
  public:
    Integrator() = default;
    virtual ~Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    /// The colour of one sample of a pixel, to be averaged with the pixel's others. Adds the rays
    /// that it takes, the camera ray included, to `counts`. Called once for each camera ray: what
    /// it leads to is traced without virtual calls.
    virtual Color radiance(const Ray& camera_ray, const SampleSource& sample,
                           RayCounts& counts) const = 0;
};

}  // namespace etalon
