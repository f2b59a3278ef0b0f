// Light of a beam that enters a medium along its surface's normal and leaves the surface elsewhere:
// Habel, Christensen & Jarosz 2013, "Photon Beam Diffusion: A Hybrid Monte Carlo Method for
// Subsurface Scattering", as in Pharr, Jakob & Humphreys 2016, section 15.5. The numbers are
// pbrt-v3's.
#pragma once

namespace etalon {

/// A medium whose extinction is 1 per unit of length, below a smooth interface.
struct HalfSpace {
    float albedo;  ///< fraction of extinguished light that is scattered, 0 to 1
    float g;       ///< mean cosine of scattering
    float eta;     ///< index below the interface over that above
};

/// Returns the power per area at a distance from the beam of light that was scattered more than
/// once.
float multiple_scattering(const HalfSpace& medium, float distance);

/// The same for light that was scattered once.
float single_scattering(const HalfSpace& medium, float distance);

}  // namespace etalon
