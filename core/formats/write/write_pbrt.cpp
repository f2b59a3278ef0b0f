// Scenes of the Whitted-style formats as PBRT v3, with the physical look with which `path` renders
// them, so that the image is the same. Infinite planes and quadrics are lost.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/convert/physical_scene.h"
#include "core/formats/triangulation.h"
#include "core/formats/write/mesh_run.h"
#include "core/formats/write/pbrt_material.h"
#include "core/formats/write/pbrt_shapes.h"
#include "core/formats/write/text.h"
#include "core/formats/write/write.h"
#include "core/numerics/transforms.h"

namespace etalon {
namespace {

constexpr double radian = std::numbers::pi / 180;

class PbrtScene {
  public:
    /// `scene` is one of a physical look that make_physical() made.
    PbrtScene(const Scene& scene, const RenderSettings& settings, ConversionWarnings& lost)
        : scene_(scene), look_(scene.physical()), settings_(settings), lost_(lost) {}

    std::string write() {
        write_camera();
        write_sampling();
        out_.line("WorldBegin");
        write_materials();
        for (const PhysicalLight& light : look_.lights) write_light(light);
        write_objects();
        write_shapes(scene_.geometry);
        write_instances();
        out_.line("WorldEnd");
        out_.flush();
        return std::move(text_);
    }

  private:
    double distance_to_view_plane() const {
        const Vec3 view = scene_.camera.at - scene_.camera.eye;
        return std::sqrt(view.dot(view));
    }

    /// Writes the camera. PBRT's is left-handed, which the scale compensates; its field of view is
    /// that of the shorter side.
    void write_camera() {
        const Camera& c = scene_.camera;
        const double height = std::tan(c.fov_degrees / 2 * radian);  // halves, at distance 1
        const double width =
            c.stretched ? height : height * settings_.resolution.x / settings_.resolution.y;
        out_.line("Scale -1 1 1");
        out_.line("LookAt {}  {}  {}", c.eye, c.at, c.up);
        const std::string shape = c.stretched ? " \"float frameaspectratio\" [ 1 ]" : "";
        const double fov = width < height ? 2 * std::atan(width) / radian : c.fov_degrees;
        out_.line("Camera \"perspective\" \"float fov\" [ {} ]{}{}", fov, shape, lens(height));
    }

    /// Returns the lens as text; `height` is half of the image's, at distance 1.
    std::string lens(double height) const {
        const Camera& c = scene_.camera;
        if (c.aperture == 0) return {};
        const double distance = distance_to_view_plane();
        return fmt::format(" \"float lensradius\" [ {} ] \"float focaldistance\" [ {} ]",
                           c.aperture * height * distance / settings_.resolution.y,
                           c.focal * distance);
    }

    void write_sampling() {
        out_.line("Sampler \"halton\" \"integer pixelsamples\" [ {} ]",
                  settings_.samples_per_pixel);
        out_.line("PixelFilter \"box\"");
        out_.line("Film \"image\" \"integer xresolution\" [ {} ] \"integer yresolution\" [ {} ]",
                  settings_.resolution.x, settings_.resolution.y);
        out_.line("Integrator \"path\" \"integer maxdepth\" [ {} ]", settings_.max_depth - 1);
    }

    void write_materials() {
        for (std::uint32_t i = 0; i < look_.materials.size(); ++i) {
            out_.line("{}", to_pbrt(look_.materials, i));
        }
    }

    /// Writes a light that is not a shape.
    void write_light(const PhysicalLight& light) {
        if (const auto* point = std::get_if<PointSource>(&light)) {
            out_.line("LightSource \"point\" \"rgb I\" [ {} ] \"point from\" [ {} ]",
                      point->intensity, point->position);
        } else if (const auto* infinite = std::get_if<InfiniteSource>(&light)) {
            out_.line("LightSource \"infinite\" \"rgb L\" [ {} ]", infinite->radiance);
        }
    }

    /// Sets the material of what follows, if it changes.
    void use_material(std::uint32_t i) {
        if (i == material_) return;
        material_ = i;
        out_.line("NamedMaterial \"m{}\"", i);
    }

    void write_shapes(const Geometry& geometry) {
        for (std::size_t i = 0; i < geometry.primitives.size();) i = write_primitives(geometry, i);
    }

