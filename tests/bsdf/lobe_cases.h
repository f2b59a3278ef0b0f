#pragma once

#include <string>
#include <vector>

#include "core/bsdf/bsdf.h"

namespace etalon::test {

/// Some lobes that a surface may have together.
struct LobeCase {
    std::string name;
    std::vector<Lobe> lobes;
    /// True if scattering is the same with both directions exchanged. Of the model of hair it is
    /// not: the ways through it are those of one of the directions.
    bool is_reciprocal = true;
};

/// Every kind of lobe, and lobes together. All with reflectances and transmittances up to 1.
std::vector<LobeCase> lobe_cases();

/// A surface of these lobes whose normals and tangent are not the axes.
Bsdf bsdf_of(const std::vector<Lobe>& lobes);

/// Directions to the eye in the frame of that surface: from above, steep and grazing, from below.
std::vector<Vec3> eyes();

/// Index below the border that the surface's refracting facets make over that above it; 1 without.
double index_of(const std::vector<Lobe>& lobes);

/// Returns whether the facets that refract light from `eye` to `wi` turn their back to the eye:
/// their light is in the BSDF's value, and never drawn.
bool shows_backs(const std::vector<Lobe>& lobes, const Vec3& eye, const Vec3& wi);

/// From and to the frame of a surface, whose tangent is as bsdf_of has it.
Vec3 world(const Bsdf& bsdf, const Vec3& local);
Vec3 local(const Bsdf& bsdf, const Vec3& world);

}  // namespace etalon::test
