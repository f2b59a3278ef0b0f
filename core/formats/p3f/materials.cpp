// mat and the old dialect's f: Cd(rgb) Kd Cs(rgb) Ks Shine T ior.
#include <algorithm>

#include "core/formats/p3f/p3f_loader.h"
#include "core/formats/p3f/p3f_statement.h"

namespace etalon {

namespace {

/// Returns the absorption of glass: light keeps exp(-(1 - Cd) d) over a distance d, and all of it
/// if Cd >= 1.
Color absorption_of(const Color& diffuse) {
    const auto of = [](float c) { return std::max(0.0F, 1 - c); };
    return {of(diffuse.x), of(diffuse.y), of(diffuse.z)};
}

}  // namespace

Material to_material(const P3fMaterial& n, bool absorbs) {
    Material m;
    m.diffuse = n.diffuse * static_cast<float>(n.kd);
    m.specular = n.specular * static_cast<float>(n.ks);
    m.shininess = n.shine;
    if (n.transmission > 0) {
        m.reflection = n.specular;
        m.transmission = Color(1.0F);
        m.fresnel = true;
        m.ior = n.ior;
        if (absorbs) m.absorption = absorption_of(n.diffuse);
    } else if (n.ks > 0) {
        m.reflection = m.specular;
    }
    return m;
}

}  // namespace etalon

namespace etalon::p3f {
namespace {

P3fMaterial read_numbers(Reader& in) {
    P3fMaterial n;
    n.diffuse = in.color("diffuse colour");
    n.kd = in.number("Kd");
    n.specular = in.color("specular colour");
    n.ks = in.number("Ks");
    n.shine = in.number("Shine");
    n.transmission = in.number("T");
    n.ior = in.number("index of refraction");
    return n;
}

/// Skips numbers after the eleven, which some programs read: a roughness, or an emission.
void pass_extra_numbers(Reader& in) {
    const std::size_t offset = in.tokens().offset();
    int count = 11;
    for (; in.tokens().at_number(); ++count) in.tokens().next();
    if (count == 12 || count == 14) {
        in.warn_at(offset, "extension",
                   "a '{}' of {} numbers ({}) is a private extension of one program; the first "
                   "11 are used",
                   in.keyword(), count, count == 12 ? "roughness" : "emission");
    } else if (count > 11) {
        in.warn_at(offset, "stray", "expected 11 numbers after '{}', found {}", in.keyword(),
                   count);
    }
}

void read_material(Loader& loader, bool absorbs) {
    const P3fMaterial n = read_numbers(loader.in);
    if (!loader.in.ok()) return;
    pass_extra_numbers(loader.in);
    loader.set_material(to_material(n, absorbs));
}

}  // namespace

void read_mat(Loader& loader) {
    read_material(loader, !loader.options.legacy);
}

void read_f(Loader& loader) {
    read_material(loader, false);
}

Material default_material() {
    return to_material({Color(0.2F), 0.2, Color(1.0F), 0.8, 20, 0, 1}, false);
}

}  // namespace etalon::p3f
