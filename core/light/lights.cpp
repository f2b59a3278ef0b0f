#include "core/light/lights.h"

#include <algorithm>
#include <numbers>

#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"
#include "core/numerics/luminance.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

double radius_of(const Geometry& geometry) {
    Box3 box;
    for (std::uint32_t i = 0; i < geometry.primitives.size(); ++i) {
        const Box3 bounds = primitive_bounds(geometry, i);
        if (is_finite(bounds.min) && is_finite(bounds.max)) box.extendBy(bounds);
    }
    for (const Box3& instance : instance_bounds(geometry, box)) box.extendBy(instance);
    return box.isEmpty() ? 1 : box.size().length() / 2;
}

/// The largest cosine, not below 0, between a unit vector and directions to a sphere.
double largest_cosine(const Vec3& normal, const Vec3& to_centre, double radius) {
    const double distance2 = to_centre.dot(to_centre), radius2 = radius * radius;
    if (distance2 <= radius2) return 1;
    const double distance = std::sqrt(distance2);
    const double cosine = std::clamp(normal.dot(to_centre) / distance, -1.0, 1.0);
    const double sine = std::sqrt(1 - cosine * cosine);
    const double sine_half = radius / distance, cos_half = std::sqrt(1 - sine_half * sine_half);
    if (cosine >= cos_half) return 1;
    return std::max(0.0, cosine * cos_half + sine * sine_half);  // of the difference of the angles
}

/// From 0 at the border of a spot's cone smoothly to 1.
double spot_falloff(const SpotSource& s, const Vec3& direction) {
    const double cosine = s.axis.dot(direction);
    if (cosine < s.cos_total) return 0;
    if (cosine >= s.cos_falloff) return 1;
    const double x = (cosine - s.cos_total) / (s.cos_falloff - s.cos_total);
    return x * x * x * x;
}

LightSample from_point(const Vec3& position, const Color& intensity, const Vec3& from) {
    const Vec3 way = position - from;
    const double distance2 = way.dot(way);
    LightSample s{way / std::sqrt(distance2), position};
    s.radiance = intensity / static_cast<float>(distance2);
    s.pdf = distance2 > 0 ? 1 : 0;
    s.is_delta = true;
    return s;
}

/// Samples the lights without extent.
struct DeltaSample {
    LightSample operator()(const PointSource& s) const {
        return from_point(s.position, s.intensity, from);
    }
    LightSample operator()(const SpotSource& s) const {
        LightSample sample = from_point(s.position, s.intensity, from);
        sample.radiance *= static_cast<float>(spot_falloff(s, -sample.wi));
        return sample;
    }
    LightSample operator()(const GoniometricSource& s) const {
        LightSample sample = from_point(s.position, s.intensity, from);
        if (image->empty()) return sample;
        const Vec3 d = normalized(s.to_light.vector(-sample.wi));
        sample.radiance *= image->at(SphericalImage::place_of({d.x, d.z, d.y}));
        return sample;
    }
    LightSample operator()(const DistantSource& s) const {
        return {s.direction, Vec3(0), true, s.radiance, 1, true};
    }
    template <class Other>
    LightSample operator()(const Other&) const {
        return {};
    }

    const Vec3& from;
    const SphericalImage* image;  ///< of a light that has one
};

bool is_point_light(const PhysicalLight& light) {
    return std::holds_alternative<PointSource>(light) ||
           std::holds_alternative<SpotSource>(light) ||
           std::holds_alternative<GoniometricSource>(light);
}

}  // namespace

bool Lights::AreaLight::shines(const Vec3& normal, const Vec3& ray) const {
    if (two_sided) return true;
    const Vec3 front = flat_front ? *flat_front : flipped ? -normal : normal;
    return front.dot(ray) < 0;
}

/// Whether a flat light of one side shines to the other side of its plane only.
bool Lights::AreaLight::turns_from(const Vec3& point) const {
    return flat_front && !two_sided && flat_front->dot(point - bounds.centre) <= 0;
}

/// Bound on the cosine between the front's normal and directions to a point, `back` seen from the
/// middle of the light.
double Lights::AreaLight::facing(const Vec3& back) const {
    if (!flat_front) return 1;
    const double front = largest_cosine(*flat_front, back, bounds.radius);
    if (two_sided) return std::max(front, largest_cosine(-*flat_front, back, bounds.radius));
    return flat_front->dot(back) > 0 ? front : 0;
}

