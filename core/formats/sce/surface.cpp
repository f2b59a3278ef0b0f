// ca, cr, cp and shininess: the surface of subsequent shapes.
#include "core/formats/sce/sce_loader.h"

namespace etalon::sce {
namespace {

/// Returns the reflected ambient light: `cr` times the ambient light `ca`.
Color sent_back(const Surface& s) {
    return s.ambient * s.diffuse;
}

Material material_of(const Surface& s) {
    Material m;
    m.ambient = sent_back(s);
    m.diffuse = s.diffuse;
    m.specular = m.reflection = s.specular;
    m.shininess = s.shininess;
    return m;
}

void read_color(Loader& loader, Reader& in, Color Surface::*color) {
    Surface s = loader.state.surface;
    s.*color = in.color("colour");
    if (!in.ok()) return;
    if (!is_finite(sent_back(s)))
        return in.warn("range", "'ca' times 'cr' is too large for a colour");
    loader.state.surface = s;
    loader.state.material.reset();
}

}  // namespace

void read_ambient(Loader& loader, Reader& in) {
    read_color(loader, in, &Surface::ambient);
}

void read_diffuse(Loader& loader, Reader& in) {
    read_color(loader, in, &Surface::diffuse);
}

void read_specular(Loader& loader, Reader& in) {
    read_color(loader, in, &Surface::specular);
}

void read_shininess(Loader& loader, Reader& in) {
    const double shininess = in.number("exponent");
    if (!in.ok()) return;
    if (shininess < 0) {
        return in.warn("range", "the shininess is {}; expected 0 or more", shininess);
    }
    loader.state.surface.shininess = shininess;
    loader.state.material.reset();
}

std::uint32_t Loader::current_material() {
    if (!state.material) {
        state.material = static_cast<std::uint32_t>(scene.whitted().materials.size());
        scene.whitted().materials.push_back(material_of(state.surface));
    }
    return *state.material;
}

}  // namespace etalon::sce
