#include "core/integrators/path/wave_points.h"

#include "core/sampling/dimensions.h"

namespace etalon {

void WavePoints::clear() {
    light_choices_.clear();
    directions_.clear();
    light_points_.clear();
}

void WavePoints::add(const PathState& path) {
    const std::uint32_t count = scene_.split_count(path);
    for (std::uint32_t i = 0; i < count; ++i) {
        path.source.part(i, count).add_vertex(path.name, directions_);
    }
    if (scene_.samples_all) {
        add_light_points(path);
    } else {
        path.source.add_vertex(path.name, light_choices_);
    }
}

void WavePoints::make() {
    light_choices_.make(scene_.sampler);
    directions_.make(scene_.sampler);
    on_lights_ = light_points_.make(scene_.sampler);
}

void WavePoints::add_light_points(const PathState& path) {
    for (std::uint32_t light = 0; light < scene_.lights.size(); ++light) {
        const auto samples = static_cast<std::uint32_t>(scene_.lights.samples(light));
        const std::uint32_t dimension = light_dimension(path.name, light);
        for (std::uint32_t k = 0; k < samples; ++k) {
            path.source.add_stratified(dimension, k, samples, light_points_);
        }
    }
}

}  // namespace etalon
