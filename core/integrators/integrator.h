// Interface between the renderer, which asks for the colours of samples, and what computes them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/integrators/ray_counts.h"
#include "core/intersect/ray_stream.h"
#include "core/sampling/sample_source.h"

namespace etalon {

/// Samples of pixels, side by side: of each its ray, and where the choices on the ray's way come
/// from.
struct CameraSamples {
    RayStream rays;
    std::span<const SampleSource> sources;
    /// What colours count for in the image, which is not the integrators' business; empty where all
    /// count alike.
    std::span<const float> weights{};
};

/// Computes what camera rays see. Thread-safe.
class Integrator {
  public:
    Integrator() = default;
    virtual ~Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    /// Number of samples that an integrator does best to get at a time: enough to share the cost of
    /// a call, few enough to stay in a core's cache.
    static constexpr std::size_t batch_size = 512;

    /// Sets `colors`, one for each sample, to be averaged with the others of the pixel. Adds the
    /// rays that it takes, the camera rays included, to `counts`. A colour does not depend on the
    /// other samples.
    virtual void radiance(const CameraSamples& samples, std::span<Color> colors,
                          RayCounts& counts) const = 0;

    /// Whether camera rays may meet lights.
    virtual bool shows_lights() const { return false; }

    /// Sets `colors` to the part of the samples' colours that comes straight from lights. Black
    /// where an integrator shows none.
    virtual void emission(const CameraSamples& samples, std::span<Color> colors) const;

    /// Why parts of the scene were replaced after rendering began: a face of a skybox whose file
    /// turned out damaged when it was first seen by the background's colour.
    virtual std::vector<std::string> late_problems() const { return {}; }
};

}  // namespace etalon