Lights::Lights(const Scene& scene, std::vector<std::string>& problems)
    : scene_(scene), scene_radius_(radius_of(scene.geometry)) {
    for (const PhysicalLight& light : scene.physical().lights) add(light, problems);
    double sum = 0;
    double point_sum = 0;
    for (const Source& source : sources_) {
        if (is_point_light(*source.light) && source.power > 0) {
            point_lights_.push_back(static_cast<std::uint32_t>(&source - sources_.data()));
            point_power_sums_.push_back(point_sum += source.power);
        }
        power_sums_.push_back(sum += source.power);
        samples_ += static_cast<std::size_t>(source.samples);
    }
}

/// Makes the light and the last one a quadrilateral, if they are one.
bool Lights::add_half(const PhysicalLight& light) {
    const auto* const half = std::get_if<AreaSource>(&light);
    const auto* const other =
        sources_.empty() ? nullptr : std::get_if<AreaSource>(sources_.back().light);
    if (!half || !other || half->primitive != other->primitive + 1 ||
        half->radiance != other->radiance || half->two_sided != other->two_sided) {
        return false;
    }
    AreaLight& last = area_lights_.back();
    const auto both = quadrilateral(scene_.geometry, other->primitive);
    if (!both || !std::holds_alternative<TriangleArea>(last.shape)) return false;
    last.exitance *= both->area() / std::get<TriangleArea>(last.shape).area();
    last.shape = *both;
    last.bounds = both->bounds();
    sources_.back().power = pi * last.exitance;
    return true;
}

void Lights::add(const PhysicalLight& light, std::vector<std::string>& problems) {
    if (add_half(light)) {
        numbers_.push_back(static_cast<std::uint32_t>(sources_.size() - 1));
        return;
    }
    numbers_.push_back(static_cast<std::uint32_t>(sources_.size()));
    Source source{&light, 0, 0};
    const double disk = pi * scene_radius_ * scene_radius_;
    if (const auto* point = std::get_if<PointSource>(&light)) {
        source.power = 4 * pi * luminance(point->intensity);
    } else if (const auto* spot = std::get_if<SpotSource>(&light)) {
        source.power =
            2 * pi * luminance(spot->intensity) * (1 - (spot->cos_falloff + spot->cos_total) / 2);
    } else if (const auto* goniometric = std::get_if<GoniometricSource>(&light)) {
        source.index = static_cast<std::uint32_t>(images_.size());
        images_.emplace_back(goniometric->image, problems);
        source.power = 4 * pi * luminance(goniometric->intensity);
    } else if (const auto* distant = std::get_if<DistantSource>(&light)) {
        source.power = disk * luminance(distant->radiance);
    } else if (const auto* infinite = std::get_if<InfiniteSource>(&light)) {
        source.index = static_cast<std::uint32_t>(infinite_lights_.size());
        infinite_lights_.emplace_back(*infinite, problems);
        infinite_.push_back(static_cast<std::uint32_t>(sources_.size()));
        const InfiniteLight& made = infinite_lights_.back();
        source.samples = infinite->samples;
        source.power = made.can_be_sampled() ? pi * disk * luminance(made.mean()) : 0;
    } else {
        source.index = static_cast<std::uint32_t>(area_lights_.size());
        add_area(std::get<AreaSource>(light), source.power);
        source.samples = std::get<AreaSource>(light).samples;
    }
    sources_.push_back(source);
}

void Lights::add_area(const AreaSource& source, double& power) {
    const Primitive p = scene_.geometry.primitives[source.primitive];
    const SurfaceBinding& binding = scene_.physical().bindings[p.material];
    std::optional<AreaShape> shape = area_shape(scene_.geometry, source.primitive);
    AreaLight light{shape.value_or(SphereArea(Sphere{Vec3(0), 1})),
                    source.radiance,
                    {},
                    {},
                    binding.flipped,
                    source.two_sided,
                    0};
    std::visit(
        [&](const auto& s) {
            light.bounds = s.bounds();
            light.flat_front = s.flat_normal();
            light.exitance = s.area() * luminance(source.radiance) * (source.two_sided ? 2 : 1);
        },
        light.shape);
    if (!shape) light.exitance = 0;
    if (light.flat_front && binding.flipped) *light.flat_front *= -1;
    if (binding.corner_normals) {
        const Triangle t = scene_.geometry.get<Triangle>(p);
        Vec3 mean(0);
        for (std::size_t k = 0; k < 3; ++k) {
            mean += scene_.geometry.normals[Geometry::normal_number(t, k)];
        }
        if (binding.flipped) mean = -mean;
        if (light.flat_front->dot(mean) < 0) *light.flat_front *= -1;
    }
    power = pi * light.exitance;
    area_lights_.push_back(std::move(light));
}

LightSample Lights::sample_delta(const Source& source, const Vec3& from) const {
    const SphericalImage* image = images_.empty() ? nullptr : &images_[source.index];
    return std::visit(DeltaSample{from, image}, *source.light);
}

