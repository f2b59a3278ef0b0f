#include "core/formats/p3f/p3f.h"

#include "core/formats/nearest_name.h"
#include "core/formats/p3f/keywords.h"

namespace etalon {
namespace {

using p3f::Loader;

/// One warning for what stands where a keyword should, however long it goes on.
void complain(Loader& loader, std::string_view before) {
    Reader& in = loader.in;
    const bool number = in.tokens().at_number();
    const std::string_view word = in.begin();
    const std::size_t more = p3f::skip_to_keyword(in);
    const std::string end = more == 0 ? "" : fmt::format(" (words skipped: {})", more + 1);
    if (number && !before.empty()) {
        in.warn("stray", "expected a keyword after '{}', found {}{}", before, in_quotes(word), end);
    } else if (number) {
        in.warn("stray", "expected a keyword, found {}{}", in_quotes(word), end);
    } else {
        in.warn("keyword", "unknown keyword {}{}{}", in_quotes(word), end,
                did_you_mean(word, p3f::keyword_names()));
    }
}

void read_statements(Loader& loader) {
    Reader& in = loader.in;
    std::string_view before;
    while (!in.tokens().at_end()) {
        const p3f::Handler read = p3f::find_handler(in.tokens().peek());
        if (!read) {
            complain(loader, before);
            continue;
        }
        before = in.begin();
        read(loader);
        if (!in.ok()) p3f::skip_to_keyword(in);
        in.recover();
    }
}

/// Without any camera nothing can be rendered. Beside a good one a bad one does no harm.
void settle_cameras(const Loader& loader, std::size_t end, DiagnosticLog& log) {
    const std::optional<p3f::UnusableCamera>& bad = loader.unusable_camera;
    if (bad && loader.has_camera) {
        log.warn(bad->offset, "camera", "{}; this camera is left out", bad->why);
    } else if (bad) {
        log.error(bad->offset, "camera", "{}, so nothing can be rendered", bad->why);
    } else if (!loader.has_camera) {
        log.error(end, "camera", "no camera, so nothing can be rendered");
    }
}

/// What the course's programs of 2021 did to a picture.
void apply_legacy(Scene& scene) {
    scene.whitted.max_depth = 6;
    scene.whitted.fixed_bias = 1e-3;
    scene.whitted.schlick = true;
    scene.whitted.clamp_each_ray = true;
    if (scene.environment.skybox) scene.environment.skybox->nearest = true;
    if (scene.lights.empty()) return;
    const float share = 1 / (1.25F * static_cast<float>(scene.lights.size()));
    for (Material& m : scene.materials) m.specular *= share;
}

}  // namespace

LoadResult load_p3f(std::string_view text, const std::string& path, const LoadOptions& options) {
    DiagnosticLog log(path, text, options.strict);
    Loader loader{Reader(text, log), options, std::filesystem::path(path).parent_path()};
    loader.scene.format = "p3f";
    loader.scene.display_colors = true;
    read_statements(loader);
    settle_cameras(loader, text.size(), log);
    if (options.legacy) apply_legacy(loader.scene);
    LoadResult result;
    if (!log.has_errors()) result.scene = std::move(loader.scene);
    result.diagnostics = log.take();
    return result;
}

}  // namespace etalon
