#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "core/bsdf/lobe.h"

namespace etalon {

/// A direction chosen for `wo`. A path's throughput is multiplied by f |wi.ns| / pdf.
struct BsdfSample {
    Vec3 wi;  ///< unit
    Color f;
    float pdf;      ///< density by solid angle; of a specular lobe the probability of the choice
    bool specular;  ///< no other direction has a part in it, and `evaluate` knows nothing of it
    bool transmission;  ///< through the surface
    bool turned;        ///< between the horizons of the geometric and the shading normal
    float eta;  ///< index on the side of `wi` over that on the side of `wo`; 1 for a reflection
};

/// How one point scatters light: up to eight lobes, whose values are added. All directions are unit
/// vectors of the world that point away from the surface; `wo` is that to the eye. Whether light is
/// reflected or transmitted is decided by the geometric normal, cosines are to the shading normal.
///
/// Remembers how its lobes are chosen for the last `wo`: not for two threads at a time.
class Bsdf {
  public:
    static constexpr std::size_t capacity = 8;

    /// `ng` and `ns`: unit normals, geometric and shading, not turned to the eye; what lies on
    /// their side is above. `tangent`: x of the lobes once made orthogonal to `ns`; any of a length
    /// of 0 or along `ns` stands for an arbitrary one.
    Bsdf(const Vec3& ng, const Vec3& ns, const Vec3& tangent);
    Bsdf(const Bsdf& other);
    Bsdf& operator=(const Bsdf&) = delete;
    ~Bsdf() = default;

    /// Adds a lobe; one beyond the capacity is left out.
    void add(const Lobe& lobe) {
        if (count_ < capacity) std::construct_at(lobes_.data() + count_++, lobe);
        picked_for_ = Vec3f(0);
    }

    /// Multiplies the lobes from number `first` on.
    void scale_lobes(std::size_t first, const Color& by);

    /// Value and density of the smooth lobes.
    Evaluation evaluate(const Vec3& wo, const Vec3& wi) const;

    /// Chooses a lobe by `lobe_choice` and of it a direction by `uv`, all in [0, 1). Nothing where
    /// the choice carries no light.
    std::optional<BsdfSample> sample(const Vec3& wo, float lobe_choice, const Vec2& uv) const;

    /// Whether any lobe is not specular.
    bool is_smooth() const;

    /// Estimate of the part of the light from `wo` that is scattered.
    Color albedo(const Vec3& wo) const;

    const Vec3& ng() const { return ng_; }
    const Vec3& ns() const { return ns_; }
    std::span<const Lobe> lobes() const { return {lobes_.data(), count_}; }

  private:
    /// Probabilities with which lobes are chosen.
    struct Picks {
        std::array<float, capacity> of;

        /// The lobe for `choice` in [0, 1); one with a probability above 0 if there is any.
        std::size_t chosen(float choice, std::size_t count) const;
    };

    Vec3 to_local(const Vec3& w) const;
    Vec3 to_world(const Vec3& w) const;
    const Picks& picks(const Vec3f& wo) const;
    LobeKind side(const Vec3& wo, const Vec3& wi) const;
    Evaluation evaluate_local(const Picks& picks, const Vec3f& wo, const Vec3f& wi,
                              LobeKind side) const;
    std::optional<BsdfSample> sample_smooth(const Picks& picks, const Vec3& wo,
                                            const Vec3f& local_wo, Vec3f local_wi,
                                            std::optional<LobeKind> diffuse_side) const;
    std::optional<BsdfSample> sample_specular(float pick,
                                              const std::optional<SpecularSample>& chosen) const;

    Vec3 ng_, ns_, x_, y_;
    std::size_t count_ = 0;
    mutable Vec3f picked_for_{0};  // local wo of picks_; 0 for none
    mutable Picks picks_;
    union {
        std::array<Lobe, capacity> lobes_;  // the first count_ live
    };
};

}  // namespace etalon
