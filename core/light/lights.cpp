#include "core/light/lights.h"

#include <algorithm>
#include <numbers>

#include "core/intersect/kernels.h"
#include "core/light/delta_lights.h"
#include "core/numerics/luminance.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

Box3 box_of_primitives(const Geometry& geometry) {
    Box3 box;
    for (std::uint32_t i = 0; i < geometry.primitives.size(); ++i) {
        const Box3 bounds = primitive_bounds(geometry, i);
        if (is_finite(bounds.min) && is_finite(bounds.max)) box.extendBy(bounds);
    }
    return box;
}

/// Extends a box by that of an object placed by a map, if that is finite.
void extend(Box3& box, const Affine& map, const Box3& object) {
    const Vec3 centre = map.point(object.center()), half = object.size() / 2;
    const Vec3 reach = half.x * abs(map.x) + half.y * abs(map.y) + half.z * abs(map.z);
    if (is_finite(centre) && is_finite(reach)) box.extendBy({centre - reach, centre + reach});
}

/// Returns half the diagonal of the box of everything bounded, when the shutter opens. It only
/// weights lights at infinity, which needs no more precision.
double radius_of(const Geometry& geometry) {
    Box3 box = box_of_primitives(geometry);
    std::vector<Box3> objects;
    for (const Geometry& object : geometry.objects) objects.push_back(box_of_primitives(object));
    for (const Instance& instance : geometry.instances) {
        const Box3& object = objects[instance.object];
        if (!object.isEmpty()) extend(box, instance.to_world(), object);
    }
    return box.isEmpty() ? 1 : box.size().length() / 2;
}

/// Returns the solid angle of a rectangle with these half sides at distance 1, about its middle.
double solid_angle(const Vec2& half) {
    const double diagonal = std::sqrt(1 + half.length2());
    return 4 * std::atan(half.x * half.y / diagonal);
}

/// Bounds of the lights that are points.
struct PointBounds {
    LightBounds operator()(const SpotSource& s) const {
        const double falloff = std::acos(std::clamp(s.cos_falloff, -1.0, 1.0)),
                     total = std::acos(std::clamp(s.cos_total, -1.0, 1.0));
        return {Box3(s.position),
                {s.axis, falloff, std::max(0.0, total - falloff), false},
                luminance(s.intensity)};
    }
    template <class Other>
    LightBounds operator()(const Other& s) const {
        if constexpr (requires { s.position; }) {
            return {Box3(s.position), {{0, 0, 1}, pi, 0, false}, luminance(s.intensity)};
        }
        return {};
    }
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

/// Returns whether a one-sided flat light shines only to the other side of its plane.
bool Lights::AreaLight::turns_from(const Vec3& point) const {
    return flat_front && !two_sided && flat_front->dot(point - bounds.centre) <= 0;
}

Lights::Lights(const Scene& scene, std::vector<std::string>& problems, SkySampling sky_sampling)
    : scene_(scene), scene_radius_(radius_of(scene.geometry)) {
    for (const PhysicalLight& light : scene.physical().lights) add(light, problems, sky_sampling);
    double point_power = 0;
    for (const Source& source : sources_) {
        samples_ += static_cast<std::size_t>(source.samples);
        if (!is_point_light(*source.light) || !(source.power > 0)) continue;
        point_lights_.push_back(static_cast<std::uint32_t>(&source - sources_.data()));
        point_power_sums_.push_back(point_power += source.power);
    }
    if (sources_.size() > most_by_importance) make_tree();
}

double Lights::power_share_of_spots() const {
    double all = 0, spots = 0;
    for (const Source& source : sources_) {
        all += source.power;
        if (std::holds_alternative<SpotSource>(*source.light)) spots += source.power;
    }
    return all > 0 ? spots / all : 0;
}

void Lights::make_tree() {
    std::vector<LightBounds> bounds(sources_.size());
    for (std::uint32_t i = 0; i < sources_.size(); ++i) {
        const PhysicalLight& light = *sources_[i].light;
        if (std::holds_alternative<InfiniteSource>(light) ||
            std::holds_alternative<DistantSource>(light)) {
            far_.push_back(i);
        } else {
            bounds[i] = bounds_of(sources_[i]);
        }
    }
    tree_.emplace(bounds);
}

/// Returns the bounds of a light at a finite distance.
LightBounds Lights::bounds_of(const Source& source) const {
    if (std::holds_alternative<AreaSource>(*source.light)) {
        const AreaLight& light = area_lights_[source.index];
        const double sides = light.two_sided ? 2 : 1;
        if (!light.flat_front) {  // a sphere shows a quarter of its area
            return {light.box, {{0, 0, 1}, pi, pi / 2, false}, light.exitance / (4 * sides)};
        }
        return {light.box, {*light.flat_front, 0, pi / 2, light.two_sided}, light.exitance / sides};
    }
    return std::visit(PointBounds{}, *source.light);
}

/// Joins the light and the previous one to a quadrilateral, if they form one.
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
    last.box.extendBy(primitive_bounds(scene_.geometry, half->primitive));
    sources_.back().power = pi * last.exitance;
    return true;
}

void Lights::add(const PhysicalLight& light, std::vector<std::string>& problems,
                 SkySampling sky_sampling) {
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
    } else if (const auto* projection = std::get_if<ProjectionSource>(&light)) {
        source.index = static_cast<std::uint32_t>(images_.size());
        images_.emplace_back(projection->image, problems);
        source.power = solid_angle(half_window(*projection, images_.back())) *
                       luminance(projection->intensity);
    } else if (const auto* distant = std::get_if<DistantSource>(&light)) {
        source.power = disk * luminance(distant->radiance);
    } else if (const auto* infinite = std::get_if<InfiniteSource>(&light)) {
        source.index = static_cast<std::uint32_t>(infinite_lights_.size());
        infinite_lights_.emplace_back(*infinite, problems, sky_sampling);
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
    light.box = primitive_bounds(scene_.geometry, source.primitive);
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
    return sample_delta_light(*source.light, image, from);
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
