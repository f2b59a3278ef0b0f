#include "tests/formats/same_scene.h"

#include <span>
#include <tuple>
#include <variant>

#include "core/formats/polygon_normal.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

auto fields(const Camera& c) {
    return std::tuple(c.eye, c.at, c.up, c.fov_degrees, c.aperture, c.focal, c.stretched);
}
auto fields(const PointLight& l) {
    return std::tuple(l.position, l.color);
}
auto fields(const QuadLight& l) {
    return std::tuple(l.corner, l.edge1, l.edge2, l.color, l.samples);
}
auto fields(const Material& m) {
    return std::tuple(m.ambient, m.diffuse, m.specular, m.shininess, m.highlight, m.reflection,
                      m.transmission, m.fresnel, m.ior, m.absorption);
}
auto fields(const WhittedRules& r) {
    return std::tuple(r.schlick, r.clamp_each_ray, r.normalize_camera_rays, r.mirror_all_glass,
                      r.fixed_bias);
}
auto fields(const RenderSettings& s) {
    return std::tuple(s.resolution, s.display_colors, s.samples_per_pixel, s.pixel_rays,
                      s.max_depth, fields(s.whitted), s.backend);
}
auto fields(const Environment& e) {
    return std::tuple(e.background, e.skybox.has_value());
}

auto fields(const Scene&, const Sphere& s) {
    return std::tuple(s.centre, s.radius);
}
auto fields(const Scene&, const Box& b) {
    return std::tuple(b.min, b.max);
}
auto fields(const Scene&, const Plane& p) {
    return std::tuple(p.point, to_unit_magnitude(p.normal));
}
auto fields(const Scene&, const Cone& c) {
    return std::tuple(c.base, c.top, c.base_radius, c.top_radius);
}
auto fields(const Affine& m) {
    return std::tuple(m.x, m.y, m.z, m.origin);
}
auto fields(const Scene&, const Ellipsoid& e) {
    return fields(e.to_world);
}
auto fields(const Scene&, const ClosedCylinder& c) {
    return fields(c.to_world);
}
auto fields(const Profile& p) {
    return std::tuple(p.along, p.squares, p.low, p.high, p.falls);
}
auto fields(const TurningDirection& d) {
    return std::tuple(d.at, d.per_height);
}
auto fields(const Scene&, const Revolved& s) {
    return std::tuple(fields(s.to_world), fields(s.profile), fields(s.sector.from),
                      fields(s.sector.to), s.sector.angle);
}
auto fields(const Scene& scene, const Triangle& t) {
    const Geometry& g = scene.geometry;
    std::vector<Vec3> values;
    for (const std::uint32_t v : t.vertices) values.push_back(g.vertex(v));
    for (std::size_t k = 0; t.normal_offset != no_index && k < 3; ++k) {
        values.push_back(g.normals[Geometry::normal_number(t, k)]);
    }
    return values;
}
auto fields(const Scene&, const Polygon& p) {
    std::vector<Vec3> values(p.corners.begin(), p.corners.end());
    values.insert(values.end(), p.normals.begin(), p.normals.end());
    return values;
}

bool same(const Light& a, const Light& b) {
    if (a.index() != b.index()) return false;
    const auto equal = [&](const auto& x) {
        return fields(x) == fields(std::get<std::decay_t<decltype(x)>>(b));
    };
    return std::visit(equal, a);
}

std::string difference(const Scene& a, const Primitive& p, const Scene& b, const Primitive& q) {
    if (p.kind != q.kind) return "kind";
    if (p.sides != q.sides) return "sides";
    if (fields(a.whitted().materials[p.material]) != fields(b.whitted().materials[q.material]))
        return "material";
    return with_shape(p.kind, [&]<class Shape>() -> std::string {
        if constexpr (requires(const Shape& shape) { fields(a, shape); }) {
            const bool same =
                fields(a, a.geometry.get<Shape>(p)) == fields(b, b.geometry.get<Shape>(q));
            return same ? "" : "shape";
        } else {
            return "shape of a kind that this test does not know";
        }
    });
}

}  // namespace

std::string difference(const LoadResult& first, const LoadResult& second) {
    const Scene &a = *first.scene, &b = *second.scene;
    if (fields(first.settings) != fields(second.settings)) return "settings";
    if (fields(a.camera) != fields(b.camera)) return "camera";
    if (fields(a.whitted().environment) != fields(b.whitted().environment)) return "environment";
    if (!std::equal(a.whitted().lights.begin(), a.whitted().lights.end(),
                    b.whitted().lights.begin(), b.whitted().lights.end(), same)) {
        return "lights";
    }
    if (a.geometry.primitives.size() != b.geometry.primitives.size()) return "number of primitives";
    for (std::size_t i = 0; i < a.geometry.primitives.size(); ++i) {
        const std::string what =
            difference(a, a.geometry.primitives[i], b, b.geometry.primitives[i]);
        if (!what.empty()) return what + " of primitive " + std::to_string(i);
    }
    return {};
}

}  // namespace etalon
