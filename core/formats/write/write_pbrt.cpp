// Scenes of the Whitted-style formats as PBRT v3, with the physical look with which `path` renders
// them, so that the image is the same. Infinite planes and quadrics are lost.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/convert/physical_scene.h"
#include "core/formats/write/mesh_run.h"
#include "core/formats/write/pbrt_material.h"
#include "core/formats/write/pbrt_shape_writer.h"
#include "core/formats/write/text.h"
#include "core/formats/write/write.h"
#include "core/scene/transformed.h"

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
        const double distance = distance_to_view_plane(c);
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
            shapes_.placed(instance.to_world(),
                           fmt::format("ObjectInstance \"o{}\"", instance.object));
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
            shapes_.mesh(mesh.vertices, mesh.normals, mesh.faces);
            if (shines) out_.line("AttributeEnd");
            return first + mesh.faces.size();
        }
        shapes_.primitive(geometry, p);
        return first + 1;
    }

    /// Makes the shapes up to AttributeEnd a light.
    void write_area_light(const AreaSource& light) {
        out_.line(
            "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [ {} ] \"bool twosided\" "
            "\"true\"",
            light.radiance);
    }

    const Scene& scene_;
    const PhysicalLook& look_;
    const RenderSettings& settings_;
    ConversionWarnings& lost_;
    std::string text_;
    LineWriter out_{[this](std::string_view piece) { text_ += piece; }};
    PbrtShapeWriter shapes_{out_, lost_, scene_.camera};
    std::uint32_t material_ = no_index;
};

/// Returns the scene, moved so that the eye is the origin if it is so far from there that the
/// rounding of coordinates to PBRT's floats would show in the image.
Scene near_origin(Scene scene) {
    const Vec3 eye = scene.camera.eye;
    if (max_abs(eye) <= 0x1p10 * distance_to_view_plane(scene.camera)) return scene;
    return transformed(std::move(scene), 1, -eye);
}

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
    physical = near_origin(std::move(physical));
    std::string text = PbrtScene(physical, physical_settings, lost).write();
    return {std::move(text), "PBRT", lost.take()};
}

}  // namespace etalon
