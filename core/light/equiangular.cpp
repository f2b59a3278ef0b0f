#include "core/light/equiangular.h"

#include <algorithm>

namespace etalon {

Equiangular::Equiangular(const Vec3& light, const Vec3& origin, const Vec3& direction, double begin,
                         double end)
    : begin_(begin), end_(end), nearest_((light - origin).dot(direction)) {
    // A ray through the light would see it only under right angles.
    constexpr double least = 1e-9;
    const Vec3 to_light = light - origin;
    gap_ = std::max((to_light - nearest_ * direction).length(), least * to_light.length());
    first_angle_ = std::atan2(begin - nearest_, gap_);
    angle_ = std::atan2(end - nearest_, gap_) - first_angle_;
}

double Equiangular::sample(double u) const {
    const double distance = nearest_ + gap_ * std::tan(first_angle_ + u * angle_);
    return std::clamp(distance, begin_, end_);
}

double Equiangular::density(double distance) const {
    if (!(distance >= begin_ && distance <= end_) || !(angle_ > 0)) return 0;
    const double along = distance - nearest_;
    return gap_ / (angle_ * (gap_ * gap_ + along * along));
}

}  // namespace etalon
