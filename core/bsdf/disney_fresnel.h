#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the fifth power of 1 - cos, by which Schlick 1994 interpolates between the values at
/// normal incidence and at grazing angles.
inline float schlick_weight(float cos) {
    const float m = std::clamp(1 - cos, 0.0F, 1.0F);
    return m * m * (m * m) * m;
}

/// Interpolates the reflectance between that of a dielectric and Schlick's approximation for a
/// metal.
struct DisneyFresnel {
    Color from_above;
    float metallic, eta;
    Color operator()(float cos_incident) const;
};

}  // namespace etalon
