#include "core/light/revolved_area.h"

#include <algorithm>
#include <numbers>

#include "core/intersect/shapes/revolved.h"

namespace etalon {

RevolvedArea::RevolvedArea(const Revolved& surface)
    : surface_(std::make_shared<const Revolved>(surface)),
      begin_(surface.profile.low),
      end_(surface.profile.high) {
    const Affine& m = surface.to_world;
    const double outward = std::copysign(1.0, m.determinant());
    cofactors_[0] = outward * m.y.cross(m.z);
    cofactors_[1] = outward * m.z.cross(m.x);
    cofactors_[2] = outward * m.x.cross(m.y);
    if (surface.profile.is_flat()) begin_ *= begin_, end_ *= end_;

    Shares cumulative{};
    for (std::size_t i = 0; i < slices; ++i) {
        const double middle = 0.5 * (slice_begin(i) + slice_begin(i + 1));
        cumulative[i + 1] = cumulative[i] + area_of_slice(middle);
        area_ += image_of_slice(middle);
    }
    for (double& share : cumulative) share /= cumulative[slices];
    cumulative_ = std::make_shared<const Shares>(cumulative);
    area_ *= surface.sector.angle * (end_ - begin_) / slices;
}

/// Returns the area of a unit of height and angle, before the map: half of the gradient's length. 0
/// below the curve.
double RevolvedArea::area_of_slice(double middle) const {
    const Profile& p = surface_->profile;
    if (p.is_flat()) return 1;
    const double square = p.square(middle);
    if (!(square > 0)) return 0;
    return 0.5 * gradient(p, {std::sqrt(square), 0, middle}).length();
}

/// The same after the map, as a mean around the axis: it is only used for powers.
double RevolvedArea::image_of_slice(double middle) const {
    if (!surface_->profile.is_flat() && !(surface_->profile.square(middle) > 0)) return 0;
    constexpr int around = 32;
    double sum = 0;
    for (int k = 0; k < around; ++k) {
        sum += stretched_normal(point(middle, (k + 0.5) / around)).length();
    }
    return sum / around;
}

RevolvedArea::SlicePoint RevolvedArea::choose(double number) const {
    const Shares& shares = *cumulative_;
    const auto* const next = std::upper_bound(shares.begin() + 1, shares.end() - 1, number);
    const auto slice = static_cast<std::size_t>(next - shares.begin()) - 1;
    const double share = shares[slice + 1] - shares[slice];
    const double within = std::clamp((number - shares[slice]) / share, 0.0, 1.0);
    const double begin = slice_begin(slice), width = slice_begin(slice + 1) - begin;
    return {begin + within * width, share * slices / (end_ - begin_)};
}

double RevolvedArea::density_at(double along) const {
    const double share = std::clamp((along - begin_) / (end_ - begin_), 0.0, 1.0);
    const auto slice = std::min(static_cast<std::size_t>(share * slices), slices - 1);
    return ((*cumulative_)[slice + 1] - (*cumulative_)[slice]) * slices / (end_ - begin_);
}

double RevolvedArea::along_of(const Vec3& local) const {
    return surface_->profile.is_flat() ? local.x * local.x + local.y * local.y : local.z;
}

Vec3 RevolvedArea::point(double along, double around) const {
    const Profile& p = surface_->profile;
    const double z = p.is_flat() ? 0 : along;
    const double radius = std::sqrt(std::max(0.0, p.is_flat() ? along : p.square(z)));
    const Vec2 from = surface_->sector.from(z);
    const double angle = std::atan2(from.y, from.x) + around * surface_->sector.angle;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// The cross product of the derivatives by the angle and the height is half of the gradient; with
/// the square of the radius, in the plane, half of the axis.
Vec3 RevolvedArea::stretched_normal(const Vec3& local) const {
    const Vec3 g = 0.5 * gradient(surface_->profile, local);
    return g.x * cofactors_[0] + g.y * cofactors_[1] + g.z * cofactors_[2];
}

double RevolvedArea::per_area(const Vec3& local, double density) const {
    return density / (surface_->sector.angle * stretched_normal(local).length());
}

AreaPoint RevolvedArea::sample(const Vec3& from, const Vec2& uv) const {
    const auto [along, density] = choose(uv.x);
    const Vec3 local = point(along, uv.y), position = surface_->to_world.point(local);
    const Vec3 normal = normalized(stretched_normal(local));
    return {position, normal, per_steradian(per_area(local, density), from, position, normal)};
}

double RevolvedArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    const Vec3 local = surface_->frame.vector(position - surface_->to_world.origin);
    return per_steradian(per_area(local, density_at(along_of(local))), from, position, normal);
}

/// The centre of the box of a flat surface's sector is beside the plane: it is projected onto it,
/// which takes it away from no point there.
BoundingSphere RevolvedArea::bounds() const {
    const Box3 box = etalon::bounds({}, *surface_);
    Vec3 centre = box.center();
    if (const std::optional<Vec3> normal = flat_normal())
        centre -= normal->dot(centre - surface_->to_world.origin) * *normal;
    return {centre, 0.5 * box.size().length()};
}

std::optional<Vec3> RevolvedArea::flat_normal() const {
    if (!surface_->profile.is_flat()) return std::nullopt;
    return normalized(stretched_normal(Vec3(0)));
}

}  // namespace etalon
