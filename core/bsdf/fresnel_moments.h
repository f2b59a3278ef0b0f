#pragma once

namespace etalon {

/// Return the integrals over the cosine c, from 0 to 1, of Fresnel's reflectance times c and c^2.
/// `eta` is the index on the incident side over that beyond. Polynomials of d'Eon & Irving 2011, "A
/// Quantized-Diffusion Model for Rendering Translucent Materials".
float fresnel_moment1(float eta);
float fresnel_moment2(float eta);

}  // namespace etalon
