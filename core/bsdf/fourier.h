#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/bsdf/evaluation.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/local_direction.h"
#include "core/scene/fourier_table.h"

namespace etalon {

/// Scattering by a table, which must outlive it. One table has reflection and transmission.
class FourierScattering {
  public:
    static constexpr LobeKind kind = LobeKind::both;

    explicit FourierScattering(const FourierTable& table)
        : table_(std::bit_cast<PointerWords>(&table)) {}

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const;
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) { factor_ *= by; }

  private:
    /// A pointer as words, aligned like the members of other lobes, so that the lobe is no larger.
    using PointerWords = std::array<std::uint32_t, sizeof(void*) / sizeof(std::uint32_t)>;

    const FourierTable& table() const { return *std::bit_cast<const FourierTable*>(table_); }

    PointerWords table_;
    Color factor_{1};
};

}  // namespace etalon
