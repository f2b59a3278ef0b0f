// Images of scenes in memory.
#pragma once

#include "app/common/backends.h"
#include "core/integrators/integrators.h"
#include "core/render/renderer.h"
#include "tests/catch.h"
#include "tests/render/test_scenes.h"

namespace etalon::test {

inline Rendering render_with(const Scene& scene, const Backend& backend,
                             const RenderSettings& settings, const RunControl& control = {}) {
    const auto intersector = backend.build(scene.geometry);
    std::vector<std::string> problems;
    const auto integrator =
        find_integrator(settings.integrator)->make(scene, *intersector, settings, problems);
    return render(scene.camera, *integrator, settings, control);
}

inline Rendering rendered(TestScene scene, std::string_view backend = default_backend) {
    find_integrator(scene.settings.integrator)->prepare_scene(scene, scene.settings);
    return render_with(scene, *find_backend(backend), scene.settings);
}

inline std::vector<Color> image(const TestScene& scene,
                                std::string_view backend = default_backend) {
    return rendered(scene, backend).film.pixels();
}

/// Returns the colour in the middle of a one-pixel image.
inline Color centre(TestScene scene, int max_depth = 5) {
    scene.settings.resolution = {1, 1};
    scene.settings.max_depth = max_depth;
    return image(scene, reference_backend)[0];
}

/// Checks that two renderings are the same to the last bit.
inline void check_same(const Rendering& a, const Rendering& b) {
    CHECK(a.film.pixels() == b.film.pixels());
    CHECK(a.film.counts() == b.film.counts());
    CHECK(a.film.variances() == b.film.variances());
    CHECK(a.counts == b.counts);
    CHECK(a.samples == b.samples);
    CHECK(a.expected_error == b.expected_error);
}

}  // namespace etalon::test
