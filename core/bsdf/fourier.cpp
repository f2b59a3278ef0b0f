#include "core/bsdf/fourier.h"

#include <numbers>
#include <span>

#include "core/numerics/catmull_rom.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// A series interpolated from those of a table, with weights for the cosines. At most one exists
/// per thread.
class Series {
  public:
    /// Interpolates the first `channels`.
    Series(const FourierTable& table, const SplineWeights& o, const SplineWeights& i,
           int channels) {
        const std::size_t n = table.cosines.size();
        const auto each_pair = [&](const auto& use) {
            for (std::size_t a = 0; a < 4; ++a) {
                for (std::size_t b = 0; b < 4; ++b) {
                    const float weight = o.weights[a] * i.weights[b];
                    if (weight == 0) continue;
                    use(table.series[(o.first + a - 1) * n + i.first + b - 1], weight);
                }
            }
        };
        each_pair([&](const FourierTable::Series& s, float) {
            length_ = std::max<std::size_t>(length_, s.length);
        });
        sums_.assign(channels * length_, 0.0F);
        each_pair([&](const FourierTable::Series& s, float weight) {
            for (int c = 0; c < channels; ++c) {
                const float* const from = table.coefficients.data() + s.first + c * s.length;
                float* const to = sums_.data() + c * length_;
                for (std::size_t k = 0; k < s.length; ++k) to[k] += weight * from[k];
            }
        });
    }

    /// Returns the coefficients of a channel.
    std::span<const float> channel(int c) const {
        return std::span(sums_).subspan(c * length_, length_);
    }

    /// Returns the value of a channel at an angle with this cosine.
    double at(int c, double cosine) const {
        double sum = 0, before = cosine, now = 1;  // of k times the angle
        for (const float coefficient : channel(c)) {
            sum += coefficient * now;
            const double next = 2 * cosine * now - before;
            before = now;
            now = next;
        }
        return sum;
    }

  private:
    static thread_local std::vector<float> sums_;  ///< channel by channel
    std::size_t length_ = 0;
};

thread_local std::vector<float> Series::sums_;

/// Returns the cosine of the azimuth between two directions; 1 where there is none.
double cosine_between(const Vec3f& a, const Vec3f& b) {
    const double lengths = std::hypot(a.x, a.y) * std::hypot(b.x, b.y);
    const double dot = double(a.x) * b.x + double(a.y) * b.y;
    return lengths > 0 ? std::clamp(dot / lengths, -1.0, 1.0) : 1;
}

/// Returns the fraction of light of a cosine that the table scatters, over 2 pi.
float sum_of(const FourierTable& table, const SplineWeights& o) {
    const std::size_t n = table.cosines.size();
    return std::max(0.0F, o.sum([&](std::size_t k) { return table.sums[k * n + n - 1]; }));
}

/// Returns the azimuth, within half a turn, at which the integral of a series is the fraction `u`
/// of the whole, by Newton's method safeguarded with bisection.
double sample_series(std::span<const float> a, double u) {
    double low = 0, high = pi, phi = u * pi;
    for (int steps = 0; steps < 64 && high - low > 1e-7; ++steps) {
        if (!(phi > low && phi < high)) phi = (low + high) / 2;
        const double cosine = std::cos(phi), sine = std::sin(phi);
        double value = a[0], sum = a[0] * (phi - u * pi);
        double cosine_k = cosine, sine_k = sine;
        for (std::size_t k = 1; k < a.size(); ++k) {
            value += a[k] * cosine_k;
            sum += a[k] / static_cast<double>(k) * sine_k;
            const double next = cosine_k * cosine - sine_k * sine;
            sine_k = sine_k * cosine + cosine_k * sine;
            cosine_k = next;
        }
        (sum < 0 ? low : high) = phi;
        if (std::abs(sum) < 1e-9 * a[0]) break;
        phi -= sum / value;
    }
    return phi;
}

}  // namespace

Evaluation FourierScattering::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    const auto o = spline_weights(table().cosines, wo.z),
               i = spline_weights(table().cosines, -wi.z);
    if (!o || !i || wi.z == 0) return {};
    const Series series(table(), *o, *i, table().channels);
    const double cosine = cosine_between(-wi, wo);
    double scale = 1 / std::abs(static_cast<double>(wi.z));
    // Transmitted radiance changes with the solid angle.
    if (wi.z * wo.z < 0)
        scale *= wi.z < 0 ? 1 / (table().eta * table().eta) : table().eta * table().eta;
    Evaluation e;
    const double light = std::max(0.0, series.at(0, cosine));
    const float sum = sum_of(table(), *o);
    if (sum > 0) e.pdf = static_cast<float>(light / (2 * pi * sum));
    if (table().channels == 1) {
        e.f = factor_ * static_cast<float>(light * scale);
    } else {
        const double red = series.at(1, cosine), blue = series.at(2, cosine);
        // The weights of Rec. 709's primaries in luminance.
        const double green = 1.39829 * light - 0.100913 * blue - 0.297375 * red;
        const auto part = [&](double x) { return static_cast<float>(std::max(0.0, x * scale)); };
        e.f = factor_ * Color(part(red), part(green), part(blue));
    }
    return e;
}

std::optional<Vec3f> FourierScattering::sample(const Vec3f& wo, const Vec2& uv) const {
    const std::vector<float>& cosines = table().cosines;
    const std::size_t n = cosines.size();
    const auto o = spline_weights(cosines, wo.z);
    if (!o || !(sum_of(table(), *o) > 0)) return std::nullopt;
    const auto first_coefficient = [&](std::size_t k) -> double {
        return o->sum([&](std::size_t row) {
            const FourierTable::Series& s = table().series[row * n + k];
            return s.length > 0 ? table().coefficients[s.first] : 0.0F;
        });
    };
    const auto sum = [&](std::size_t k) -> double {
        return o->sum([&](std::size_t row) { return table().sums[row * n + k]; });
    };
    const double cosine = sample_spline(cosines, first_coefficient, sum, uv.y).x;
    const auto i = spline_weights(cosines, static_cast<float>(cosine));
    if (!i) return std::nullopt;
    const Series series(table(), *o, *i, 1);
    const std::span<const float> luminance = series.channel(0);
    if (luminance.empty() || !(luminance[0] > 0)) return std::nullopt;
    const bool is_right = uv.x < 0.5;
    const double half = sample_series(luminance, is_right ? 2 * uv.x : 2 - 2 * uv.x);
    const double phi = is_right ? half : -half;
    const double length = std::hypot(wo.x, wo.y),
                 sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double x = length > 0 ? wo.x / length : 1, y = length > 0 ? wo.y / length : 0;
    return Vec3f(Vec3(-sine * (std::cos(phi) * x - std::sin(phi) * y),
                      -sine * (std::sin(phi) * x + std::cos(phi) * y), -cosine));
}

Color FourierScattering::albedo(const Vec3f& wo) const {
    const auto o = spline_weights(table().cosines, wo.z);
    return o ? factor_ * static_cast<float>(2 * pi * sum_of(table(), *o)) : Color(0);
}

}  // namespace etalon
