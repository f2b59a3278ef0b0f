// etalon merge: merges parts of an image.
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/memory_limit.h"
#include "app/common/output.h"
#include "app/common/signals.h"
#include "app/merge/merged_films.h"
#include "app/part/image_identity.h"
#include "app/part/image_metadata.h"
#include "app/subcommands.h"
#include "core/image/file_replacement.h"
#include "core/image/io.h"
#include "core/numerics/pixel_window.h"

namespace etalon {
namespace {

struct Arguments {
    std::vector<std::string> parts;
    std::string output;
};

/// Returns the smallest window that contains all films.
Imath::Box2i window_of(const MergedFilms& merged) {
    Imath::Box2i window;
    for (const MergedFilm& m : merged.films) window.extendBy(m.stored.window);
    return window;
}

/// Returns the mean number of samples per pixel.
float samples_per_pixel(const MergedFilms& merged) {
    double samples = 0, pixels = 0;
    for (const MergedFilm& m : merged.films) {
        samples += static_cast<double>(m.film->samples().total_count());
        pixels += static_cast<double>(m.film->samples().size());
    }
    return static_cast<float>(samples / pixels);
}

std::string seeds_text(const MergedFilms& merged) {
    std::set<std::uint64_t> seeds;
    for (const MergedFilm& m : merged.films) {
        for (const SampleShare& share : m.stored.shares) seeds.insert(share.seed);
    }
    return fmt::format("{}", fmt::join(seeds, ", "));
}

void put(const MergedFilm& merged, RenderedImage& image) {
    const bool is_filtered = merged.film->is_filtered();
    const std::vector<Color> pixels =
        is_filtered ? merged.film->filtered().pixels() : merged.film->samples().pixels();
    const Imath::Box2i& window = merged.stored.window;
    const int width = window_size(image.window).x;
    auto row = pixels.begin();
    for (int y = window.min.y; y <= window.max.y; ++y) {
        const auto end = row + window_size(window).x;
        const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(y - image.window.min.y) * width +
                                      (window.min.x - image.window.min.x);
        std::copy(row, end, image.pixels.begin() + offset);
        row = end;
    }
}

RenderedImage image_of(const MergedFilms& merged) {
    const RenderSettings settings = film_settings(merged.identity);
    RenderedImage image{settings.resolution.x,   settings.resolution.y,
                        window_of(merged),       {},
                        settings.display_colors, {}};
    image.pixels.assign(pixel_count(image.window), Color(0.0F));
    image.keep_display_values = settings.keep_display_values;
    image.metadata = metadata_of(merged.metadata);
    image.metadata.erase("stopped");
    if (!merged.stopped.empty()) image.metadata["stopped"] = merged.stopped.front().reason;
    image.metadata["samplesPerPixel"] = samples_per_pixel(merged);
    image.metadata["seed"] = seeds_text(merged);
    for (const MergedFilm& m : merged.films) put(m, image);
    return image;
}

/// Returns the bytes of a film as it is written.
std::uint64_t size_of(ImageFilm& film) {
    std::uint64_t size = 0;
    StateWriter counter([&](std::string_view bytes) { size += bytes.size(); });
    film.transfer(counter);
    return size;
}

/// Takes the identity by value, so that no JSON is left when the file begins to change.
std::string line_of(MergedFilms& merged, const RenderedImage& image) {
    FilmAppendix appendix{std::move(merged.identity), metadata_json(image), {}};
    for (MergedFilm& m : merged.films) {
        m.stored.bytes = size_of(*m.film);
        appendix.films.push_back(m.stored);
    }
    return appendix_line(appendix);
}

/// A signal ends it early, after which no file is left that is not complete.
std::string write(const std::string& path, MergedFilms& merged, const RenderedImage& image) {
    const Result<std::string> encoded = encode_image(path, image);
    if (!encoded) return path + ": cannot be written: " + encoded.error;
    const std::string line = line_of(merged, image);
    const SignalGuard signals;
    FileReplacement file(path);
    const StateWriter::Sink put = [&](std::string_view bytes) {
        if (!SignalGuard::raised()) file.write(bytes);
    };
    put(encoded.value);
    write_appendix(line, put, [&](const StateWriter::Sink& sink) {
        StateWriter writer(sink);
        for (MergedFilm& m : merged.films) m.film->transfer(writer);
    });
    return SignalGuard::raised() ? "" : file.put_in_place();
}

void warn_of_gaps(const MergedFilms& merged, const RenderedImage& image) {
    std::size_t pixels = 0;
    for (const MergedFilm& m : merged.films) pixels += pixel_count(m.stored.window);
    if (pixels == image.pixels.size()) return;
    print_message("etalon: warning: {} pixels between the parts are in none: they are black\n",
                  image.pixels.size() - pixels);
}

/// The samples that they miss cannot be merged in later, as their share counts as rendered.
void warn_of_stopped(const MergedFilms& merged) {
    for (const StoppedFile& file : merged.stopped) {
        print_message("{}: warning: its rendering was stopped ({}): it has less than its share\n",
                      file.path, file.reason);
    }
}

int run(const Arguments& a) {
    limit_memory(0);
    if (const auto [error, status] = check_outputs({a.output}, a.parts); !error.empty()) {
        return fail(status, error);
    }
    Result<MergedFilms> merged = merge_films(a.parts);
    if (!merged) return fail(exit_unusable, merged.error);
    warn_of_stopped(merged.value);
    const RenderedImage image = image_of(merged.value);
    warn_of_gaps(merged.value, image);
    const std::string error = write(a.output, merged.value, image);
    if (!error.empty()) return fail(exit_not_written, error);
    return SignalGuard::raised() ? exit_signal + SignalGuard::signal() : exit_done;
}

}  // namespace

Action declare_merge(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add(
            "PART", arguments->parts,
            "EXR of `etalon render --part`, or a merged one: shares of samples, crops (with --part "
            "1/1), or runs with other seeds")
        .required();
    options.add("-o,--output", arguments->output, "Output file, an EXR, which can be merged again")
        .value("FILE")
        .required()
        .check([](const std::string& path) {
            return can_hold_channels(path) ? "" : path + ": expected a name ending in .exr";
        });
    return [arguments] { return run(*arguments); };
}

}  // namespace etalon
