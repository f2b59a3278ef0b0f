#include "core/convert/physical_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etalon {
namespace {

const Color black(0.0F);

/// Least distance and cosine for which a light's intensity compensates, the first relative to the
/// distance from the eye to the point looked at. Otherwise a light right there would go out.
constexpr double smallest_part = 0.25;

/// Converts the lights of one scene.
class LightMaker {
  public:
    LightMaker(const Camera& camera, const LightValues& light, Geometry& geometry, PhysicalLook& to)
        : camera_(camera), light_(light), geometry_(geometry), to_(to) {}

    void operator()(const PointLight& l) const {
        to_.lights.emplace_back(PointSource{l.position, light_(l.color) * intensity(l.position)});
    }

    void operator()(const QuadLight& l) const {
        const Vec3 normal = l.edge1.cross(l.edge2), centre = l.corner + (l.edge1 + l.edge2) / 2;
        const double area = normal.length();
        if (!(area > 0)) return (*this)(PointLight{centre, l.color});
        const Vec3 to_camera = camera_.at - centre;
        const double cosine = std::abs(normal.dot(to_camera)) / (area * to_camera.length());
        const double facing = cosine > smallest_part ? cosine : smallest_part;
        add_quadrilateral(l,
                          light_(l.color) * intensity(centre) / static_cast<float>(area * facing));
    }

  private:
    /// Compensates for the falloff with the square of the distance, at the point looked at, and for
    /// diffuse surfaces, which reflect 1 / pi of the light into every direction.
    float intensity(const Vec3& position) const {
        const Vec3 offset = camera_.at - position, view = camera_.at - camera_.eye;
        const double distance2 =
            std::max(offset.dot(offset), smallest_part * smallest_part * view.dot(view));
        return static_cast<float>(std::numbers::pi * distance2);
    }

    void add_quadrilateral(const QuadLight& l, const Color& radiance) const {
        const auto first = static_cast<std::uint32_t>(geometry_.primitives.size());
        SurfaceBinding binding;
        binding.material = static_cast<std::uint32_t>(to_.materials.size());
        binding.light = static_cast<std::uint32_t>(to_.lights.size());
        to_.materials.push_back({MatteMaterial{{black}, {0.0F}}});
        const std::uint32_t a = geometry_.add_vertex(l.corner);
        const std::uint32_t b = geometry_.add_vertex(l.corner + l.edge1);
        const std::uint32_t c = geometry_.add_vertex(l.corner + l.edge1 + l.edge2);
        const std::uint32_t d = geometry_.add_vertex(l.corner + l.edge2);
        const auto number = static_cast<std::uint32_t>(to_.bindings.size());
        geometry_.add(Triangle{{a, b, c}}, number);
        geometry_.add(Triangle{{a, c, d}}, number);
        to_.bindings.push_back(binding);
        to_.lights.emplace_back(AreaSource{first, 2, radiance, true});
    }

    const Camera& camera_;
    const LightValues& light_;
    Geometry& geometry_;
    PhysicalLook& to_;
};

}  // namespace

void add_physical_lights(const WhittedLook& from, const Camera& camera, const LightValues& light,
                         Geometry& geometry, PhysicalLook& to) {
    const LightMaker make(camera, light, geometry, to);
    for (const Light& l : from.lights) std::visit(make, l);
}

void add_physical_environment(const Environment& from, const LightValues& light, PhysicalLook& to) {
    if (!from.skybox && from.background == black) return;
    InfiniteSource source{light(from.background)};
    if (from.skybox) source.skybox = Environment{light(from.background), from.skybox};
    to.lights.emplace_back(std::move(source));
}

}  // namespace etalon
