// Scenes as PBRT v3. Its lights are of another kind than ours, so that the image is another one;
// shapes and the camera are the same.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/formats/triangulation.h"
#include "core/formats/write/mesh_run.h"
#include "core/formats/write/pbrt_material.h"
#include "core/formats/write/text.h"
#include "core/formats/write/write.h"
#include "core/numerics/transforms.h"

namespace etalon {
namespace {

constexpr double radian = std::numbers::pi / 180;

class PbrtScene {
  public:
    PbrtScene(const Scene& scene, const RenderSettings& settings)
        : scene_(scene), settings_(settings) {}

    WrittenScene write() {
        write_camera();
        write_sampling();
        out_.line("WorldBegin");
        write_environment();
        for (const Light& light : scene_.whitted().lights) {
            std::visit([&](const auto& l) { write_light(l); }, light);
        }
        for (std::size_t i = 0; i < scene_.geometry.primitives.size();) i = write_primitives(i);
        out_.line("WorldEnd");
        out_.flush();
        return {std::move(text_), "PBRT", lost_.take()};
    }

  private:
    double distance_to_view_plane() const {
        const Vec3 view = scene_.camera.at - scene_.camera.eye;
        return std::sqrt(view.dot(view));
    }

    /// Writes the camera. PBRT's is left-handed, which the scale undoes; its field of view is that
    /// of the shorter side.
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
        if (c.aperture == 0 || settings_.samples_per_pixel == 0) return {};
        const double distance = distance_to_view_plane();
        return fmt::format(" \"float lensradius\" [ {} ] \"float focaldistance\" [ {} ]",
                           c.aperture * height * distance / settings_.resolution.y,
                           c.focal * distance);
    }

    void write_sampling() {
        const int samples = settings_.samples_per_pixel;
        out_.line("Sampler \"halton\" \"integer pixelsamples\" [ {} ]{}", std::max(samples, 1),
                  samples == 0 ? " \"bool samplepixelcenter\" \"true\"" : "");
        out_.line("PixelFilter \"box\"");
        out_.line("Film \"image\" \"integer xresolution\" [ {} ] \"integer yresolution\" [ {} ]",
                  settings_.resolution.x, settings_.resolution.y);
        out_.line("Integrator \"whitted\" \"integer maxdepth\" [ {} ]", settings_.max_depth);
    }

    void write_environment() {
        if (scene_.whitted().environment.skybox) lost_.add("skybox, now one colour");
        const Color& background = scene_.whitted().environment.background;
        if (background == Color(0.0F)) return;
        lost_.add("background that lights nothing, now one that does");
        out_.line("LightSource \"infinite\" \"rgb L\" [ {} ]", background);
    }

    /// Intensity that makes up, at the point looked at, for PBRT's fall-off with the square of the
    /// distance and for diffuse surfaces that send back 1 / pi of the light into every direction.
    float intensity_at(const Vec3& position) const {
        const Vec3 way = scene_.camera.at - position;
        return static_cast<float>(std::numbers::pi * way.dot(way));
    }

    void write_light(const PointLight& l) {
        lost_.add("light that does not fall off, now one that does");
        out_.line("LightSource \"point\" \"rgb I\" [ {} ] \"point from\" [ {} ]",
                  l.color * intensity_at(l.position), l.position);
    }

    void write_light(const QuadLight& l) {
        const Vec3 normal = l.edge1.cross(l.edge2);
        const auto area = static_cast<float>(std::sqrt(normal.dot(normal)));
        const Vec3 centre = l.corner + (l.edge1 + l.edge2) / 2;
        if (!(area > 0)) return write_light(PointLight{centre, l.color});
        lost_.add("area light that is not seen, now one that is, and falls off");
        out_.line(
            "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [ {} ] \"bool twosided\" "
            "\"true\"",
            l.color * (intensity_at(centre) / area));
        out_.line(
            "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] \"point P\" [ {}  {}  "
            "{}  {} ]\nAttributeEnd",
            l.corner, l.corner + l.edge1, l.corner + l.edge1 + l.edge2, l.corner + l.edge2);
    }

    /// Uses a material, and writes it at its first use.
    void use_material(std::uint32_t i) {
        if (i == material_) return;
        material_ = i;
        const std::string name = fmt::format("m{}", i);
        if (!known_[i]) out_.line("{}", to_pbrt(scene_.whitted().materials[i], name, lost_));
        known_[i] = true;
        out_.line("NamedMaterial \"{}\"", name);
    }

    std::size_t write_primitives(std::size_t first) {
        const Primitive p = scene_.geometry.primitives[first];
        use_material(p.material);
        if (p.sides != Sides::both) lost_.add("shape of which one side is seen");
        if (p.kind == kind_of<Triangle>()) {
            const MeshRun mesh = mesh_from(scene_, first);
            write_mesh(mesh.vertices, mesh.normals, mesh.faces);
            return first + mesh.faces.size();
        }
        with_shape(p.kind, [&]<class Shape>() { write_shape(scene_.geometry.get<Shape>(p)); });
        return first + 1;
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

    /// A shape about the origin, carried to its place. PBRT has matrices column by column.
    template <class... T>
    void write_image(const Affine& m, fmt::format_string<T...> shape, T&&... values) {
        out_.line("TransformBegin\nTransform [ {} 0  {} 0  {} 0  {} 1 ]", m.x, m.y, m.z, m.origin);
        out_.line(shape, std::forward<T>(values)...);
        out_.line("TransformEnd");
    }

    void write_shape(const Triangle&) {}  // with those that follow it, as a mesh

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

    /// Writes a square for the infinite plane that PBRT lacks: about its point nearest to the eye,
    /// as large as a thousand times all distances that the camera knows.
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
    const RenderSettings& settings_;
    std::string text_;
    LineWriter out_{[this](std::string_view piece) { text_ += piece; }};
    ConversionWarnings lost_;
    std::uint32_t material_ = no_index;
    std::vector<bool> known_ = std::vector<bool>(scene_.whitted().materials.size());
};

}  // namespace

WrittenScene write_pbrt(const Scene& scene, const RenderSettings& settings,
                        const std::filesystem::path&) {
    return PbrtScene(scene, settings).write();
}

}  // namespace etalon
