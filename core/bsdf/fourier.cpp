#include "core/bsdf/fourier.h"

#include <array>
#include <numbers>

#include "core/numerics/catmull_rom.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// The pairs of the table around two cosines, with their weights.
class Pairs {
  public:
    Pairs(const FourierTable& table, const SplineWeights& o, const SplineWeights& i)
        : table_(table) {
        for (std::size_t a = 0; a < 4; ++a) {
            for (std::size_t b = 0; b < 4; ++b) {
                const float weight = o.weights[a] * i.weights[b];
                if (weight != 0) add(o.first + a - 1, i.first + b - 1, weight);
            }
        }
    }

    std::size_t length() const { return length_; }

    /// Coefficient number `k` of a channel.
    double coefficient(int channel, std::size_t k) const {
        double sum = 0;
        for (std::size_t p = 0; p < count_; ++p) {
            const FourierTable::Series& s = *series_[p];
            if (k < s.length) {
                sum += weights_[p] * table_.coefficients[s.first + channel * s.length + k];
            }
        }
        return sum;
    }

    /// The channels' series at an angle of this cosine.
    std::array<double, 3> at(double cosine) const {
        std::array<double, 3> sums{};
        double before = cosine, now = 1;  // of k times the angle
        for (std::size_t k = 0; k < length_; ++k) {
            for (int c = 0; c < table_.channels; ++c) sums[c] += coefficient(c, k) * now;
            const double next = 2 * cosine * now - before;
            before = now;
            now = next;
        }
        return sums;
    }

  private:
    void add(std::size_t o, std::size_t i, float weight) {
        const FourierTable::Series& s = table_.series[o * table_.cosines.size() + i];
        series_[count_] = &s;
        weights_[count_++] = weight;
        length_ = std::max<std::size_t>(length_, s.length);
    }

    const FourierTable& table_;
    std::array<const FourierTable::Series*, 16> series_;
    std::array<float, 16> weights_;
    std::size_t count_ = 0, length_ = 0;
};

/// Cosine of the angle about the normal between two directions; 1 where there is none.
double cosine_between(const Vec3f& a, const Vec3f& b) {
    const double lengths = std::hypot(a.x, a.y) * std::hypot(b.x, b.y);
    const double dot = double(a.x) * b.x + double(a.y) * b.y;
    return lengths > 0 ? std::clamp(dot / lengths, -1.0, 1.0) : 1;
}

/// Part of the light of a cosine that the table scatters, over 2 pi.
float sum_of(const FourierTable& table, const SplineWeights& o) {
    const std::size_t n = table.cosines.size();
    return std::max(0.0F, o.sum([&](std::size_t k) { return table.sums[k * n + n - 1]; }));
}

/// Half a turn's angle at which the integral of a series is the part `u` of the whole: Newton's
/// method, halving the interval where that leaves it.
double sample_series(const Pairs& pairs, double u) {
    thread_local std::vector<double> a;
    a.resize(pairs.length());
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = pairs.coefficient(0, k);
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
    const Pairs pairs(table(), *o, *i);
    const auto [y, red, blue] = pairs.at(cosine_between(-wi, wo));
    double scale = 1 / std::abs(static_cast<double>(wi.z));
    // Radiance that passes the surface is spread over other angles.
    if (wi.z * wo.z < 0)
        scale *= wi.z < 0 ? 1 / (table().eta * table().eta) : table().eta * table().eta;
    Evaluation e;
    const double light = std::max(0.0, y);
    const float sum = sum_of(table(), *o);
    if (sum > 0) e.pdf = static_cast<float>(light / (2 * pi * sum));
    if (table().channels == 1) {
        e.f = factor_ * static_cast<float>(light * scale);
    } else {
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
    const Pairs pairs(table(), *o, *i);
    if (pairs.length() == 0 || !(pairs.coefficient(0, 0) > 0)) return std::nullopt;
    const bool is_right = uv.x < 0.5;
    const double half = sample_series(pairs, is_right ? 2 * uv.x : 2 - 2 * uv.x);
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
