#include "core/image/metrics/metrics.h"

#include "core/image/metrics/fold.h"

namespace etalon {
namespace {

double difference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double d = std::abs(static_cast<double>(a) - static_cast<double>(b));
    return std::isnan(d) ? infinity : d;
}

double squared(double x) {
    return x * x;
}

/// Returns the mean of term(difference, value of b) over channels.
template <class Term>
double mean_difference(Pixels a, Pixels b, const Term& term) {
    const auto of_pixel = [&](std::size_t i) {
        const auto of_channel = [&](int k) { return term(difference(a[i][k], b[i][k]), b[i][k]); };
        return of_channel(0) + of_channel(1) + of_channel(2);
    };
    return sum<double>(a.size(), of_pixel) / (3 * static_cast<double>(a.size()));
}

}  // namespace

double mse(Pixels a, Pixels b) {
    return mean_difference(a, b, [](double d, float) { return squared(d); });
}

double relmse(Pixels a, Pixels reference) {
    return mean_difference(a, reference, [](double d, float b) {
        // A reference that is not finite must not become the divisor.
        return d == 0 || std::isinf(d) ? d : squared(d) / (squared(b) + 0.01);
    });
}

double mae(Pixels a, Pixels b) {
    return mean_difference(a, b, [](double d, float) { return d; });
}

double psnr(double mse) {
    return 0 - 10 * std::log10(mse);  // not -0 for 1
}

double max_abs(Pixels a, Pixels b) {
    const auto of_pixel = [&](std::size_t i) {
        return std::max(
            {difference(a[i].x, b[i].x), difference(a[i].y, b[i].y), difference(a[i].z, b[i].z)});
    };
    return fold<double>(a.size(), of_pixel, [](double x, double y) { return std::max(x, y); });
}

std::uint64_t different_pixels(Pixels a, Pixels b) {
    return sum<std::uint64_t>(a.size(), [&](std::size_t i) -> std::uint64_t {
        return difference(a[i].x, b[i].x) != 0 || difference(a[i].y, b[i].y) != 0 ||
               difference(a[i].z, b[i].z) != 0;
    });
}

std::uint64_t unbounded_pixels(Pixels pixels) {
    return sum<std::uint64_t>(
        pixels.size(), [&](std::size_t i) -> std::uint64_t { return !is_finite(pixels[i]); });
}

Vec3 mean(Pixels pixels) {
    return sum<Vec3>(pixels.size(), [&](std::size_t i) { return Vec3(pixels[i]); }) /
           static_cast<double>(pixels.size());
}

}  // namespace etalon