/// About the irradiance of a light on the point if nothing is in the way, never 0 where there is
/// any.
double Lights::importance(const Source& source, const Receiver& at) const {
    if (std::holds_alternative<InfiniteSource>(*source.light)) {
        return source.power / (pi * scene_radius_ * scene_radius_);
    }
    const bool one_sided = at.normal != Vec3(0);
    if (std::holds_alternative<AreaSource>(*source.light)) {
        const AreaLight& light = area_lights_[source.index];
        const auto& [centre, radius] = light.bounds;
        const Vec3 way = centre - at.position;
        const double distance2 = std::max(way.dot(way), radius * radius);
        const double cosine = one_sided ? largest_cosine(at.normal, way, radius) : 1;
        return light.exitance * cosine * light.facing(-way) / distance2;
    }
    const LightSample sample = sample_delta(source, at.position);
    const double cosine = one_sided ? std::max(0.0, at.normal.dot(sample.wi)) : 1;
    return luminance(sample.radiance) * cosine;
}

std::optional<LightPick> Lights::pick(Receiver& at, double choice) const {
    if (sources_.size() > most_by_importance) return pick_by_power(choice);
    if (sources_.size() == 1) return LightPick{0, 1};
    std::array<double, most_by_importance> sums;
    double sum = 0;
    for (std::size_t i = 0; i < sources_.size(); ++i) sums[i] = sum += importance(sources_[i], at);
    at.total_importance = sum;
    if (!(sum > 0)) return std::nullopt;
    const double wanted = choice * sum;
    std::uint32_t light = 0;
    while (light + 1 < sources_.size() && sums[light] <= wanted) ++light;
    while (light > 0 && sums[light] == sums[light - 1]) --light;
    return LightPick{light, (sums[light] - (light == 0 ? 0 : sums[light - 1])) / sum};
}

std::optional<LightPick> Lights::pick_by_power(double choice) const {
    const double sum = power_sums_.back(), wanted = choice * sum;
    if (!(sum > 0)) return std::nullopt;
    const auto found = std::upper_bound(power_sums_.begin(), power_sums_.end(), wanted);
    const auto light = static_cast<std::uint32_t>(
        std::min<std::ptrdiff_t>(found - power_sums_.begin(), std::ssize(power_sums_) - 1));
    return LightPick{light, sources_[light].power / sum};
}

LightPick Lights::pick_point_light(double choice) const {
    const double sum = point_power_sums_.back();
    const auto found = std::ranges::upper_bound(point_power_sums_, choice * sum);
    const std::ptrdiff_t number =
        std::min<std::ptrdiff_t>(found - point_power_sums_.begin(), std::ssize(point_lights_) - 1);
    const std::uint32_t light = point_lights_[static_cast<std::size_t>(number)];
    return {light, sources_[light].power / sum};
}

double Lights::point_light_probability(std::uint32_t light) const {
    const bool is_one = std::ranges::binary_search(point_lights_, light);
    return is_one ? sources_[light].power / point_power_sums_.back() : 0;
}

double Lights::pick_probability(const Receiver& at, std::uint32_t light) const {
    if (sources_.size() > most_by_importance) return sources_[light].power / power_sums_.back();
    if (sources_.size() == 1) return 1;
    return at.total_importance > 0 ? importance(sources_[light], at) / at.total_importance : 0;
}

LightSample Lights::sample(std::uint32_t light, const Vec3& from, const Vec2& uv) const {
    const Source& source = sources_[light];
    if (std::holds_alternative<InfiniteSource>(*source.light)) {
        return infinite_lights_[source.index].sample(uv);
    }
    if (!std::holds_alternative<AreaSource>(*source.light)) {
        return sample_delta(source, from);
    }
    const AreaLight& area = area_lights_[source.index];
    if (area.turns_from(from)) return {};
    const AreaPoint point =
        std::visit([&](const auto& shape) { return shape.sample(from, uv); }, area.shape);
    const Vec3 way = point.position - from;
    LightSample s{normalized(way), point.position};
    if (!(point.pdf > 0) || !area.shines(point.normal, s.wi)) return s;
    s.radiance = area.radiance;
    s.pdf = static_cast<float>(point.pdf);
    return s;
}

double Lights::pdf(std::uint32_t light, const Vec3& from, const SurfacePoint& at) const {
    const AreaLight& area = area_lights_[sources_[light].index];
    if (area.exitance == 0) return 0;
    return std::visit([&](const auto& s) { return s.pdf(from, at.position, at.normal); },
                      area.shape);
}

Color Lights::emitted(std::uint32_t light, const SurfacePoint& at, const Vec3& ray) const {
    const AreaLight& area = area_lights_[sources_[light].index];
    return area.shines(at.normal, ray) ? area.radiance : Color(0.0F);
}

}  // namespace etalon
