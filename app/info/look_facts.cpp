#include "app/info/look_facts.h"

#include <algorithm>

namespace etalon {
namespace {

LookFacts facts_of(const WhittedLook& look) {
    LookFacts facts{look.materials.size()};
    for (const Light& light : look.lights) {
        facts.count_lights(std::holds_alternative<QuadLight>(light) ? "quad" : "point", 1);
    }
    const Color& background = look.environment.background;
    facts.background = {background.x, background.y, background.z};
    if (look.environment.skybox) facts.skybox = look.environment.skybox->faces;
    const auto any = [&](bool (*test)(const Material&)) {
        return std::ranges::any_of(look.materials, test);
    };
    facts.need(any([](const Material& m) { return m.reflection != Color(0.0F); }),
               "reflected rays");
    facts.need(any([](const Material& m) { return m.transmission != Color(0.0F); }),
               "refracted rays");
    facts.need(any([](const Material& m) { return m.absorption != Color(0.0F); }), "absorption");
    facts.need(facts.lights.contains("quad"), "area light samples");
    facts.need(look.environment.skybox.has_value(), "images");
    return facts;
}

LookFacts facts_of(const PhysicalLook& look) {
    LookFacts facts{look.materials.size()};
    constexpr std::string_view kinds[] = {"point",   "spot",     "goniometric", "projection",
                                          "distant", "infinite", "area"};
    static_assert(std::size(kinds) == std::variant_size_v<PhysicalLight>);
    for (const PhysicalLight& light : look.lights) {
        const auto* const area = std::get_if<AreaSource>(&light);
        facts.count_lights(kinds[light.index()], area ? area->count : 1);
    }
    facts.need(facts.lights.contains("area"), "area light samples");
    facts.need(!look.textures.numbers.empty() || !look.textures.colors.empty(), "textures");
    facts.need(!look.textures.images.empty(), "images");
    facts.need(!look.media.empty(), "media");
    return facts;
}

/// Returns whether a shape has corner normals, also one of an object.
bool has_normals(const Geometry& geometry) {
    return !geometry.normals.empty() || geometry.all<Polygon>().have_normals() ||
           std::ranges::any_of(geometry.objects, has_normals);
}

}  // namespace

void LookFacts::count_lights(std::string_view kind, std::uint32_t more) {
    nlohmann::ordered_json& count = lights[std::string(kind)];
    count = count.is_null() ? more : count.get<std::uint32_t>() + more;
}

LookFacts facts_of(const Scene& s, const RenderSettings& settings) {
    LookFacts facts = std::visit([](const auto& look) { return facts_of(look); }, s.look);
    const bool has_lens = s.camera.projective
                              ? s.camera.projective->lens_radius > 0 || s.camera.projective->lens
                              : s.camera.aperture > 0;
    facts.need(has_lens && settings.samples_per_pixel > 0, "lens samples");
    facts.need(s.camera.sees_motion && settings.samples_per_pixel > 0, "time samples");
    facts.need(has_normals(s.geometry), "interpolated normals");
    return facts;
}

}  // namespace etalon
