#include <fmt/format.h>

#include <filesystem>

#include "bench/report/commands.h"
#include "bench/report/measure/rendered.h"
#include "core/formats/load.h"
#include "core/image/encode.h"
#include "core/image/oiio.h"

namespace etalon::bench_report {
namespace {

namespace fs = std::filesystem;

/// The project's folder of scenes: here, or where the program was built from.
fs::path scenes_folder() {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
    for (const fs::path& root : {fs::path("."), program.parent_path().parent_path()}) {
        if (fs::exists(root / "scenes" / "showcase.p3f", none)) return root / "scenes";
    }
    return "scenes";
}

Outcome<std::string> png_of(const Scene& scene, const Film& film) {
    const Picture picture{scene.camera.width, scene.camera.height,  film.window(),
                          film.pixels(),      scene.display_colors, {}};
    return encode_png(display_bytes(picture, 0), picture.width, picture.height);
}

void complain(const std::string& what) {
    fmt::print(stderr, "etalon-bench: warning: {}\n", what);
}

void measure(const PictureRequest& request, Results& results, const Context& context) {
    LoadResult loaded = load_scene((scenes_folder() / request.scene).string());
    if (!loaded.scene) return fmt::print(stderr, "{}", report(loaded.diagnostics));
    Scene& scene = *loaded.scene;
    scene.camera.width = request.width;
    scene.camera.height = request.height;
    scene.samples_per_pixel = request.samples;
    const Rendered r = rendered(scene, "bvh", context);
    if (!r.rendering.complete) return;
    const Outcome<std::string> png = png_of(scene, r.rendering.film);
    if (!png) return complain(png.error);
    results.pictures.add({request.scene,
                          picture_command(request),
                          request.width,
                          request.height,
                          scene.primitives.size(),
                          request.samples,
                          r.render,
                          {{request.scene, png.value}}});
}

}  // namespace

std::vector<Task> picture_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const PictureRequest& request : settings.pictures) {
        const double samples = 1.0 * request.width * request.height * request.samples;
        tasks.push_back({request.scene, 0.1 + samples * 3e-6,
                         [request](Results& results, const Context& context) {
                             measure(request, results, context);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
