// Tracers for the rays of a hard case: backends, a kernel alone, or a textbook's kernel.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/intersect/intersector.h"
#include "core/scene/scene.h"

namespace etalon::accuracy {

/// A ray in float precision.
struct FloatRay {
    explicit FloatRay(const Ray& r)
        : origin(r.origin),
          direction(r.direction),
          tmin(static_cast<float>(r.tmin)),
          tmax(static_cast<float>(r.tmax)) {}

    Vec3f origin, direction;
    float tmin, tmax;
};

/// A float ray with data that renderers precompute once for all primitives.
struct PreparedRay : FloatRay {
    explicit PreparedRay(const Ray& r)
        : FloatRay(r),
          inverse(1 / direction.x, 1 / direction.y, 1 / direction.z),
          kz(dominant_axis(Vec3(direction))),
          kx((kz + 1) % 3),
          ky((kz + 2) % 3),
          shear(direction[kx] / direction[kz], direction[ky] / direction[kz], inverse[kz]) {}

    Vec3f inverse;  ///< for slab tests (Williams et al. 2005, JGT 10(1))
    int kz, kx, ky;
    Vec3f shear;  ///< for triangles (Woop, Benthin & Wald 2013, JCGT 2(1))
};

/// Rays in every form that a tracer may need, so that conversions are not part of the measured
/// time.
struct RayBlock {
    explicit RayBlock(std::vector<Ray> list);

    std::vector<Ray> rays;
    std::vector<RayQuery> queries;
    std::vector<FloatRay> floats;
    std::vector<PreparedRay> prepared;
};

/// Answer of a tracer to a ray; a miss has no primitive.
using Answer = Hit;
inline constexpr Answer missed{0, no_index};

class Tracer {
  public:
    explicit Tracer(std::string name) : name_(std::move(name)) {}
    virtual ~Tracer() = default;
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    const std::string& name() const { return name_; }

    /// Traces all rays of the block; this is what is timed. Thread-safe.
    virtual void closest(const RayBlock& block, std::span<Answer> answers) const = 0;

    /// Returns whether each ray hits anything; by default, whether closest() finds something.
    virtual void occluded(const RayBlock& block, std::span<char> answers) const;

  private:
    std::string name_;
};

/// A backend over a scene, which must outlive it.
std::unique_ptr<Tracer> backend_tracer(const Backend& backend, const Scene& scene);

/// Returns the project's kernel of the scene's only primitive, called in a plain loop; null if the
/// scene is not one primitive.
std::unique_ptr<Tracer> kernel_tracer(const Scene& scene);

/// Returns the kernels of textbooks and other renderers for the scene's only primitive: first the
/// plain kernel in float, to which the cost of all others is relative. Names are like "float
/// textbook". Empty if the scene is not one primitive.
std::vector<std::unique_ptr<Tracer>> textbook_tracers(const Scene& scene);

}  // namespace etalon::accuracy
