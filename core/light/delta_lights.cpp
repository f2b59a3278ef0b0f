#include "core/light/delta_lights.h"

#include <cmath>
#include <numbers>

#include "core/light/strength.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns a smooth transition from 0 at the border of a spotlight's cone to 1.
double spot_falloff(const SpotSource& s, const Vec3& direction) {
    const double cosine = s.axis.dot(direction);
    if (cosine < s.cos_total) return 0;
    if (cosine >= s.cos_falloff) return 1;
    const double x = (cosine - s.cos_total) / (s.cos_falloff - s.cos_total);
    return x * x * x * x;
}

LightSample from_point(const Vec3& position, const Color& intensity, const Vec3& from) {
    const Vec3 to_light = position - from;
    const double distance2 = to_light.dot(to_light);
    LightSample s{to_light / std::sqrt(distance2), position};
    s.radiance = intensity / static_cast<float>(distance2);
    s.pdf = distance2 > 0 ? 1 : 0;
    s.is_delta = true;
    return s;
}

/// Returns the value of the projection's image in a direction of the light's own space.
Color projected(const ProjectionSource& s, const SphericalImage& image, const Vec3& direction) {
    constexpr double nearest = 1e-3;  // of z in pbrt-v3: fields of view stay below 180 degrees
    if (direction.z < nearest) return Color(0.0F);
    const Vec2 place = Vec2(direction.x, direction.y) / (direction.z * half_window(s, image));
    if (std::abs(place.x) > 1 || std::abs(place.y) > 1) return Color(0.0F);
    return image.empty() ? Color(1.0F) : image.at((place + Vec2(1)) / 2);
}

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
    LightSample operator()(const ProjectionSource& s) const {
        LightSample sample = from_point(s.position, s.intensity, from);
        sample.radiance *= projected(s, *image, s.to_light.vector(-sample.wi));
        return sample;
    }
    LightSample operator()(const DistantSource& s) const {
        return {s.direction, Vec3(0), true, s.radiance, 1, true};
    }
    LightSample operator()(const InfiniteSource&) const { return {}; }
    LightSample operator()(const AreaSource&) const { return {}; }

    const Vec3& from;
    const SphericalImage* image;  ///< of a light that has one
};

/// Returns the solid angle of a rectangle with these half sides at distance 1, about its middle.
double solid_angle(const Vec2& half) {
    const double diagonal = std::sqrt(1 + half.length2());
    return 4 * std::atan(half.x * half.y / diagonal);
}

struct DeltaPower {
    double operator()(const PointSource& s) const { return 4 * pi * strength(s.intensity); }
    double operator()(const SpotSource& s) const {
        return 2 * pi * strength(s.intensity) * (1 - (s.cos_falloff + s.cos_total) / 2);
    }
    double operator()(const GoniometricSource& s) const { return 4 * pi * strength(s.intensity); }
    double operator()(const ProjectionSource& s) const {
        return solid_angle(half_window(s, *image)) * strength(s.intensity);
    }
    double operator()(const DistantSource& s) const {
        return pi * scene_radius * scene_radius * strength(s.radiance);
    }
    double operator()(const InfiniteSource&) const { return 0; }
    double operator()(const AreaSource&) const { return 0; }

    const SphericalImage* image;  ///< of a light that has one
    double scene_radius;
};

}  // namespace

Vec2 half_window(const ProjectionSource& s, const SphericalImage& image) {
    const double aspect = image.empty() ? 1 : image.aspect();
    return s.half_tangent * (aspect > 1 ? Vec2(aspect, 1) : Vec2(1, 1 / aspect));
}

LightSample sample_delta_light(const PhysicalLight& light, const SphericalImage* image,
                               const Vec3& from) {
    return std::visit(DeltaSample{from, image}, light);
}

double delta_light_power(const PhysicalLight& light, const SphericalImage* image,
                         double scene_radius) {
    return std::visit(DeltaPower{image, scene_radius}, light);
}

}  // namespace etalon
