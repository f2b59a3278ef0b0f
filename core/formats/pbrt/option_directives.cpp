// Statements of the options block: one plugin each.
#include "core/formats/pbrt/parser.h"

namespace etalon::pbrt {
namespace {

using Grade = Unknown::Grade;

/// Reads a plugin with its parameters into an option. The default replaces an unknown one.
void read_option(Parser& p, Category category, Plugin& option, Grade grade) {
    const std::string name = p.in.string("a type");
    ParameterList list = p.in.parameters();
    if (!p.in.ok()) return;
    const PluginType& standard = plugin_types(category).front();
    const std::string instead = fmt::format("'{}' stands in for it", standard.name);
    const PluginType* const type = p.find_type(category, name, {grade, instead});
    std::optional<Plugin> plugin = type ? p.make_plugin(*type, list) : std::nullopt;
    option = plugin ? std::move(*plugin) : Plugin(standard, {}, p.in.where());
}

/// Uses the current transformation as that from the world to the camera.
void place_camera(Parser& p) {
    const TransformState& current = *p.now.transform.current;
    auto& cameras = p.frame().camera_transforms;
    cameras = {CameraTransform{{}, current.start()}, CameraTransform{{}, current.end()}};
    for (CameraTransform& camera : cameras) {
        if (const auto to_world = inverse(camera.from_world)) {
            camera.to_world = *to_world;
        } else {
            p.log.error(p.in.where(), "degenerate",
                        "the current transformation has no inverse; "
                        "the camera is where it would be without");
            camera = {};
        }
    }
    p.now.coordinate_systems["camera"] =
        std::make_shared<TransformState>(cameras[0].to_world, cameras[1].to_world);
}

void read_camera(Parser& p) {
    read_option(p, Category::camera, p.frame().camera, Grade::error);
    if (p.in.ok()) place_camera(p);
}

void read_sampler(Parser& p) {
    read_option(p, Category::sampler, p.frame().sampler, Grade::error);
}

void read_film(Parser& p) {
    read_option(p, Category::film, p.frame().film, Grade::error);
}

void read_pixel_filter(Parser& p) {
    read_option(p, Category::filter, p.frame().filter, Grade::fatal);
}

void read_integrator(Parser& p) {
    read_option(p, Category::integrator, p.frame().integrator, Grade::error);
}

void read_accelerator(Parser& p) {
    read_option(p, Category::accelerator, p.frame().accelerator, Grade::warning);
}

constexpr auto in_options = Directive::Allowed::in_options;

constexpr std::array directives = {
    Directive{"Camera", in_options, read_camera},
    Directive{"Sampler", in_options, read_sampler},
    Directive{"Film", in_options, read_film},
    Directive{"PixelFilter", in_options, read_pixel_filter},
    Directive{"Integrator", in_options, read_integrator},
    Directive{"Accelerator", in_options, read_accelerator},
};

}  // namespace

std::span<const Directive> option_directives() {
    return directives;
}

}  // namespace etalon::pbrt