    /// Writes the objects of instances. A material that was set in an object is not valid after it.
    void write_objects() {
        for (std::size_t i = 0; i < scene_.geometry.objects.size(); ++i) {
            out_.line("ObjectBegin \"o{}\"", i);
            write_shapes(scene_.geometry.objects[i]);
            out_.line("ObjectEnd");
            material_ = no_index;
        }
    }

    void write_instances() {
        for (const Instance& instance : scene_.geometry.instances) {
            write_image(instance.to_world(), "ObjectInstance \"o{}\"", instance.object);
        }
    }

    std::size_t write_primitives(const Geometry& geometry, std::size_t first) {
        const Primitive p = geometry.primitives[first];
        const SurfaceBinding& binding = look_.bindings[p.material];
        use_material(binding.material);
        if (p.sides != Sides::both) lost_.add("shape of which one side is seen");
        if (p.kind == kind_of<Triangle>()) {
            const MeshRun mesh = mesh_from(geometry, first);
            const bool shines = binding.light != no_index;
            if (shines) write_area_light(std::get<AreaSource>(look_.lights[binding.light]));
            write_mesh(mesh.vertices, mesh.normals, mesh.faces);
            if (shines) out_.line("AttributeEnd");
            return first + mesh.faces.size();
        }
        with_shape(p.kind, [&]<class Shape>() { write_shape(geometry.get<Shape>(p)); });
        return first + 1;
    }

    /// Makes the shapes up to AttributeEnd a light.
    void write_area_light(const AreaSource& light) {
        out_.line(
            "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [ {} ] \"bool twosided\" "
            "\"true\"",
            light.radiance);
    }

    void write_mesh(std::span<const Vec3> vertices, std::span<const Vec3> normals,
                    std::span<const std::array<std::uint32_t, 3>> faces) {
        out_.line("Shape \"trianglemesh\" \"integer indices\" [");
        for (const auto& [a, b, c] : faces) out_.line("{} {} {}", a, b, c);
        out_.line("] \"point P\" [");
        for (const Vec3& v : vertices) out_.line("{}", v);
        if (!normals.empty()) out_.line("] \"normal N\" [");
        for (const Vec3& n : normals) out_.line("{}", n);
        out_.line("]");
    }

    /// Writes a shape about the origin with its transform. PBRT's matrices are column by column.
    template <class... T>
    void write_image(const Affine& m, fmt::format_string<T...> shape, T&&... values) {
        out_.line("TransformBegin\nTransform [ {} 0  {} 0  {} 0  {} 1 ]", m.x, m.y, m.z, m.origin);
        out_.line(shape, std::forward<T>(values)...);
        out_.line("TransformEnd");
    }

    void write_shape(const Triangle&) {}  // written with those that follow it, as a mesh

    void write_shape(const Sphere& s) {
        Affine place;
        place.origin = s.centre;
        write_image(place, "Shape \"sphere\" \"float radius\" [ {} ]", s.radius);
    }

    void write_shape(const Ellipsoid& e) {
        write_image(e.to_world, "Shape \"sphere\" \"float radius\" [ 1 ]");
    }

    void write_shape(const ClosedCylinder& c) {
        write_image(c.to_world,
                    "Shape \"cylinder\" \"float radius\" [ 1 ] \"float zmin\" [ 0 ] \"float zmax\" "
                    "[ 1 ]\nShape \"disk\" \"float height\" [ 0 ] \"float radius\" [ 1 ]\n"
                    "Shape \"disk\" \"float height\" [ 1 ] \"float radius\" [ 1 ]");
    }

    void write_shape(const Ring& r) {
        write_image(about_axis(r.centre, r.normal),
                    "Shape \"disk\" \"float radius\" [ {} ] \"float innerradius\" [ {} ]", r.outer,
                    r.inner);
    }

    void write_shape(const Quadric&) { lost_.add("quadric, left out"); }

    void write_shape(const Revolved& s) {
        if (const std::optional<PbrtShape> shape = to_pbrt(s)) {
            write_image(shape->to_world, "{}", shape->statement);
        } else {
            lost_.add("surface of revolution of no shape that PBRT has, left out");
        }
    }

    /// Writes a curve with the first of its parts.
    void write_shape(const StoredCurve& c) {
        if (c.part.number > 0) return;
        const PbrtShape shape = to_pbrt(c);
        write_image(shape.to_world, "{}", shape.statement);
    }

