#include "core/formats/pbrt/color_values.h"

#include "core/color/spectrum.h"

namespace etalon::pbrt {
namespace {

void add(std::vector<float>& rgb, const Color& c) {
    rgb.insert(rgb.end(), {c.x, c.y, c.z});
}

std::vector<float> from_xyz(const std::vector<float>& n) {
    std::vector<float> rgb;
    for (std::size_t i = 0; i + 2 < n.size(); i += 3)
        add(rgb, xyz_color({n[i], n[i + 1], n[i + 2]}));
    return rgb;
}

/// Pairs of a temperature in kelvin and a factor.
std::vector<float> from_black_bodies(const std::vector<float>& n) {
    std::vector<float> rgb;
    for (std::size_t i = 0; i + 1 < n.size(); i += 2) add(rgb, blackbody_color(n[i]) * n[i + 1]);
    return rgb;
}

/// Returns one colour from all pairs of a wavelength and a value.
std::vector<float> from_spectrum(const std::vector<float>& n) {
    std::vector<SpectralSample> samples;
    for (std::size_t i = 0; i + 1 < n.size(); i += 2) samples.push_back({n[i], n[i + 1]});
    std::vector<float> rgb;
    if (!samples.empty()) add(rgb, spectrum_color(samples));
    return rgb;
}

}  // namespace

std::vector<float> to_rgb(const DeclaredType& type, std::vector<float> numbers) {
    if (type.encoding == ValueEncoding::xyz) return from_xyz(numbers);
    if (type.encoding == ValueEncoding::blackbody) return from_black_bodies(numbers);
    if (type.encoding == ValueEncoding::spectrum) return from_spectrum(numbers);
    return numbers;
}

}  // namespace etalon::pbrt
