#pragma once

#include <string>
#include <vector>

#include "core/bsdf/bsdf.h"

namespace etalon::test {

/// Lobes that a surface may have together.
struct LobeCase {
    std::string name;
    std::vector<Lobe> lobes;
    /// True if the BSDF is symmetric. The model of hair is not: its light paths are those of one of
    /// the directions.
    bool is_reciprocal = true;
};

/// Returns every kind of lobe, and combinations. All have reflectances and transmittances up to 1.
std::vector<LobeCase> lobe_cases();

/// Returns a surface of these lobes whose normals and tangent are not the axes.
Bsdf bsdf_of(const std::vector<Lobe>& lobes);

/// Returns directions to the eye in the frame of that surface: from above, steep and grazing, from
/// below.
std::vector<Vec3> eyes();

/// Returns the index below the interface of the surface's refracting facets over that above it; 1
/// without any.
double index_of(const std::vector<Lobe>& lobes);

/// Returns whether the facets that refract light from `eye` to `wi` face away from the eye: their
/// light is in the BSDF's value, but never sampled.
bool shows_backs(const std::vector<Lobe>& lobes, const Vec3& eye, const Vec3& wi);

/// Convert from and to the frame of a surface, whose tangent is that of bsdf_of.
Vec3 world(const Bsdf& bsdf, const Vec3& local);
Vec3 local(const Bsdf& bsdf, const Vec3& world);

}  // namespace etalon::test