    void write_shape(const Cone& c) {
        const Vec3 axis = c.top - c.base;
        const double height = std::sqrt(axis.dot(axis));
        if (c.base_radius == c.top_radius) {
            write_image(about_axis(c.base, axis),
                        "Shape \"cylinder\" \"float radius\" [ {} ] \"float zmin\" [ 0 ] \"float "
                        "zmax\" [ {} ]",
                        c.base_radius, height);
        } else if (c.top_radius == 0) {
            write_image(about_axis(c.base, axis),
                        "Shape \"cone\" \"float radius\" [ {} ] \"float height\" [ {} ]",
                        c.base_radius, height);
        } else if (c.base_radius == 0) {
            write_shape(Cone{c.top, c.base, c.top_radius, 0});
        } else {
            write_image(about_axis(c.base, axis),
                        "Shape \"hyperboloid\" \"point p1\" [ {} 0 0 ] \"point p2\" [ {} 0 {} ]",
                        c.base_radius, c.top_radius, height);
        }
    }

    void write_shape(const Box& b) {
        std::vector<Vec3> corners;
        corners.reserve(8);
        for (int i = 0; i < 8; ++i) {
            corners.emplace_back((i & 1) != 0 ? b.max.x : b.min.x, (i & 2) != 0 ? b.max.y : b.min.y,
                                 (i & 4) != 0 ? b.max.z : b.min.z);
        }
        static constexpr std::array<std::array<std::uint32_t, 3>, 12> faces = {{{0, 2, 3},
                                                                                {0, 3, 1},
                                                                                {4, 5, 7},
                                                                                {4, 7, 6},
                                                                                {0, 1, 5},
                                                                                {0, 5, 4},
                                                                                {2, 6, 7},
                                                                                {2, 7, 3},
                                                                                {0, 4, 6},
                                                                                {0, 6, 2},
                                                                                {1, 3, 7},
                                                                                {1, 7, 5}}};
        write_mesh(corners, {}, faces);
    }

    void write_shape(const Polygon& p) { write_mesh(p.corners, p.normals, triangulate(p.corners)); }

    /// Writes a square instead of an infinite plane, which PBRT lacks: about the point nearest to
    /// the eye, and as large as a thousand times all distances of the camera.
    void write_shape(const Plane& p) {
        lost_.add("infinite plane, now a large square");
        const Vec3 normal = normalized(p.normal);
        const double away = normal.dot(scene_.camera.eye - p.point);
        const double side = 1000 * (distance_to_view_plane() + std::abs(away));
        Affine map;
        orthonormal_basis(normal, map.x, map.y);
        const Vec3 centre = scene_.camera.eye - away * normal, x = side * map.x, y = side * map.y;
        const std::array corners = {centre - x - y, centre + x - y, centre + x + y, centre - x + y};
        static constexpr std::array<std::array<std::uint32_t, 3>, 2> faces = {
            {{0, 1, 2}, {0, 2, 3}}};
        write_mesh(corners, {}, faces);
    }

    const Scene& scene_;
    const PhysicalLook& look_;
    const RenderSettings& settings_;
    ConversionWarnings& lost_;
    std::string text_;
    LineWriter out_{[this](std::string_view piece) { text_ += piece; }};
    std::uint32_t material_ = no_index;
};

/// Warns of properties of the look that path tracing renders differently from the format.
void warn_of_losses(const WhittedLook& look, ConversionWarnings& lost) {
    if (look.environment.skybox) {
        lost.add("skybox, now one colour");
    } else if (look.environment.background != Color(0.0F)) {
        lost.add("background that lights nothing, now one that does");
    }
    for (const Light& light : look.lights) {
        lost.add(std::holds_alternative<PointLight>(light)
                     ? "light that does not fall off, now one that does"
                     : "area light that is not seen, now one that is, and falls off");
    }
    for (const Material& material : look.materials) warn_of_losses(material, lost);
}

}  // namespace

WrittenScene write_pbrt(const Scene& scene, const RenderSettings& settings,
                        const std::filesystem::path&) {
    ConversionWarnings lost;
    warn_of_losses(scene.whitted(), lost);
    Scene physical = scene;
    RenderSettings physical_settings = settings;
    make_physical(physical, physical_settings);
    std::string text = PbrtScene(physical, physical_settings, lost).write();
    return {std::move(text), "PBRT", lost.take()};
}

}  // namespace etalon
