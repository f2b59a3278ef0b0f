#include <algorithm>

#include "core/formats/polygon_normal.h"
#include "core/formats/write/exact_endpoint.h"
#include "core/formats/write/facets.h"
#include "core/formats/write/mesh_run.h"
#include "core/formats/write/p3f_material.h"
#include "core/formats/write/p3f_writer.h"
#include "core/formats/write/write.h"
#include "core/scene/transformed.h"

namespace etalon {
namespace {

class P3fScene {
  public:
    P3fScene(const Scene& scene, const RenderSettings& settings,
             const std::filesystem::path& directory)
        : scene_(scene), settings_(settings), directory_(directory) {}

    WrittenScene write() {
        write_settings();
        for (const Light& light : scene_.whitted().lights) {
            std::visit([&](const auto& l) { write_light(l); }, light);
        }
        write_shapes(scene_.geometry);
        write_instances();
        out_.flush();
        return {std::move(text_), "P3F", lost_.take()};
    }

  private:
    void write_settings() {
        if (!settings_.backend.empty()) out_.backend(settings_.backend);
        out_.samples(settings_.samples_per_pixel);
        out_.background(scene_.whitted().environment.background);
        if (scene_.whitted().environment.skybox) write_skybox(*scene_.whitted().environment.skybox);
        out_.camera(scene_.camera, settings_.resolution);
        note_rules();
    }

    /// Warns of the rules of a scene that P3F cannot express.
    void note_rules() {
        const WhittedRules& rules = settings_.whitted;
        const int p3f_depth = RenderSettings().max_depth, depth = settings_.max_depth;
        const auto sends_rays = [](const Material& m) {
            return m.reflection != Color(0.0F) || m.transmission != Color(0.0F);
        };
        if (depth != p3f_depth && std::ranges::any_of(scene_.whitted().materials, sends_rays)) {
            lost_.add(fmt::format("depth of {} rays, now {}", depth, p3f_depth));
        }
        if (rules.schlick || rules.clamp_each_ray || rules.normalize_camera_rays ||
            rules.fixed_bias != 0) {
            lost_.add("shading as an old program did it");
        }
        if (scene_.camera.stretched && settings_.resolution.x != settings_.resolution.y) {
            lost_.add("pixels that are not square");
        }
        if (settings_.samples_per_pixel == 0 && settings_.pixel_rays != PixelRays::centre) {
            lost_.add("rays elsewhere than through the pixels' centres");
        }
        if (!settings_.display_colors) lost_.add("sRGB curve of a PNG");
    }

    /// Returns the directory relative to the file's own; a name with blanks would be two words.
    void write_skybox(const Skybox& skybox) {
        const auto folder = [](const std::filesystem::path& p) { return p.empty() ? "." : p; };
        const std::filesystem::path faces =
            folder(std::filesystem::path(skybox.faces[0]).parent_path());
        std::error_code unknown;
        const std::string name = proximate(faces, folder(directory_), unknown).string();
        const bool is_word = name.find_first_of(" \t\n\v\f\r#") == std::string::npos;
        if (is_word && !name.empty()) {
            out_.skybox(name);
        } else {
            lost_.add("skybox");
        }
        if (skybox.nearest) lost_.add("skybox's nearest texels, now blended");
    }

    void write_light(const PointLight& l) { out_.light(l.position, l.color); }

    void write_light(const QuadLight& l) {
        const ExactEndpoint end1 = exact_endpoint(l.corner, l.edge1),
                            end2 = exact_endpoint(l.corner, l.edge2);
        if (!end1.exact || !end2.exact) lost_.add("last bits of an area light's edges");
        out_.quad_light(l.corner, l.color, end1.point, end2.point, l.samples);
    }

    void write_shapes(const Geometry& geometry) {
        for (std::size_t i = 0; i < geometry.primitives.size();) i = write_primitives(geometry, i);
    }

    /// Writes a copy of its object for each instance. The formats that are written here have only
    /// translated instances.
    void write_instances() {
        const Geometry& geometry = scene_.geometry;
        for (const Instance& instance : geometry.instances) {
            const auto copy = moved(geometry.objects[instance.object], instance.origin);
            lost_.add(copy ? "instance, now a copy" : "instance that is not finite, left out");
            if (copy) write_shapes(*copy);
        }
    }

