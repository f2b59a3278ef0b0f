// Light that a beam, which enters a medium along its surface's normal, lets come out of the
// surface: Habel, Christensen & Jarosz 2013, "Photon Beam Diffusion: A Hybrid Monte Carlo Method
// for Subsurface Scattering", as in Pharr, Jakob & Humphreys 2016, section 15.5. pbrt-v3's numbers.
#pragma once

namespace etalon {

/// A medium whose extinction is 1 per unit of length, below a smooth border.
struct HalfSpace {
    float albedo;  ///< part of what meets it that it scatters, 0 to 1
    float g;       ///< mean cosine of scattering
    float eta;     ///< index below the border over that above
};

/// Power per area at a distance from the beam by light that was scattered more than once.
float multiple_scattering(const HalfSpace& medium, float distance);

/// The same by light that was scattered once.
float single_scattering(const HalfSpace& medium, float distance);

}  // namespace etalon
