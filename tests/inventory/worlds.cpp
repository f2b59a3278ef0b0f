#include "tests/inventory/worlds.h"

#include <array>

namespace etalon::test {
namespace {

using pbrt::Category;

/// The file's contents unless replaced by the plugin; all but the world are single directives.
struct World {
    std::string camera = "Camera \"perspective\" \"float fov\" 50";
    std::string sampler = "Sampler \"sobol\" \"integer pixelsamples\" 4";
    std::string film = "Film \"image\" \"integer xresolution\" 24 \"integer yresolution\" 18";
    std::string filter = "PixelFilter \"box\"";
    std::string integrator = "Integrator \"path\" \"integer maxdepth\" 5";
    std::string accelerator = "Accelerator \"bvh\"";
    std::string lights =
        "LightSource \"infinite\" \"rgb L\" [.3 .35 .4]\n"
        "LightSource \"distant\" \"rgb L\" [1.5 1.4 1.2] \"point from\" [-2 3 -2]\n"
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [6 5 4] Translate 1 3 -1\n"
        "Rotate 90 1 0 0 Shape \"disk\" \"float radius\" .5 AttributeEnd\n";
    std::string subject =
        "AttributeBegin Translate -.8 0 0 Material \"mirror\" Shape \"sphere\" AttributeEnd\n"
        "ActiveTransform EndTime Translate .4 0 0 ActiveTransform All\n"
        "AttributeBegin Translate .9 .3 -1 Material \"glass\" Shape \"sphere\" \"float radius\" "
        ".5\n"
        "AttributeEnd\n";
};

constexpr std::string_view floor =
    "AttributeBegin Material \"matte\" \"texture Kd\" \"squares\" Translate 0 -1 0\n"
    "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"float uv\" [0 0 1 0 1 1 0 1]\n"
    "\"point P\" [-4 0 -4  4 0 -4  4 0 4  -4 0 4] AttributeEnd\n";

constexpr std::string_view named =
    "Texture \"squares\" \"spectrum\" \"checkerboard\" \"float uscale\" 8 \"float vscale\" 8\n"
    "\"rgb tex1\" [.7 .6 .5] \"rgb tex2\" [.3 .3 .4]\n"
    "Texture \"waves\" \"float\" \"fbm\"\n"
    "MakeNamedMaterial \"red\" \"string type\" \"matte\" \"rgb Kd\" [.7 .1 .1]\n"
    "MakeNamedMaterial \"green\" \"string type\" \"mirror\" \"rgb Kr\" [.1 .7 .1]\n"
    "MakeNamedMaterial \"blue\" \"string type\" \"matte\" \"rgb Kd\" [.1 .1 .7]\n";

std::string directive(std::string_view word, std::string_view name, const std::string& parameters) {
    return std::string(word) + " \"" + std::string(name) + "\" " + parameters + "\n";
}

/// A ball and a strand of hair of a material.
std::string with_material(const std::string& material) {
    return "AttributeBegin\n" + material +
           "AttributeBegin Translate -.6 0 0 Rotate -60 1 0 0 Shape \"sphere\" AttributeEnd\n"
           "Translate 1 0 -1 Shape \"curve\" \"string type\" \"cylinder\" \"float width\" .5\n"
           "\"point P\" [-.3 -1 0  .4 -.4 .2  -.4 .4 -.2  .3 1 0] AttributeEnd\n";
}

/// A square and a ball of a material with a texture that changes along them and between them.
std::string with_texture(const std::string& texture, std::string_view shown) {
    return "TransformBegin Scale 1.1 1.2 1.3\n" + texture + "TransformEnd\n" + std::string(shown) +
           "Material \"matte\" \"texture Kd\" \"shown\"\n"
           "AttributeBegin Translate -.9 0 0 Rotate 70 1 1 0 Shape \"sphere\" AttributeEnd\n"
           "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"float uv\" [0 0 1 0 1 1 0 "
           "1]\n"
           "\"point P\" [.2 -1 -.5  2 -.9 .5  2 1 .7  .2 1 -.3]\n";
}

constexpr std::string_view show_number =
    "Texture \"shown\" \"spectrum\" \"mix\" \"texture amount\" \"t\" \"rgb tex1\" [.1 .2 .7]\n"
    "\"rgb tex2\" [.8 .6 .1]\n";
constexpr std::string_view show_color =
    "Texture \"shown\" \"spectrum\" \"scale\" \"texture tex1\" \"t\" \"rgb tex2\" [.8 .8 .7]\n";

/// A light above the floor and a ball, directed at them.
std::string with_light(const std::string& light) {
    return "AttributeBegin Translate .3 2.5 -.4 Rotate 80 1 0 .1\n" + light + "AttributeEnd\n";
}

std::string with_area_light(const std::string& light) {
    return "AttributeBegin Translate 1 .5 -1 Rotate 75 0 1 .3\n" + light +
           "Shape \"disk\" \"float radius\" .5 AttributeEnd\n";
}

std::string with_shape(const std::string& shape) {
    return "AttributeBegin Texture \"places\" \"spectrum\" \"uv\"\n"
           "Material \"matte\" \"texture Kd\" \"places\" Rotate -60 1 .2 .1\n" +
           shape + "AttributeEnd\n";
}

std::string with_medium(std::string_view name, const std::string& parameters) {
    return directive("MakeNamedMedium", "m",
                     "\"string type\" \"" + std::string(name) + "\" " + parameters) +
           "AttributeBegin MediumInterface \"m\" \"\" Material \"\" Shape \"sphere\" \"float "
           "radius\" .9\n"
           "AttributeEnd\n";
}

constexpr std::string_view ball =
    "AttributeBegin Material \"matte\" Translate -.7 -.3 0 Shape \"sphere\" \"float radius\" .7\n"
    "AttributeEnd\n";

World world_of(const pbrt::PluginType& plugin, const std::string& parameters) {
    const auto as = [&](std::string_view word) { return directive(word, plugin.name, parameters); };
    World w;
    switch (plugin.category) {
        case Category::camera:
            w.camera = as("Camera");
            break;
        case Category::sampler:
            w.sampler = as("Sampler");
            break;
        case Category::film:
            w.film = as("Film");
            w.camera =
                "Scale -1 1 1 Camera \"realistic\" \"string lensfile\" \"lens.dat\" \"float "
                "focusdistance\" 4";
            break;
        case Category::filter:
            w.filter = as("PixelFilter");
            break;
        case Category::integrator:
            w.integrator = as("Integrator");
            break;
        case Category::accelerator:
            w.accelerator = as("Accelerator");
            break;
        case Category::shape:
            w.subject = with_shape(as("Shape"));
            break;
        case Category::material:
            w.subject = with_material(as("Material"));
            break;
        case Category::float_texture:
            w.subject = with_texture(as("Texture \"t\" \"float\""), show_number);
            break;
        case Category::spectrum_texture:
            w.subject = with_texture(as("Texture \"t\" \"spectrum\""), show_color);
            break;
        case Category::light:
            w.integrator = "Integrator \"directlighting\"";
            w.lights = with_light(as("LightSource"));
            w.subject = ball;
            break;
        case Category::area_light:
            w.integrator = "Integrator \"directlighting\"";
            w.lights = with_area_light(as("AreaLightSource"));
            w.subject = ball;
            break;
        case Category::medium:
            w.integrator = "Integrator \"volpath\" \"integer maxdepth\" 5";
            w.subject = with_medium(plugin.name, parameters);
            break;
    }
    return w;
}

}  // namespace

std::string world_with(const pbrt::PluginType& plugin, const std::string& parameters,
                       const std::string& textures) {
    const World w = world_of(plugin, parameters);
    std::string text = "LookAt 0 1 -4.5  0 0 0  0 1 0\n";
    for (const std::string* option :
         {&w.camera, &w.sampler, &w.film, &w.filter, &w.integrator, &w.accelerator}) {
        text += *option + "\n";
    }
    return text + "WorldBegin\n" + std::string(named) + textures + w.lights + std::string(floor) +
           w.subject + "WorldEnd\n";
}

}  // namespace etalon::test
