// Collects the lights of a scene and prepares the choice between them.
#include <algorithm>
#include <numbers>

#include "core/intersect/kernels.h"
#include "core/light/delta_lights.h"
#include "core/light/lights.h"
#include "core/light/scene_radius.h"
#include "core/light/strength.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Bounds of the lights that are points.
struct PointBounds {
    LightBounds operator()(const SpotSource& s) const {
        const double falloff = std::acos(std::clamp(s.cos_falloff, -1.0, 1.0)),
                     total = std::acos(std::clamp(s.cos_total, -1.0, 1.0));
        return {Box3(s.position),
                {s.axis, falloff, std::max(0.0, total - falloff), false},
                strength(s.intensity)};
    }
    template <class Other>
    LightBounds operator()(const Other& s) const {
        if constexpr (requires { s.position; }) {
            return {Box3(s.position), {{0, 0, 1}, pi, 0, false}, strength(s.intensity)};
        }
        return {};
    }
};

bool is_point_light(const PhysicalLight& light) {
    return std::holds_alternative<PointSource>(light) ||
           std::holds_alternative<SpotSource>(light) ||
           std::holds_alternative<GoniometricSource>(light);
}

/// Returns the name of a light's image; null if its kind has none.
const std::string* image_file(const PhysicalLight& light) {
    if (const auto* const g = std::get_if<GoniometricSource>(&light)) return &g->image;
    if (const auto* const p = std::get_if<ProjectionSource>(&light)) return &p->image;
    return nullptr;
}

}  // namespace

Lights::Lights(const Scene& scene, std::vector<std::string>& problems, SkySampling sky_sampling)
    : scene_(scene), scene_radius_(etalon::scene_radius(scene.geometry)) {
    reserve_areas();
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
        return area_lights_[source.index].light_bounds(scene_.geometry);
    }
    return std::visit(PointBounds{}, *source.light);
}

/// Takes the memory that all area lights may need, as growing lists would be copied several times.
void Lights::reserve_areas() {
    std::size_t primitives = 0;
    for (const PhysicalLight& light : scene_.physical().lights) {
        if (const auto* const area = std::get_if<AreaSource>(&light)) primitives += area->count;
    }
    sources_.reserve(primitives);
    area_lights_.reserve(primitives);
    numbers_.reserve(primitives);
}

void Lights::add(const PhysicalLight& light, std::vector<std::string>& problems,
                 SkySampling sky_sampling) {
    number_offsets_.push_back(0);
    if (std::holds_alternative<InfiniteSource>(light)) {
        sources_.push_back(infinite_source(light, problems, sky_sampling));
    } else if (!std::holds_alternative<AreaSource>(light)) {
        sources_.push_back(delta_source(light, problems));
    } else {
        add_areas(light);
    }
}

void Lights::add_areas(const PhysicalLight& light) {
    const auto& [first, count, radiance, two_sided, samples] = std::get<AreaSource>(light);
    number_offsets_.back() = first - static_cast<std::uint32_t>(numbers_.size());
    for (std::uint32_t primitive = first; primitive < first + count; ++primitive) {
        if (primitive == first || !join_half(primitive)) {
            sources_.push_back(area_source(light, primitive));
        }
        numbers_.push_back(static_cast<std::uint32_t>(sources_.size() - 1));
    }
}

/// Joins a primitive to the light of the previous one, if they form a quadrilateral.
bool Lights::join_half(std::uint32_t primitive) {
    AreaLight& last = area_lights_.back();
    if (last.primitive + 1 != primitive || !std::holds_alternative<TriangleArea>(last.shape)) {
        return false;
    }
    const auto both = quadrilateral(scene_.geometry, last.primitive);
    if (!both) return false;
    last.join(*both);
    sources_.back().power = pi * last.exitance;
    return true;
}

/// Returns the number of a light's image. Lights of the same file share it.
std::uint32_t Lights::image_number(const std::string& file, std::vector<std::string>& problems) {
    const auto next = static_cast<std::uint32_t>(images_.size());
    const auto [place, is_new] = image_numbers_.try_emplace(file, next);
    if (is_new) images_.emplace_back(file, problems);
    return place->second;
}

Lights::Source Lights::delta_source(const PhysicalLight& light,
                                    std::vector<std::string>& problems) {
    const std::string* const file = image_file(light);
    const std::uint32_t index = file ? image_number(*file, problems) : 0;
    const SphericalImage* const image = file ? &images_[index] : nullptr;
    return {&light, index, delta_light_power(light, image, scene_radius_)};
}

Lights::Source Lights::infinite_source(const PhysicalLight& light,
                                       std::vector<std::string>& problems,
                                       SkySampling sky_sampling) {
    const auto& source = std::get<InfiniteSource>(light);
    const auto index = static_cast<std::uint32_t>(infinite_lights_.size());
    const InfiniteLight& made = infinite_lights_.emplace_back(source, problems, sky_sampling);
    infinite_.push_back(static_cast<std::uint32_t>(sources_.size()));
    const double disk = pi * scene_radius_ * scene_radius_;
    const double power = made.can_be_sampled() ? pi * disk * strength(made.mean()) : 0;
    return {&light, index, power, source.samples};
}

Lights::Source Lights::area_source(const PhysicalLight& light, std::uint32_t primitive) {
    const auto& source = std::get<AreaSource>(light);
    const auto index = static_cast<std::uint32_t>(area_lights_.size());
    const AreaLight& made = area_lights_.emplace_back(area_light(scene_, source, primitive));
    return {&light, index, pi * made.exitance, source.samples};
}

}  // namespace etalon
