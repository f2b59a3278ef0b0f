// etalon compare: the difference of two images, in numbers and as a map.
#include <fmt/format.h>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/memory_limit.h"
#include "app/common/output.h"
#include "app/compare/image_pair.h"
#include "app/compare/limit.h"
#include "app/subcommands.h"
#include "core/image/atomic_file.h"
#include "core/image/metrics/magma.h"
#include "core/image/metrics/measure_metrics.h"
#include "core/image/png.h"
#include "core/numerics/pixel_window.h"

namespace etalon::compare {
namespace {

struct Arguments {
    std::string a, b, json, heatmap;
    std::vector<std::string> limits;
};

/// Warns of pixels that are not finite: displays cannot show them, and metrics do not count those
/// that both images have.
void warn_of_unbounded(const std::string& path, Pixels pixels) {
    const std::uint64_t count = unbounded_pixels(pixels);
    if (count == 0) return;
    print_message("{}: warning: {} pixels are NaN or infinite\n", path, count);
}

/// Returns why the map could not be written; empty if it was.
std::string write_heatmap(const std::string& path, const PixelPlane& map) {
    const Result<std::string> file = encode_png(magma(map), map.width, map.height);
    return file ? write_file_atomically(path, file.value) : path + ": " + file.error;
}

void note_window(const Imath::Box2i& window) {
    const Imath::V2i size = window_size(window);
    print_message("etalon: note: compared are the {} x {} pixels at {},{}, which both show\n",
                  size.x, size.y, window.min.x, window.min.y);
}

nlohmann::ordered_json json_of(const ImagePair& images, const Metrics& metrics) {
    nlohmann::ordered_json json = as_json(metrics);
    if (images.window) {
        const auto& [min, max] = *images.window;
        json["window"] = {min.x, min.y, max.x + 1, max.y + 1};
    }
    return json;
}

int write(const Arguments& a, const ImagePair& images, const Metrics& metrics,
          const PixelPlane& map) {
    write_table(a.json, as_text(metrics));
    if (!a.json.empty() && !write_json(a.json, json_of(images, metrics))) return exit_not_written;
    const std::string error = a.heatmap.empty() ? "" : write_heatmap(a.heatmap, map);
    return error.empty() ? exit_done : fail(exit_not_written, error);
}

int check_limits(const Arguments& a, const Metrics& metrics) {
    int status = exit_done;
    for (const std::string& text : a.limits) {
        const std::string worse = violation(parse_limit(text).value, metrics);
        if (!worse.empty()) status = fail(exit_differs, worse);
    }
    return status;
}

int run(const Arguments& a) {
    limit_memory(0);
    if (const auto [error, status] = check_outputs({a.json, a.heatmap}, {a.a, a.b}); !error.empty())
        return fail(status, error);
    const Result<ImagePair> images = read_image_pair(a.a, a.b);
    if (!images) return fail(exit_unusable, images.error);
    if (images.value.window) note_window(*images.value.window);
    const auto& [first, second] = images.value.pixels;
    warn_of_unbounded(a.a, first);
    warn_of_unbounded(a.b, second);
    const auto [metrics, map] =
        measure(first, second, images.value.width, images.value.has_display_values);
    const int status = write(a, images.value, metrics, map);
    return status == exit_done ? check_limits(a, metrics) : status;
}

}  // namespace
}  // namespace etalon::compare

namespace etalon {

Action declare_compare(Options& options) {
    auto a = std::make_shared<compare::Arguments>();
    options.add("A", a->a, "Image file; EXR, PFM and HDR are linear, PNG and JPEG sRGB").required();
    options.add("B", a->b, "Image file: the reference").required();
    options.add("--json", a->json, "Write the metrics to this JSON file; - is standard output")
        .value("FILE");
    options
        .add("--heatmap", a->heatmap, "Write the map of FLIP to FILE.png, black where A equals B")
        .value("FILE")
        .check([](const std::string& path) {
            return path.ends_with(".png") ? "" : path + ": expected a name ending in .png";
        });
    options
        .add("--fail-above", a->limits,
             "Exit with status 1 if the metric is larger, for psnr and ssim smaller; may be "
             "repeated. Metrics: " +
                 compare::metric_names())
        .value("METRIC=VALUE")
        .check([](const std::string& text) { return compare::parse_limit(text).error; })
        .one_value_each();
    return [a] { return compare::run(*a); };
}

}  // namespace etalon
