#include "core/bsdf/fresnel_moments.h"

#include <array>

namespace etalon {
namespace {

/// Evaluates the polynomial with these coefficients, the constant one first.
template <std::size_t count>
float polynomial(const std::array<float, count>& coefficients, float x) {
    float value = 0;
    for (std::size_t k = count; k-- > 0;) value = value * x + coefficients[k];
    return value;
}

}  // namespace

float fresnel_moment1(float eta) {
    return eta < 1 ? polynomial<6>({0.45966F, -1.73965F, 3.37668F, -3.904945F, 2.49277F, -0.68441F},
                                   eta)
                   : polynomial<6>({-4.61686F, 11.1136F, -10.4646F, 5.11455F, -1.27198F, 0.12746F},
                                   eta);
}

float fresnel_moment2(float eta) {
    if (eta < 1) {
        return polynomial<6>({0.27614F, -0.87350F, 1.12077F, -0.65095F, 0.07883F, 0.04860F}, eta);
    }
    return polynomial<4>({-547.033F, 458.843F, -218.725F, 45.3087F}, 1 / eta) +
           polynomial<6>({0, 404.557F, -189.519F, 54.9327F, -9.00603F, 0.63942F}, eta);
}

}  // namespace etalon
