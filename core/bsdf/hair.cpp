#include "core/bsdf/hair.h"

#include <array>

#include "core/bsdf/fresnel.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Light paths by how often they cross the hair: 0 is reflected, and `rest` stands for all from
/// three times on.
constexpr int rest = 3;

template <class T>
T power(T x, int n) {
    T product = 1;
    for (; n > 0; n /= 2, x *= x) {
        if (n % 2 == 1) product *= x;
    }
    return product;
}

double safe_root(double x) {
    return std::sqrt(std::max(0.0, x));
}

/// Returns the logarithm of the modified Bessel function of the first kind and order 0.
double log_bessel_i0(double x) {
    if (x > 20) {
        const double y = 1 / (8 * x);
        return x - std::log(2 * pi * x) / 2 + std::log1p(y * (1 + y * (4.5 + 37.5 * y)));
    }
    const double quarter = x * x / 4;
    double term = 1, sum = 1;
    for (int i = 1; term > 1e-9 * sum; ++i) sum += term *= quarter / (i * i);
    return std::log(sum);
}

/// Returns the angle to the plane perpendicular to the hair.
struct Inclination {
    double sine, cosine;
};

Inclination inclination(const Vec3f& w) {
    const double sine = w.x;
    return {sine, safe_root(1 - sine * sine)};
}

double azimuth(const Vec3f& w) {
    return std::atan2(double(w.z), double(w.y));
}

/// Returns the longitudinal density, per radian and cosine: d'Eon et al. 2011, "An
/// Energy-Conserving Hair Reflectance Model".
double along(const Inclination& o, const Inclination& i, double variance) {
    const double a = o.cosine * i.cosine / variance, b = o.sine * i.sine / variance;
    // 1 / (2 v sinh(1 / v)), without its growth.
    const double scale = 1 / (variance * -std::expm1(-2 / variance));
    return scale * std::exp(log_bessel_i0(a) - b - 1 / variance);
}

/// A logistic distribution about 0, truncated to a turn.
class TurnDensity {
  public:
    explicit TurnDensity(double spread)
        : spread_(spread), least_(1 / (1 + std::exp(pi / spread))), range_(1 - 2 * least_) {}

    double operator()(double angle) const {
        const double e = std::exp(-std::abs(std::remainder(angle, 2 * pi)) / spread_);
        return e / (spread_ * (1 + e) * (1 + e) * range_);
    }
    double sample(double u) const {
        const double part = least_ + u * range_;
        return std::clamp(spread_ * std::log(part / (1 - part)), -pi, pi);
    }

  private:
    double spread_, least_, range_;
};

/// A light path through the hair's cross section.
struct CrossSection {
    double gamma_o, gamma_t;  ///< angles to the normal where it is met, outside and inside

    double turn(int crossings) const {
        return 2 * crossings * gamma_t - 2 * gamma_o + crossings * pi;
    }
};

/// Returns the fractions of light from one direction that take each path.
struct Ways {
    CrossSection section;
    std::array<Color, rest + 1> parts;
    std::array<double, rest + 1> probabilities;
};

Color exp(const Color& c) {
    return {std::exp(c.x), std::exp(c.y), std::exp(c.z)};
}

Ways ways_of(const Inclination& o, float h, float eta, const Color& absorption) {
    const double sine_t = o.sine / eta, cosine_t = safe_root(1 - sine_t * sine_t);
    const double seen_eta = safe_root(eta * eta - o.sine * o.sine) / o.cosine;
    // Beyond the critical angle of an index below 1 no light is inside, and no path has a length.
    const double sine_gamma_t = seen_eta > 0 ? std::clamp(h / seen_eta, -1.0, 1.0) : 0;
    Ways ways;
    ways.section = {std::asin(double(h)), std::asin(sine_gamma_t)};

    const double length = 2 * safe_root(1 - sine_gamma_t * sine_gamma_t) / cosine_t;
    const Color through = cosine_t > 0 ? exp(absorption * static_cast<float>(-length)) : Color(0);
    const auto cosine = static_cast<float>(o.cosine * safe_root(1 - double(h) * h));
    const float f = dielectric_reflectance(std::max(cosine, 1e-6F), eta);
    ways.parts[0] = Color(f);
    ways.parts[1] = (1 - f) * (1 - f) * through;
    ways.parts[2] = f * through * ways.parts[1];
    const Color lost = Color(1) - f * through;
    ways.parts[rest] =
        lost.x > 0 && lost.y > 0 && lost.z > 0 ? ways.parts[2] * (f * through) / lost : Color(0);
    double sum = 0;
    for (int p = 0; p <= rest; ++p) sum += ways.probabilities[p] = mean(ways.parts[p]);
    for (double& p : ways.probabilities) p = sum > 0 ? p / sum : 0;
    return ways;
}

/// Rotates along the hair by a multiple of the scales' tilt that depends on the path.
Inclination tilted(const Inclination& o, int crossings, double sine_of_tilt) {
    const double sine1 = sine_of_tilt, cosine1 = safe_root(1 - sine1 * sine1);
    const double sine2 = 2 * sine1 * cosine1, cosine2 = cosine1 * cosine1 - sine1 * sine1;
    double sine = 0, cosine = 1;
    if (crossings == 0) sine = -sine2, cosine = cosine2;
    if (crossings == 1) sine = sine1, cosine = cosine1;
    if (crossings == 2) {
        sine = 2 * sine2 * cosine2;
        cosine = cosine2 * cosine2 - sine2 * sine2;
    }
    return {o.sine * cosine + o.cosine * sine, std::abs(o.cosine * cosine - o.sine * sine)};
}

