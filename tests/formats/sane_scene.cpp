#include "tests/formats/sane_scene.h"

#include <variant>

namespace etalon {
namespace {

bool fine(const Light& light) {
    if (const auto* p = std::get_if<PointLight>(&light))
        return is_finite(p->position) && is_finite(p->color);
    const auto& q = std::get<QuadLight>(light);
    return is_finite(q.corner) && is_finite(q.edge1) && is_finite(q.edge2) && q.samples > 0;
}
bool fine(const Material& m) {
    return is_finite(m.ambient) && is_finite(m.diffuse) && is_finite(m.specular) &&
           is_finite(m.reflection) && is_finite(m.transmission) && is_finite(m.absorption) &&
           m.shininess >= 0 && m.ior >= 0;
}
bool fine(const Camera& c) {
    return is_finite(c.eye) && is_finite(c.at) && c.eye != c.at && c.aperture >= 0;
}
bool fine(const RenderSettings& s) {
    const Imath::V2i& size = s.resolution;
    return size.x > 0 && size.y > 0 && size.x <= 65536 && size.y <= 65536 &&
           s.samples_per_pixel >= 0 && s.max_depth > 0;
}

bool fine(const Geometry&, const Sphere& s) {
    return is_finite(s.centre) && s.radius > 0;
}
bool fine(const Geometry& g, const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = t.vertices[k];
        const bool is_decimal = (v & decimal_vertex) != 0;
        if (is_decimal && (v & ~decimal_vertex) >= g.decimal_vertices.size()) return false;
        if (!is_decimal && v >= g.vertices.size()) return false;
        if (t.normal_offset == no_index) continue;
        if (is_decimal || Geometry::normal_number(t, k) >= g.normals.size()) return false;
    }
    return true;
}
bool fine(const Geometry&, const Polygon& p) {
    const auto all_finite = [](std::span<const Vec3> list) {
        return std::ranges::all_of(list, [](const Vec3& v) { return is_finite(v); });
    };
    return p.corners.size() > 3 && all_finite(p.corners) && all_finite(p.normals) &&
           (p.normals.empty() || p.normals.size() == p.corners.size());
}
bool fine(const Geometry&, const Box& b) {
    return is_finite(b.min) && is_finite(b.max) && b.min.x <= b.max.x && b.min.y <= b.max.y &&
           b.min.z <= b.max.z;
}
bool fine(const Geometry&, const Plane& p) {
    return is_finite(p.point) && is_finite(p.normal) && p.normal != Vec3(0);
}
bool fine(const Geometry&, const Cone& c) {
    return is_finite(c.base) && is_finite(c.top) && c.base_radius >= 0 && c.top_radius >= 0 &&
           c.base_radius + c.top_radius > 0;
}
bool fine(const Geometry&, const Ring& r) {
    return is_finite(r.centre) && is_finite(r.normal) && r.normal != Vec3(0) && r.inner >= 0 &&
           r.inner <= r.outer && r.outer > 0;
}
bool fine(const Geometry&, const Quadric& s) {
    const auto is_number = [](double x) { return std::isfinite(x); };
    return is_finite(s.centre) && is_finite(s.clip.min) && is_finite(s.clip.max) &&
           !s.clip.isEmpty() &&
           std::all_of(s.coefficients.begin(), s.coefficients.end(), is_number);
}
bool fine(const Geometry&, const Ellipsoid& e) {
    return e.frame.exists();
}
bool fine(const Geometry&, const ClosedCylinder& c) {
    return c.frame.exists();
}
bool fine(const Geometry&, const Revolved& s) {
    return s.exists();
}
bool fine(const Geometry&, const StoredCurve& c) {
    return c.place.exists() && (c.curve.widths[0] != 0 || c.curve.widths[1] != 0);
}

template <class List>
bool all_fine(const List& list) {
    for (const auto& item : list) {
        if (!fine(item)) return false;
    }
    return true;
}

bool all_finite(std::span<const Vec3> list) {
    for (const Vec3& v : list) {
        if (!is_finite(v)) return false;
    }
    return true;
}

/// Returns what is wrong with a geometry of so many materials; empty if nothing is.
std::string insanity(const Geometry& geometry, std::size_t materials) {
    if (!all_finite(geometry.vertices)) return "vertex";
    if (!all_finite(geometry.normals)) return "normal";
    for (const Primitive p : geometry.primitives) {
        if (p.material >= materials) return "a primitive's material";
        const bool good = with_shape(p.kind, [&]<class Shape>() {
            return p.index < geometry.all<Shape>().size() && fine(geometry, geometry.get<Shape>(p));
        });
        if (!good) return std::string(kind_name(p.kind));
    }
    for (const Instance& instance : geometry.instances) {
        if (instance.object >= geometry.objects.size() || !instance.exists()) return "instance";
    }
    for (const Geometry& object : geometry.objects) {
        const std::string why = insanity(object, materials);
        if (!why.empty()) return why;
        if (object.primitives.empty() || !object.instances.empty()) return "object";
    }
    return {};
}

}  // namespace

std::string insanity(const LoadResult& result) {
    const Scene& scene = *result.scene;
    if (!fine(result.settings)) return "settings";
    if (!fine(scene.camera)) return "camera";
    if (!all_fine(scene.whitted().lights)) return "light";
    if (!all_fine(scene.whitted().materials)) return "material";
    return insanity(scene.geometry, scene.whitted().materials.size());
}

}  // namespace etalon