    /// Writes primitive `first` and those after it that go into the same statement. Returns the
    /// number of the next.
    std::size_t write_primitives(const Geometry& geometry, std::size_t first) {
        const Primitive p = geometry.primitives[first];
        use_material(p.material);
        if (p.sides == Sides::front) lost_.add("shape seen from its front only");
        if (is_flat_triangle(p)) {
            const MeshRun mesh = mesh_from(geometry, first);
            out_.mesh(mesh.vertices, mesh.faces);
            return first + mesh.faces.size();
        }
        if (p.kind == kind_of<Triangle>()) {
            write_smooth_triangle(geometry, geometry.get<Triangle>(p));
        } else {
            with_shape(p.kind,
                       [&]<class Shape>() { write_shape(geometry.get<Shape>(p), p.sides); });
        }
        return first + 1;
    }

    void use_material(std::uint32_t material) {
        if (material == material_) return;
        material_ = material;
        const P3fStatement s = to_p3f(scene_.whitted().materials[material], lost_);
        out_.material(s.numbers, s.absorbs);
    }

    /// A negative radius shows only the inside.
    static double signed_radius(double radius, Sides sides) {
        return sides == Sides::back ? -radius : radius;
    }

    void write_shape(const Sphere& s, Sides sides) {
        out_.sphere(s.centre, signed_radius(s.radius, sides));
    }

    void write_shape(const Cone& c, Sides sides) {
        out_.cone(c.base, signed_radius(c.base_radius, sides), c.top,
                  signed_radius(c.top_radius, sides));
    }

    void write_shape(const Box& b, Sides) { out_.box(b.min, b.max); }

    void write_shape(const Plane& p, Sides) {
        const auto [points, exact] = points_on(p);
        if (!exact) lost_.add("last bits of a plane");
        out_.plane(points[0], points[1], points[2]);
    }

    void write_shape(const Triangle&, Sides) {}  // written with the vertices of its geometry

    void write_smooth_triangle(const Geometry& geometry, const Triangle& t) {
        std::array<Vec3, 3> corners, normals;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = geometry.vertex(t.vertices[k]);
            normals[k] = geometry.normals[Geometry::normal_number(t, k)];
        }
        write_polygon(corners, normals);
    }

    void write_shape(const Polygon& p, Sides) { write_polygon(p.corners, p.normals); }

    void write_shape(const Ellipsoid& e, Sides) {
        lost_.add("ellipsoid, now polygons");
        write_facets(e);
    }

    void write_shape(const ClosedCylinder& c, Sides) {
        lost_.add("closed cylinder, now polygons");
        write_facets(c);
    }

    void write_shape(const Ring& r, Sides) {
        lost_.add("ring, now polygons");
        write_facets(r);
    }

    void write_shape(const Quadric&, Sides) { lost_.add("quadric, left out"); }

    void write_shape(const Revolved&, Sides) { lost_.add("surface of revolution, left out"); }

    void write_shape(const StoredCurve&, Sides) { lost_.add("curve, left out"); }

    void write_facets(const auto& shape) {
        to_facets(shape, [&](std::span<const Vec3> corners, std::span<const Vec3> normals) {
            write_polygon(corners, normals);
        });
    }

    void write_polygon(std::span<const Vec3> corners, std::span<const Vec3> normals) {
        if (normals.empty()) return out_.polygon(corners);
        if (std::ranges::find(normals, Vec3(0)) != normals.end()) {
            lost_.add("smooth polygon with a zero normal, now flat");
            return out_.polygon(corners);
        }
        if (!std::ranges::all_of(normals, is_of_unit_length)) lost_.add("length of corner normals");
        out_.patch(corners, normals);
    }

    bool is_flat_triangle(const Primitive& p) const {
        return p.kind == kind_of<Triangle>() && p.normal_offset == no_index;
    }

    const Scene& scene_;
    const RenderSettings& settings_;
    const std::filesystem::path& directory_;
    std::string text_;
    P3fWriter out_{[this](std::string_view piece) { text_ += piece; }};
    ConversionWarnings lost_;
    std::uint32_t material_ = no_index;
};

}  // namespace

WrittenScene write_p3f(const Scene& scene, const RenderSettings& settings,
                       const std::filesystem::path& directory) {
    return P3fScene(scene, settings, directory).write();
}

}  // namespace etalon