double variance_of(double reflected, int crossings) {
    if (crossings == 0) return reflected;
    return crossings == 1 ? reflected / 4 : 4 * reflected;
}

/// Splits a number of 52 bits into two numbers of 26 bits in [0, 1).
Vec2 two_of(double u) {
    const auto bits = static_cast<std::uint64_t>(u * 0x1p52);
    std::uint64_t even = 0, odd = 0;
    for (int k = 0; k < 26; ++k) {
        odd |= (bits >> (2 * k + 1) & 1) << k;
        even |= (bits >> (2 * k) & 1) << k;
    }
    return {static_cast<double>(odd) * 0x1p-26, static_cast<double>(even) * 0x1p-26};
}

/// Samples a direction's angle to the plane perpendicular to the hair, with the density of `along`.
double sample_sine(const Inclination& o, double variance, const Vec2& uv) {
    const double u = std::max(uv.x, 0x1p-30);
    const double cosine =
        std::max(-1.0, 1 + variance * std::log(u + (1 - u) * std::exp(-2 / variance)));
    const double about = std::cos(2 * pi * uv.y);
    return std::clamp(-cosine * o.sine + safe_root(1 - cosine * cosine) * about * o.cosine, -1.0,
                      1.0);
}

}  // namespace

HairScattering::HairScattering(const HairFibre& fibre)
    : h_(std::clamp(fibre.h, -1.0F, 1.0F)), index_(fibre.eta), absorption_(fibre.absorption) {
    // Less than a hundredth is no density that floats could hold.
    const float m = std::clamp(fibre.along_width, 0.01F, 1.0F);
    const float n = std::clamp(fibre.across_width, 0.01F, 1.0F);
    const float deviation = 0.726F * m + 0.812F * m * m + 3.7F * power(m, 20);
    variance_ = deviation * deviation;
    constexpr float root_of_pi_over_8 = 0.626657069F;
    spread_ = root_of_pi_over_8 * (0.265F * n + 1.194F * n * n + 5.372F * power(n, 22));
    sine_of_tilt_ = std::sin(fibre.tilt * std::numbers::pi_v<float> / 180);
}

Evaluation HairScattering::evaluate(const Vec3f& wo, const Vec3f& wi) const {
    const Inclination o = inclination(wo), i = inclination(wi);
    if (o.cosine == 0) return {};
    const Ways ways = ways_of(o, h_, index_, absorption_);
    const TurnDensity across(spread_);
    const double turn = azimuth(wi) - azimuth(wo);
    Color sum(0);
    double pdf = 0;
    for (int p = 0; p <= rest; ++p) {
        const double around = p < rest ? across(turn - ways.section.turn(p)) : 1 / (2 * pi);
        const double density =
            around * along(tilted(o, p, sine_of_tilt_), i, variance_of(variance_, p));
        sum += ways.parts[p] * static_cast<float>(density);
        pdf += ways.probabilities[p] * density;
    }
    const float cosine = std::abs(wi.z);
    return {factor_ * (cosine > 0 ? sum / cosine : sum), static_cast<float>(pdf)};
}

std::optional<Vec3f> HairScattering::sample(const Vec3f& wo, const Vec2& uv) const {
    const Inclination o = inclination(wo);
    if (o.cosine == 0) return {};
    const Ways ways = ways_of(o, h_, index_, absorption_);
    double u = uv.x;
    int p = 0;
    for (; p < rest && u >= ways.probabilities[p]; ++p) u -= ways.probabilities[p];
    u = ways.probabilities[p] > 0 ? std::min(u / ways.probabilities[p], 1.0) : 0;

    const double sine =
        sample_sine(tilted(o, p, sine_of_tilt_), variance_of(variance_, p), two_of(uv.y));
    const double cosine = safe_root(1 - sine * sine);
    const double turn =
        p < rest ? ways.section.turn(p) + TurnDensity(spread_).sample(u) : 2 * pi * u;
    const double angle = azimuth(wo) + turn;
    return Vec3f(Vec3(sine, cosine * std::cos(angle), cosine * std::sin(angle)));
}

Color HairScattering::albedo(const Vec3f& wo) const {
    const Inclination o = inclination(wo);
    if (o.cosine == 0) return Color(0);
    Color sum(0);
    for (const Color& part : ways_of(o, h_, index_, absorption_).parts) sum += part;
    return factor_ * sum;
}

Color hair_absorption(float eumelanin, float pheomelanin) {
    return eumelanin * Color(0.419F, 0.697F, 1.37F) + pheomelanin * Color(0.187F, 0.4F, 1.05F);
}

Color hair_absorption_of(const Color& reflectance, float across_width) {
    const float n = across_width;
    const float fitted =
        5.969F + n * (-0.215F + n * (2.532F + n * (-10.73F + n * (5.574F + 0.245F * n))));
    const auto channel = [&](float c) {
        const float root = std::log(std::max(c, 1e-30F)) / fitted;
        return root * root;
    };
    return {channel(reflectance.x), channel(reflectance.y), channel(reflectance.z)};
}

}  // namespace etalon
