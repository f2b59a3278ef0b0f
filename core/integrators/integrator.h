// Interface between the renderer, which needs the colours of samples, and the integrators.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/integrators/ray_counts.h"
#include "core/intersect/ray_stream.h"
#include "core/sampling/sample_source.h"

namespace etalon {

class PhysicalShading;

/// Samples of neighbouring pixels: the camera ray of each and the source of its random numbers, in
/// spans of one length.
struct CameraSamples {
    RayStream rays;
    std::span<const SampleSource> sources;  ///< empty if Integrator::uses_sources() is false
    /// Weights of the colours in the image, which integrators need not apply; empty if all are
    /// equal.
    std::span<const float> weights{};
};

/// Computes the radiance along camera rays. Thread-safe.
class Integrator {
  public:
    Integrator() = default;
    virtual ~Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    /// Number of samples that are best computed in one call: enough to share its cost, few enough
    /// to stay in a core's cache.
    static constexpr std::size_t batch_size = 1024;

    /// Sets `colors`, one for each sample, to be averaged with the others of the pixel. Adds the
    /// number of rays, including camera rays, to `counts`. A colour does not depend on the other
    /// samples.
    virtual void radiance(const CameraSamples& samples, std::span<Color> colors,
                          RayCounts& counts) const = 0;

    /// Returns whether radiance() or emission() uses CameraSamples::sources.
    virtual bool uses_sources() const { return true; }

    /// Returns whether camera rays may hit lights.
    virtual bool shows_lights() const { return false; }

    /// Sets `colors` to the part of the samples' colours that is emitted by lights that camera rays
    /// hit. Black if shows_lights() is false.
    virtual void emission(const CameraSamples& samples, std::span<Color> colors) const;

    /// Returns the evaluated materials of a physical look, or null if the integrator needs none.
    virtual const PhysicalShading* shading() const { return nullptr; }

    /// Returns why parts of the scene were replaced after rendering began: the face of a skybox
    /// whose file turned out to be damaged when it was first needed, by the background's colour.
    virtual std::vector<std::string> late_problems() const { return {}; }
};

}  // namespace etalon
