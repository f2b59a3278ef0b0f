#include "core/color/spectrum.h"

#include <algorithm>
#include <vector>

#include "core/color/cie_1931.h"

namespace etalon {
namespace {

/// Integral of y-bar as PBRT v3 has it, nm.
constexpr double y_integral = 106.856895;

/// Sums value(wavelength) times the matching functions. `value` is called in ascending order.
template <class F>
Color integrated(F&& value) {
    const MatchingFunctions& functions = cie_1931();
    Vec3 sum(0);
    for (int i = 0; i < wavelength_count; ++i) sum += value(first_wavelength + i) * functions[i];
    // The range of wavelengths over their number: 1 nm but for 1 in 471.
    constexpr double step = double{wavelength_count - 1} / wavelength_count;
    return xyz_color(sum * (step / y_integral));
}

/// A spectrum at wavelengths that never decrease from one call to the next.
class Interpolation {
  public:
    explicit Interpolation(std::span<const SpectralSample> sorted) : samples_(sorted) {}

    double operator()(double wavelength) {
        while (next_ < samples_.size() && samples_[next_].wavelength <= wavelength) ++next_;
        if (next_ == 0) return samples_.front().value;
        if (next_ == samples_.size()) return samples_.back().value;
        const SpectralSample &a = samples_[next_ - 1], &b = samples_[next_];
        const double t = (wavelength - a.wavelength) / (b.wavelength - a.wavelength);
        return a.value + t * (b.value - a.value);
    }

  private:
    std::span<const SpectralSample> samples_;
    std::size_t next_ = 0;  ///< first sample after the wavelength asked for last
};

}  // namespace

Color xyz_color(const Vec3& xyz) {
    const auto [x, y, z] = xyz;
    return {static_cast<float>(3.240479 * x - 1.537150 * y - 0.498535 * z),
            static_cast<float>(-0.969256 * x + 1.875991 * y + 0.041556 * z),
            static_cast<float>(0.055648 * x - 0.204043 * y + 1.057311 * z)};
}

Color spectrum_color(std::span<const SpectralSample> samples) {
    if (samples.empty()) return Color(0.0F);
    std::vector<SpectralSample> sorted(samples.begin(), samples.end());
    std::ranges::stable_sort(sorted, {}, &SpectralSample::wavelength);
    return integrated(Interpolation(sorted));
}

Color blackbody_color(double kelvin) {
    if (!(kelvin > 0)) return Color(0.0F);
    // Planck's law is x^5 / (e^x - 1) up to a factor; Wien's displacement law says where it is
    // largest. Constants of CODATA 2010.
    constexpr double hc_over_k = 6.62606957e-34 * 299792458 / 1.3806488e-23 * 1e9;  // nm K
    constexpr double displacement = 2.8977721e6;                                    // nm K
    const auto planck = [](double x) {
        return x < 1000 ? x * x * x * x * x / std::expm1(x) : 0;  // e^1000 is infinite
    };
    const double maximum = planck(hc_over_k / displacement);
    return integrated(
        [&](double wavelength) { return planck(hc_over_k / (wavelength * kelvin)) / maximum; });
}

}  // namespace etalon
