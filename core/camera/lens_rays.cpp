#include "core/camera/lens_rays.h"

#include <algorithm>
#include <cmath>

namespace etalon {
namespace {

Vec2 film_size(double diagonal, const Imath::V2i& resolution) {
    const double aspect = static_cast<double>(resolution.y) / resolution.x;
    const double width = diagonal / std::sqrt(1 + aspect * aspect);
    return {width, aspect * width};
}

}  // namespace

LensRays::LensRays(const LensSystem& lens, const Imath::V2i& resolution)
    : tracer_(lens.surfaces),
      exit_pupils_(lens.exit_pupils),
      film_radius_(lens.film_diagonal / 2),
      exposure_(lens.exposure),
      half_film_(film_size(lens.film_diagonal, resolution) / 2),
      pixel_size_(2.0 * half_film_ / Vec2(resolution)) {}

WeightedRay LensRays::ray(const Vec2& pixel, const Vec2& on_pupil) const {
    // The image on the film is upside down, and so is the order of its points here.
    const Vec2 in_image = pixel * pixel_size_ - half_film_;
    const Vec3 film(-in_image.x, in_image.y, 0);
    const double distance = std::hypot(film.x, film.y);
    const auto count = static_cast<double>(exit_pupils_.size());
    const double number = std::min(distance / film_radius_ * count, count - 1);
    const Imath::Box2d& pupil = exit_pupils_[static_cast<std::size_t>(number)];
    const Vec2 p = pupil.min + on_pupil * pupil.size();
    const Vec2 along = distance > 0 ? Vec2(film.x, film.y) / distance : Vec2(1, 0);
    const Vec3 rear(along.x * p.x - along.y * p.y, along.y * p.x + along.x * p.y, tracer_.rear_z());
    const Vec3 direction = normalized(rear - film);
    const std::optional<LensRay> out = tracer_.from_film({film, direction});
    if (!out) {
        const Vec3 middle(0, 0, tracer_.rear_z());
        return {{{0, 0, tracer_.front_z()}, normalized(middle - film)}, 0};
    }
    const double cosine2 = direction.z * direction.z;
    const double area = pupil.size().x * pupil.size().y;
    return {*out, static_cast<float>(cosine2 * cosine2 * area * exposure_)};
}

}  // namespace etalon
