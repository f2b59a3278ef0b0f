#include "core/light/lights.h"

#include "core/light/delta_lights.h"

namespace etalon {

double Lights::power_share_of_spots() const {
    double all = 0, spots = 0;
    for (const Source& source : sources_) {
        all += source.power;
        if (std::holds_alternative<SpotSource>(*source.light)) spots += source.power;
    }
    return all > 0 ? spots / all : 0;
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
    if (area.exitance == 0 || area.turns_from(from)) return {};
    const AreaPoint point =
        std::visit([&](const auto& shape) { return shape.sample(from, uv); }, area.shape);
    const Vec3 to_light = point.position - from;
    LightSample s{normalized(to_light), point.position};
    if (!(point.pdf > 0) || !area.shines(point.normal, s.wi)) return s;
    s.radiance = area.radiance;
    s.pdf = static_cast<float>(point.pdf);
    s.is_delta = area.is_unseen;
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
