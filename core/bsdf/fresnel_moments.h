#pragma once

namespace etalon {

/// Integrals over the cosine c, from 0 to 1, of Fresnel's reflectance times c and c^2. `eta`: index
/// before the border, where light comes from, over that beyond it. Polynomials: d'Eon & Irving
/// 2011, "A Quantized-Diffusion Model for Rendering Translucent Materials".
float fresnel_moment1(float eta);
float fresnel_moment2(float eta);

}  // namespace etalon
