#include "core/formats/pbrt/frame.h"

namespace etalon::pbrt {

Frame::Frame()
    : camera(plugin_types(Category::camera).front()),
      sampler(plugin_types(Category::sampler).front()),
      film(plugin_types(Category::film).front()),
      filter(plugin_types(Category::filter).front()),
      integrator(plugin_types(Category::integrator).front()),
      accelerator(plugin_types(Category::accelerator).front()) {}

}  // namespace etalon::pbrt
