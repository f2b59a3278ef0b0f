#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/frames/measure_frame.h"
#include "bench/frames/recorded_rays.h"
#include "core/integrators/integrator.h"
#include "core/intersect/intersector.h"
#include "core/intersect/packet_intersector.h"
#include "core/render/renderer.h"
#include "core/scene/scene.h"

namespace etalon::frames {

/// Measures one frame with one backend repeatedly.
class Frame {
  public:
    /// Renders the frame twice, first cold and then to record about so many of its rays. The scene
    /// must outlive this.
    Frame(const Scene& scene, const RenderSettings& settings, const FrameConfig& config,
          std::uint64_t rays_to_record);

    /// Measures all stages once more. Returns why the image cannot be written, or nothing.
    std::string measure_again(const FrameConfig& config);

    /// Returns the medians, apart from what belongs to the scene. There must be repeats.
    FrameFigures figures() const;

    bool has_repeats() const { return !repeats_.empty(); }

    /// Returns why images of the scene were replaced.
    const std::vector<std::string>& problems() const { return problems_; }

  private:
    /// CPU seconds of the stages that are measured repeatedly.
    struct Repeat {
        double build, render, intersection, film, camera, write;
    };

    FrameFigures medians() const;
    std::unique_ptr<Intersector> built() const;
    std::unique_ptr<Integrator> made(const BatchIntersector& intersector,
                                     std::vector<std::string>& problems) const;
    Rendering rendered(const Integrator& integrator) const;

    const Scene& scene_;
    const RenderSettings settings_;
    const RunControl control_;
    const std::unique_ptr<Intersector> backend_;
    const PacketIntersector intersector_;
    std::vector<std::string> problems_;
    std::unique_ptr<Integrator> integrator_;
    std::optional<Rendering> first_;
    double first_seconds_ = 0;
    std::optional<RecordedRays> recorded_;
    std::vector<Repeat> repeats_;
};

}  // namespace etalon::frames
