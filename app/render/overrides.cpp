#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "app/common/backends.h"
#include "app/render/aovs.h"
#include "app/render/arguments.h"
#include "app/render/filter_option.h"
#include "core/image/io.h"
#include "core/render/spd_rules.h"
#include "core/scene/resize.h"

namespace etalon {
namespace {

/// Largest number of samples per pixel of an image that ends by an error or a time limit.
constexpr int ample_samples = 1 << 16;

/// Returns the numbers of a text that consists of whole numbers with separators between them.
template <std::size_t count>
std::optional<std::array<int, count>> whole_numbers(std::string_view text, char separator) {
    std::array<int, count> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        const auto [end, error] =
            std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
        if (error != std::errc()) return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (i + 1 == count) break;
        if (!text.starts_with(separator)) return std::nullopt;
        text.remove_prefix(1);
    }
    return text.empty() ? std::optional(numbers) : std::nullopt;
}

std::string apply_resolution(const std::string& text, RenderSettings& settings) {
    if (text.empty()) return {};
    const auto parsed = whole_numbers<2>(text, 'x');
    const auto [width, height] = parsed.value_or(std::array{0, 0});
    if (width < 1 || height < 1) {
        return fmt::format(
            "--resolution {}: expected WIDTHxHEIGHT, e.g. 640x480, at most {} pixels a side", text,
            max_image_side);
    }
    if (std::max(width, height) > max_image_side) {
        return fmt::format("--resolution {}: expected at most {} pixels a side", text,
                           max_image_side);
    }
    resize(settings, {width, height});
    return {};
}

std::string apply_crop(const std::string& text, RenderSettings& settings) {
    if (text.empty()) return {};
    const auto parsed = whole_numbers<4>(text, ',');
    const auto [x0, y0, x1, y1] = parsed.value_or(std::array{0, 0, 0, 0});
    const Imath::V2i& size = settings.resolution;
    const bool inside = 0 <= x0 && x0 < x1 && x1 <= size.x && 0 <= y0 && y0 < y1 && y1 <= size.y;
    if (!inside) {
        return fmt::format("--crop {}: expected X0,Y0,X1,Y1 inside 0,0,{},{}", text, size.x,
                           size.y);
    }
    settings.crop = {{x0, y0}, {x1 - 1, y1 - 1}};
    return {};
}

/// Applies sampling options, which a deterministic image cannot have.
void apply_samples(const RenderArguments& a, RenderSettings& settings) {
    if (a.target_error > 0 || a.time_limit > 0) settings.samples_per_pixel = ample_samples;
    if (a.samples >= 0) settings.samples_per_pixel = a.samples;
    if (a.spd) apply_spd_rules(settings);
    settings.target_error = a.target_error;
    settings.seed = a.seed;
    if (a.sampler == "random") settings.sampler = Sampler::random;
}

/// The given options that only some integrators use.
std::vector<std::string_view> integrator_options(const RenderArguments& a) {
    std::vector<std::string_view> given;
    if (a.max_depth > 0) given.push_back("--max-depth");
    if (a.max_distance > 0) given.push_back("--max-distance");
    if (a.spd) given.push_back("--spd");
    return given;
}

/// Rejects options that the integrator would ignore.
std::string apply_integrator(const RenderArguments& a, const Scene& scene,
                             RenderSettings& settings) {
    choose_integrator(a.integrator, settings);
    if (a.max_depth > 0) settings.max_depth = a.max_depth;
    if (a.max_distance > 0) settings.max_distance = a.max_distance;
    const IntegratorType& chosen = *find_integrator(settings.integrator);
    if (!chosen.renders(scene)) {
        return fmt::format("--integrator {}: cannot render a {} scene; expected {}", chosen.name,
                           scene.format, fmt::join(integrators_for(scene), " or "));
    }
    for (const std::string_view option : integrator_options(a)) {
        if (chosen.obeys(option)) continue;
        return fmt::format("{}: the integrator {} does not have it; expected --integrator {}",
                           option, chosen.name, fmt::join(integrators_with(option), " or "));
    }
    return {};
}

/// Returns whether any output has a format for which `test` holds.
template <class Test>
bool any_output(const RenderArguments& a, const Test& test) {
    return std::ranges::any_of(
        a.outputs, [&](const std::string& output) { return test(format_name(a, output)); });
}

/// Rejects a format that no output has.
std::string check_output_format(const RenderArguments& a) {
    const bool is_used = a.output_format.empty() || std::ranges::count(a.outputs, "-") > 0;
    return is_used ? "" : "--output-format: no output is -; the names of files tell their formats";
}

/// Rejects an exposure that applies to no output.
std::string check_exposure(const RenderArguments& a) {
    const bool is_used = a.exposure == 0 || any_output(a, has_exposure);
    return is_used ? "" : "--exposure: no output is a PNG; expected -o FILE.png to have it";
}

std::string apply_part(const RenderArguments& a, RenderSettings& settings) {
    if (a.part.empty()) return {};
    const auto parsed = whole_numbers<2>(a.part, '/');
    const auto [part, parts] = parsed.value_or(std::array{0, 0});
    if (part < 1 || part > parts) {
        return "--part " + a.part + ": expected I/N, the I-th of N shares, e.g. 2/4";
    }
    settings.part = part;
    settings.parts = parts;
    if (settings.samples_per_pixel < settings.parts) {
        return fmt::format("--part {}: there are {} samples per pixel to share; expected --spp {}",
                           a.part, settings.samples_per_pixel, settings.parts);
    }
    const bool is_kept = any_output(a, can_hold_channels);
    return is_kept ? "" : "--part: no output is an EXR; expected -o FILE.exr to be merged";
}

/// Rejects options that need a checkpoint if there is none.
std::string check_checkpoint(const RenderArguments& a) {
    if (a.checkpoint == "-") return "--checkpoint -: expected a file, which is replaced each time";
    if (!a.checkpoint.empty()) return {};
    if (a.resume) return "--resume: expected --checkpoint FILE, from which to go on";
    return a.checkpoint_every > 0 ? "--checkpoint-every: expected --checkpoint FILE to write" : "";
}

std::string check_aovs(const RenderArguments& a, const RenderSettings& settings) {
    if (a.aovs.empty()) return {};
    if (!any_output(a, can_hold_channels)) {
        return "--aov: no output is an EXR; expected -o FILE.exr to hold the channels";
    }
    return check_aovs(a.aovs, chosen_backend(settings));
}

}  // namespace

std::string format_name(const RenderArguments& a, const std::string& output) {
    if (output != "-") return output;
    return "image." + (a.output_format.empty() ? "exr" : a.output_format);
}

std::string apply_overrides(const RenderArguments& a, const Scene& scene,
                            RenderSettings& settings) {
    apply_samples(a, settings);
    if (!a.backend.empty()) settings.backend = a.backend;
    if (!a.filter.empty()) apply_filter(a.filter, settings.filter);
    settings.variance = need_variance(a.aovs);
    settings.keep_display_values = a.display_values;
    if (a.target_error > 0 && settings.samples_per_pixel < 1) {
        return "--target-error needs at least one sample per pixel";
    }
    std::string error = apply_integrator(a, scene, settings);
    if (error.empty()) error = check_aovs(a, settings);
    if (error.empty()) error = check_output_format(a);
    if (error.empty()) error = check_exposure(a);
    if (error.empty()) error = check_checkpoint(a);
    if (error.empty()) error = apply_part(a, settings);
    if (error.empty()) error = apply_resolution(a.resolution, settings);
    return error.empty() ? apply_crop(a.crop, settings) : error;
}

}  // namespace etalon
