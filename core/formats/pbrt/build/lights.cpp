// Lights of a frame that are not shapes.
#include <array>
#include <numbers>

#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {
namespace {

using Lights = std::vector<PhysicalLight>;

Color scaled(const Parameters& p, std::string_view name) {
    return p.color(name) * p.color("scale");
}

Vec3 point_of(const Parameters& p, std::string_view name) {
    return Vec3(p.vector(name));
}

/// The position is that of pbrt-v3: `from` is in world space, relative to where the origin is.
void add_point(const Parameters& p, const Affine& to_world, Lights& to) {
    to.emplace_back(PointSource{to_world.origin + point_of(p, "from"), scaled(p, "I")});
}

void add_spot(const Parameters& p, const Affine& to_world, Lights& to) {
    const auto cosine = [](float degrees) { return std::cos(degrees * std::numbers::pi / 180); };
    const float cone = p.number("coneangle"), falloff = cone - p.number("conedeltaangle");
    to.emplace_back(SpotSource{to_world.point(point_of(p, "from")),
                               normalized(to_world.vector(point_of(p, "to") - point_of(p, "from"))),
                               scaled(p, "I"), cosine(cone), cosine(falloff)});
}

void add_distant(const Parameters& p, const Affine& to_world, Lights& to) {
    to.emplace_back(DistantSource{
        normalized(to_world.vector(point_of(p, "from") - point_of(p, "to"))), scaled(p, "L")});
}

void add_infinite(const Parameters& p, const Affine& to_world, Lights& to) {
    to.emplace_back(
        InfiniteSource{scaled(p, "L"), std::string(p.string("mapname")), inverse(to_world)});
}

void add_goniometric(const Parameters& p, const Affine& to_world, Lights& to) {
    to.emplace_back(GoniometricSource{to_world.origin, scaled(p, "I"),
                                      std::string(p.string("mapname")), inverse(to_world)});
}

void add_projection(const Parameters& p, const Affine& to_world, Lights& to) {
    const double half_tangent = std::tan(p.number("fov") / 2 * (std::numbers::pi / 180));
    to.emplace_back(ProjectionSource{to_world.origin, scaled(p, "I"),
                                     std::string(p.string("mapname")), inverse(to_world),
                                     half_tangent});
}

struct Entry {
    std::string_view name;
    void (*add)(const Parameters&, const Affine&, Lights&);
};

constexpr std::array entries = {
    Entry{"point", add_point},
    Entry{"spot", add_spot},
    Entry{"distant", add_distant},
    Entry{"infinite", add_infinite},
    Entry{"goniometric", add_goniometric},
    Entry{"projection", add_projection},
};

bool is_finite(const PhysicalLight& light) {
    return std::visit(
        [](const auto& l) {
            bool fine = true;
            if constexpr (requires { l.position; }) fine = fine && etalon::is_finite(l.position);
            if constexpr (requires { l.axis; }) fine = fine && etalon::is_finite(l.axis);
            if constexpr (requires { l.direction; }) fine = fine && etalon::is_finite(l.direction);
            if constexpr (requires { l.half_tangent; })
                fine = fine && std::isfinite(l.half_tangent);
            if constexpr (requires { l.intensity; }) fine = fine && etalon::is_finite(l.intensity);
            if constexpr (requires { l.radiance; }) fine = fine && etalon::is_finite(l.radiance);
            return fine;
        },
        light);
}

}  // namespace

void build_lights(SceneBuilder& b) {
    for (const pbrt::Light& light : b.frame.lights) {
        warn_of_stand_in(b, light.plugin);
        const auto* const entry = std::ranges::find(entries, light.plugin.type->name, &Entry::name);
        const std::optional<Affine> to_world = b.affine(light.to_world, light.plugin.where);
        if (entry == entries.end() || !to_world) continue;
        Lights& lights = b.look().lights;
        entry->add(light.plugin.parameters, *to_world, lights);
        if (light.plugin.type->find("mapname")) {
            const std::string map(light.plugin.parameters.string("mapname"));
            if (!map.empty()) b.name_image(map, light.plugin.where, "a light without an image");
        }
        if (auto* source = std::get_if<InfiniteSource>(&lights.back())) {
            source->samples = light_samples(b, light.plugin.parameters);
        }
        if (is_finite(lights.back())) continue;
        lights.pop_back();
        b.warn(light.plugin.where, "light", "light left out: not all its numbers are finite");
    }
}

}  // namespace etalon::pbrt
