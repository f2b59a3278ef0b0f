// Statements about the image as a whole: accel, spp, env.
#include <fmt/ranges.h>

#include <array>

#include "core/formats/nearest_name.h"
#include "core/formats/p3f/p3f_loader.h"
#include "core/formats/skybox.h"

namespace etalon::p3f {

void read_accel(Loader& loader) {
    static constexpr std::array<std::string_view, 3> names = {"none", "grid", "bvh"};
    static constexpr std::array<std::string_view, 3> numbers = {"0", "1", "2"};  // old dialect
    Reader& in = loader.in;
    const std::string_view word = in.tokens().peek();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (word != names[i] && word != numbers[i]) continue;
        loader.settings.backend = names[i];
        in.tokens().next();
        return;
    }
    in.fail_at(in.tokens().offset(), "syntax",
               "expected none, grid or bvh (or 0, 1, 2) after 'accel', found {}{}", in_quotes(word),
               did_you_mean(word, names));
}

void read_samples(Loader& loader) {
    constexpr std::int64_t most = 1 << 20;
    Reader& in = loader.in;
    const std::size_t offset = in.tokens().offset();
    const std::int64_t samples = in.integer("samples");
    if (!in.ok()) return;
    if (samples < 0 || samples > most) {
        in.warn_at(offset, "range", "expected 0 to {} samples per pixel, found {}", most, samples);
        return;
    }
    loader.settings.samples_per_pixel = static_cast<int>(samples);
}

/// Finds the directory beside the scene file, else in the working directory.
void read_environment(Loader& loader) {
    Reader& in = loader.in;
    const std::size_t offset = in.tokens().offset();
    const std::string_view name = in.word("directory");
    if (!in.ok()) return;
    SkyboxFiles found = find_skybox(name, {loader.directory, ""}, FileScope(loader.options.root));
    if (!found.missing.empty() && !found.error.empty()) {
        return in.error("skybox", "{}", found.error);
    }
    if (!found.missing.empty()) {
        in.warn_at(offset, "skybox", "no skybox in {}: nothing found for {}, as {}",
                   path_in_quotes(name), fmt::join(found.missing, ", "),
                   ".jpg, .png, .exr or .hdr");
        return;
    }
    found.skybox.nearest = loader.options.legacy;
    loader.scene.whitted().environment.skybox = std::move(found.skybox);
}

}  // namespace etalon::p3f
