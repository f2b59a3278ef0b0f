// Fourier tables for tests, and the bytes of their files.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>

#include "core/numerics/catmull_rom.h"
#include "core/numerics/vec.h"
#include "core/scene/fourier_table.h"

namespace etalon::test {

/// Returns cosines that lie closer together near grazing directions; none is 0.
inline std::vector<float> cosines_of_table(int on_each_side) {
    std::vector<float> cosines;
    for (int k = -on_each_side; k <= on_each_side; ++k) {
        const double part = (std::abs(k) - 0.9) / (on_each_side - 0.9);
        if (k != 0) cosines.push_back(static_cast<float>(std::copysign(std::pow(part, 1.3), k)));
    }
    return cosines;
}

/// Returns coefficient number `k` of an even function of an angle.
template <class Function>
double fourier_coefficient(const Function& f, int k) {
    constexpr int steps = 256;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double phi = std::numbers::pi * (i + 0.5) / steps;
        sum += f(phi) * std::cos(k * phi);
    }
    return (k == 0 ? 1 : 2) * sum / steps;
}

/// Returns the table of a BSDF `f(wo, wi)`, a colour, with series of at most `longest`
/// coefficients; trailing ones below a ten thousandth of the first are left out.
template <class Function>
FourierTable table_of(const std::vector<float>& cosines, int longest, const Function& f) {
    const std::size_t n = cosines.size();
    FourierTable table{1, 3, cosines, std::vector<float>(n * n), {}, {}};
    for (std::size_t o = 0; o < n; ++o) {
        std::vector<float> first(n);
        for (std::size_t i = 0; i < n; ++i) {
            const double mu_o = cosines[o], mu_i = cosines[i];
            const auto channels = [&](double phi) {
                const double sine_o = std::sqrt(1 - mu_o * mu_o),
                             sine_i = std::sqrt(1 - mu_i * mu_i);
                const Vec3 wi(-sine_i * std::cos(phi), -sine_i * std::sin(phi), -mu_i);
                const Color c = f(Vec3(sine_o, 0, mu_o), wi) * std::abs(cosines[i]);
                return Vec3((c.y + 0.100913 * c.z + 0.297375 * c.x) / 1.39829, c.x, c.z);
            };
            std::vector<Vec3> series;
            std::size_t length = 0;
            for (int k = 0; k < longest; ++k) {
                Vec3 a;
                for (int c = 0; c < 3; ++c) {
                    a[c] = fourier_coefficient([&](double phi) { return channels(phi)[c]; }, k);
                }
                series.push_back(a);
                if (max_abs(a) > 1e-4 * max_abs(series[0])) length = series.size();
            }
            table.series.push_back({static_cast<std::uint32_t>(table.coefficients.size()),
                                    static_cast<std::uint32_t>(length)});
            for (int c = 0; c < 3; ++c) {
                for (std::size_t k = 0; k < length; ++k) {
                    table.coefficients.push_back(static_cast<float>(series[k][c]));
                }
            }
            first[i] = length > 0 ? static_cast<float>(series[0].x) : 0;
        }
        integrate_spline(cosines, first, std::span(table.sums).subspan(o * n, n));
    }
    return table;
}

/// Returns diffuse light to both sides and a wide gloss around the mirrored direction.
inline Color glossy_both_sides(const Vec3& wo, const Vec3& wi) {
    const Vec3 mirrored(-wo.x, -wo.y, wo.z), through(-wo.x, -wo.y, -wo.z);
    const bool is_reflected = wo.z * wi.z > 0;
    const double lobe = std::exp(4 * (wi.dot(is_reflected ? mirrored : through) - 1));
    const auto f = static_cast<float>(lobe * 0.1);
    return is_reflected ? Color(0.12F, 0.08F, 0.03F) + Color(f)
                        : Color(0.01F, 0.02F, 0.05F) + Color(f / 4);
}

/// Returns the file of a table.
inline std::string bytes_of(const FourierTable& table) {
    std::string bytes = "SCATFUN\x01";
    const auto append = [&](const void* from, std::size_t size) {
        bytes.append(static_cast<const char*>(from), size);
    };
    std::uint32_t longest = 0;
    for (const FourierTable::Series& s : table.series) longest = std::max(longest, s.length);
    const auto n = static_cast<std::uint32_t>(table.cosines.size());
    const std::uint32_t header[] = {1,
                                    n,
                                    static_cast<std::uint32_t>(table.coefficients.size()),
                                    longest,
                                    static_cast<std::uint32_t>(table.channels),
                                    1,
                                    0,
                                    0,
                                    0};
    append(header, sizeof(header));
    const float rest[] = {table.eta, 0, 0, 0, 0};
    append(rest, sizeof(rest));
    append(table.cosines.data(), 4 * table.cosines.size());
    append(table.sums.data(), 4 * table.sums.size());
    append(table.series.data(), 8 * table.series.size());
    append(table.coefficients.data(), 4 * table.coefficients.size());
    return bytes;
}

}  // namespace etalon::test
