#include "tests/color/copper.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "core/color/spectrum.h"

namespace etalon {
namespace {

struct Measured {
    double energy;  ///< of a photon, eV
    double n, k;
};

/// Hagemann, Gudat and Kunz 1975, "Optical constants from the far infrared to the x-ray region: Mg,
/// Al, Cu, Ag, Au, Bi, C, and Al2O3", J. Opt. Soc. Am. 65, 742-744: what decides copper's colour.
constexpr Measured copper[] = {{1.0, 0.433, 8.46},  {1.5, 0.260, 5.26}, {1.7, 0.223, 4.43},
                               {1.75, 0.214, 4.24}, {1.8, 0.213, 4.05}, {1.85, 0.215, 3.86},
                               {1.9, 0.214, 3.67},  {2.0, 0.272, 3.24}, {2.1, 0.468, 2.81},
                               {2.2, 0.826, 2.60},  {2.3, 1.037, 2.59}, {2.4, 1.121, 2.60},
                               {2.6, 1.152, 2.50},  {2.8, 1.169, 2.36}, {3.0, 1.184, 2.21},
                               {3.2, 1.232, 2.07},  {3.4, 1.270, 1.95}, {3.6, 1.310, 1.87}};

/// Interpolates by the cubic through the two values on either side, as the edge of absorption at
/// 2.1 eV is too steep for straight lines; near the table's ends through the four next to them.
double interpolated(double energy, double Measured::*value) {
    const Measured* const above = std::ranges::upper_bound(copper, energy, {}, &Measured::energy);
    const Measured* const next = std::clamp(above, std::begin(copper) + 2, std::end(copper) - 2);
    double sum = 0;
    for (const Measured* a = next - 2; a != next + 2; ++a) {
        double weight = 1;
        for (const Measured* b = next - 2; b != next + 2; ++b) {
            if (a != b) weight *= (energy - b->energy) / (a->energy - b->energy);
        }
        sum += weight * a->*value;
    }
    return sum;
}

/// The spectrum in steps of 0.05 eV, in which tables of metals are usual.
Color color_of(double Measured::*value) {
    constexpr double electronvolt_nm = 1239.84198;  // wavelength times energy of a photon
    constexpr int first = 30, last = 69;            // 1.5 to 3.45 eV are 827 to 359 nm
    std::vector<SpectralSample> samples;
    for (int i = first; i <= last; ++i) {
        const double energy = i / 20.0;
        samples.push_back({electronvolt_nm / energy, interpolated(energy, value)});
    }
    return spectrum_color(samples);
}

}  // namespace

Color copper_eta() {
    return color_of(&Measured::n);
}

Color copper_k() {
    return color_of(&Measured::k);
}

}  // namespace etalon
