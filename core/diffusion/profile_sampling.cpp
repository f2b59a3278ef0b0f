#include "core/diffusion/profile_sampling.h"

#include <array>
#include <numbers>

namespace etalon {
namespace {

constexpr std::array axis_probabilities = {0.25, 0.25, 0.5};

/// Fraction of the light within the length of probes.
constexpr double part_within = 0.999;

/// Returns the axis that `choice` selects, and rescales `choice` to [0, 1).
int take_axis(double& choice) {
    int axis = 2;
    while (choice >= axis_probabilities[axis] && axis > 0) choice -= axis_probabilities[axis--];
    choice = std::min(choice / axis_probabilities[axis], std::nextafter(1.0, 0.0));
    return axis;
}

}  // namespace

std::optional<Probe> ProfileSampling::probe(double choice, const Vec2& uv) const {
    const int axis = take_axis(choice), channel = static_cast<int>(3 * choice);
    const auto distance = [&](double u) {
        return std::visit([&](const auto& kind) { return kind.sample(channel, u); }, profile_);
    };
    const double r = distance(uv.x), longest = distance(part_within);
    if (!(r >= 0 && r < longest)) return std::nullopt;
    const std::array axes = {&frame_.x, &frame_.y, &frame_.ns};
    const Vec3 &along = *axes[axis], &x = *axes[(axis + 1) % 3], &y = *axes[(axis + 2) % 3];
    const double phi = 2 * std::numbers::pi * uv.y,
                 length = 2 * std::sqrt(longest * longest - r * r);
    const Vec3 middle = position_ + r * (std::cos(phi) * x + std::sin(phi) * y);
    return Probe{middle - length / 2 * along, along, length};
}

Color ProfileSampling::value(const Vec3& point) const {
    const auto distance = static_cast<float>((point - position_).length());
    return std::visit(
        [&](const auto& kind) {
            return Color(kind.value(0, distance), kind.value(1, distance), kind.value(2, distance));
        },
        profile_);
}

float ProfileSampling::density(const Vec3& point, const Vec3& normal) const {
    const Vec3 d = frame_.to_local(point - position_), n = frame_.to_local(normal);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto r = static_cast<float>(std::hypot(d[(axis + 1) % 3], d[(axis + 2) % 3]));
        double of_channels = 0;
        for (int channel = 0; channel < 3; ++channel) {
            of_channels +=
                std::visit([&](const auto& kind) { return kind.density(channel, r); }, profile_);
        }
        sum += axis_probabilities[axis] * std::abs(n[axis]) * of_channels / 3;
    }
    return static_cast<float>(sum);
}

}  // namespace etalon
