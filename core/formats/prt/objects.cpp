// surface, hsphere, ring and quadric. Those that cannot be seen are left out with a warning.
#include <algorithm>

#include "core/formats/polygon_normal.h"
#include "core/formats/prt/prt_loader.h"
#include "core/numerics/rounding.h"

namespace etalon::prt {
namespace {

/// A colour and its weight.
Color read_weighted(Reader& in, std::string_view color_name, std::string_view weight_name) {
    const Color color = in.color(color_name);
    return color * static_cast<float>(in.number(weight_name));
}

/// Returns the material of the inner side of a shell: matter in front of it, nothing behind.
std::uint32_t hollow(Loader& loader) {
    Material inner = loader.scene.whitted().materials[loader.current_material()];
    inner.ior = 1 / inner.ior;
    loader.scene.whitted().materials.push_back(inner);
    return static_cast<std::uint32_t>(loader.scene.whitted().materials.size() - 1);
}

}  // namespace

/// Reads a material, unless the same text has been read before. With an exponent of 0 it has no
/// highlight.
void read_surface(Loader& loader) {
    Reader& in = loader.in;
    Material m;
    m.reflection = read_weighted(in, "reflected colour", "Ks");
    m.transmission = read_weighted(in, "refracted colour", "T");
    m.ambient = in.color("ambient colour");
    m.diffuse = in.color("diffuse colour");
    m.specular = in.color("specular colour");
    m.shininess = in.number("exponent");
    m.highlight = Highlight::phong;
    const double ior = in.number("index of refraction");
    if (m.shininess == 0) m.specular = Color(0.0F);
    if (m.transmission != Color(0.0F)) m.ior = ior;
    if (!in.ok()) return;
    const std::string_view words =
        loader.text.substr(in.start(), in.tokens().offset() - in.start());
    const auto known = loader.surfaces.find(words);
    if (known != loader.surfaces.end()) {
        loader.material = known->second;
    } else if (loader.set_material(m)) {
        loader.surfaces.emplace(words, *loader.material);
    }
}

/// Reads a hollow sphere: two spheres, the inner one with the outside of matter.
void read_hollow_sphere(Loader& loader) {
    Reader& in = loader.in;
    const Vec3 centre = in.vector("centre");
    const double radius = in.number("radius"), thickness = in.number("thickness");
    if (!in.ok()) return;
    if (!(radius > 0)) return loader.skip_degenerate("its radius is not more than 0");
    if (!(thickness > 0 && thickness <= radius)) {
        return loader.skip_degenerate("its thickness is not more than 0 and at most its radius");
    }
    const Sides sides = loader.sides();
    loader.add(Sphere{centre, radius}, sides);
    if (!(radius - thickness > 0)) return;
    loader.scene.geometry.add(Sphere{centre, radius - thickness}, hollow(loader),
                              sides == Sides::both ? Sides::both : Sides::back);
}

/// Reads a ring. Its two points about the centre only define the plane. (The document's text has
/// the inner radius first; its synopsis and its program have the outer one.)
void read_ring(Loader& loader) {
    Reader& in = loader.in;
    const std::array points = {in.vector("centre"), in.vector("first point"),
                               in.vector("second point")};
    const double outer = in.number("outer radius"), inner = in.number("inner radius");
    if (!in.ok()) return;
    const Vec3 normal = area_normal(points);
    if (!is_finite(normal) || normal == Vec3(0)) {
        return loader.skip_degenerate("its points span no plane");
    }
    if (!(outer > 0)) return loader.skip_degenerate("its outer radius is not more than 0");
    if (!(inner >= 0 && inner <= outer)) {
        return loader.skip_degenerate(
            "its inner radius, the second, is not between 0 and the outer one");
    }
    loader.add(Ring{points[0], to_unit_magnitude(normal), inner, outer}, loader.sides());
}

/// Reads a quadric: `center`, the box it is cut to, and the coefficients a ... j.
void read_quadric(Loader& loader) {
    Reader& in = loader.in;
    Quadric q{in.vector("center"), {}, Box3()};
    const Vec3 a = in.vector("box's lower corner"), b = in.vector("box's upper corner");
    for (double& c : q.coefficients) c = in.number("coefficient");
    if (!in.ok()) return;
    q.clip.extendBy(a);
    q.clip.extendBy(b);
    const auto end = q.coefficients.end() - 1;  // the last alone defines no surface
    if (std::all_of(q.coefficients.begin(), end, [](double c) { return c == 0; })) {
        return loader.skip_degenerate("its coefficients are all 0");
    }
    if (q.clip.min != a) {
        in.warn("degenerate",
                "the corners of the box are not the lower and the upper one; exchanged");
    }
    loader.add(q, loader.sides());
}

}  // namespace etalon::prt
