// Cameras of pbrt-v3 and their parameters.
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr ParameterSpec shutter_open = number("shutteropen", 0),
                        shutter_close = number("shutterclose", 1);
constexpr ParameterSpec frame_aspect = number("frameaspectratio");  // of the film
constexpr ParameterSpec screen_window = four("screenwindow", ValueType::number);
constexpr ParameterSpec lens_radius = number("lensradius", 0);
constexpr ParameterSpec focal_distance = number("focaldistance", 1e6F);

constexpr std::array perspective = {shutter_open,      shutter_close,        lens_radius,
                                    focal_distance,    frame_aspect,         screen_window,
                                    number("fov", 90), number("halffov", -1)};
constexpr std::array orthographic = {shutter_open,   shutter_close, lens_radius,
                                     focal_distance, frame_aspect,  screen_window};
constexpr std::array environment = {shutter_open, shutter_close,
                                    lens_radius,  number("focaldistance", 1e30F),
                                    frame_aspect, screen_window};
constexpr std::array realistic = {shutter_open,
                                  shutter_close,
                                  file("lensfile"),
                                  number("aperturediameter", 1),
                                  number("focusdistance", 10),
                                  flag("simpleweighting", true)};

constexpr std::array types = {
    PluginType{Category::camera, "perspective", perspective},
    PluginType{Category::camera, "orthographic", orthographic},
    PluginType{Category::camera, "environment", environment},
    PluginType{Category::camera, "realistic", realistic},
};

}  // namespace

std::span<const PluginType> camera_types() {
    return types;
}

}  // namespace etalon::pbrt
