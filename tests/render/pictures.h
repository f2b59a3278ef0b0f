// Pictures of scenes in memory.
#pragma once

#include "app/backends.h"
#include "core/render/renderer.h"
#include "core/scene/scene.h"

namespace etalon::test {

inline Rendering render_with(const Scene& scene, const Backend& backend, RenderOptions options) {
    std::vector<std::string> problems;
    const EnvironmentMap environment(scene.look.environment, problems);
    const auto intersector = backend.build(scene.geometry);
    return render(scene, *intersector, environment, options);
}

inline RenderOptions whole(const Scene& scene) {
    RenderOptions options;
    options.samples_per_pixel = scene.samples_per_pixel;
    options.window = {{0, 0}, {scene.camera.width - 1, scene.camera.height - 1}};
    return options;
}

inline std::vector<Color> picture(const Scene& scene, const std::string& backend = "bvh") {
    return render_with(scene, *find_backend(backend), whole(scene)).film.pixels();
}

/// What the middle of a one-pixel picture sees.
inline Color centre(Scene scene, int max_depth = 5) {
    scene.camera.width = scene.camera.height = 1;
    RenderOptions options = whole(scene);
    options.max_depth = max_depth;
    return render_with(scene, *find_backend("none"), options).film.pixels()[0];
}

}  // namespace etalon::test
