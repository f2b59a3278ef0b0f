#pragma once

#include "core/bsdf/bsdf_from.h"

namespace etalon {

/// Scattering at one point: see BsdfFrame, LobeList and BsdfFrom.
class Bsdf {
  public:
    Bsdf(const Vec3& ng, const Vec3& ns, const Vec3& tangent) : frame_(ng, ns, tangent) {}
    Bsdf(const BsdfFrame& frame, const LobeList& lobes) : frame_(frame), lobes_(lobes) {}

    template <class AnyLobe>
    void add(const AnyLobe& lobe) {
        lobes_.add(lobe);
    }

    Evaluation evaluate(const Vec3& wo, const Vec3& wi) const {
        return BsdfFrom(frame_, lobes_, wo).evaluate(wi);
    }
    std::optional<BsdfSample> sample(const Vec3& wo, float lobe_choice, const Vec2& uv) const {
        return BsdfFrom(frame_, lobes_, wo).sample(lobe_choice, uv);
    }
    Color albedo(const Vec3& wo) const { return BsdfFrom(frame_, lobes_, wo).albedo(); }

    bool is_smooth() const { return lobes_.has_smooth(); }
    const Vec3& ng() const { return frame_.ng; }
    const Vec3& ns() const { return frame_.ns; }
    std::span<const Lobe> lobes() const { return lobes_.span(); }

  private:
    BsdfFrame frame_;
    LobeList lobes_;
};

}  // namespace etalon
