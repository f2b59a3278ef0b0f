// etalon-scenes FAMILY [--size N] [-o FILE]: a scene of a family, at any size.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/help.h"
#include "app/common/program.h"
#include "app/common/signals.h"
#include "core/formats/load.h"
#include "core/formats/nearest_name.h"
#include "scenes/generate/generator_families.h"
#include "scenes/generate/scene_output.h"

namespace etalon::generate {
namespace {

struct Arguments {
    std::string family, path;
    std::optional<std::int64_t> size;
};

int fail(ExitStatus status, const std::string& message) {
    write_message("etalon-scenes: error: " + message + "\n");
    return status;
}

/// Returns the list of families, for --help and for errors.
std::string list_of_families() {
    std::string text = "Families (N is the size; in parentheses the default and the range):\n";
    for (const Family& f : families()) {
        text +=
            help_entry(std::string(f.name), fmt::format("{} ({}; {} to {})", f.description,
                                                        f.default_size, f.min_size, f.max_size));
    }
    return text;
}

std::vector<std::string> family_names() {
    std::vector<std::string> names;
    for (const Family& f : families()) names.emplace_back(f.name);
    return names;
}

int no_family(const std::string& name) {
    const std::vector<std::string> known = family_names();
    const std::vector<std::string_view> names(known.begin(), known.end());
    return fail(exit_usage, fmt::format("no family '{}'{}\n{}", name, did_you_mean(name, names),
                                        list_of_families()));
}

struct Interrupted {};

int write_scene(const Family& family, std::int64_t size, const std::string& path) {
    const SignalGuard signals;
    try {
        Output output(path);
        const auto write = [&](std::string_view text) {
            if (signals.raised()) throw Interrupted();
            output.write(text);
        };
        family.generate(write, fmt::format("etalon-scenes {} --size {}", family.name, size), size);
        output.commit();
        return exit_done;
    } catch (const Interrupted&) {
        return exit_signal + signals.signal();
    } catch (const std::runtime_error& e) {
        if (path.empty()) return exit_not_written;  // the end of the program says why
        return fail(exit_not_written, e.what());
    }
}

/// Returns whether a file's name says another format than the family's.
bool has_other_format(const Family& family, const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return extension != family.extension &&
           std::ranges::any_of(format_names(), [&](std::string_view name) {
               return extension == fmt::format(".{}", name);
           });
}

int run(const Arguments& a) {
    const Family* const family = find_family(a.family);
    if (family == nullptr) return no_family(a.family);
    const std::int64_t size = a.size.value_or(family->default_size);
    if (size < family->min_size || size > family->max_size) {
        return fail(exit_usage, fmt::format("{} takes sizes from {} to {}, not {}", a.family,
                                            family->min_size, family->max_size, size));
    }
    if (has_other_format(*family, a.path)) {
        return fail(exit_usage,
                    fmt::format("{}: {} is of another format; expected a name ending in {}", a.path,
                                a.family, family->extension));
    }
    return write_scene(*family, size, a.path == "-" ? "" : a.path);
}

Action declare(Options& options) {
    auto a = std::make_shared<Arguments>();
    options.add("FAMILY", a->family, "Family of scenes, see below")
        .required()
        .suggest(family_names());
    options.add("-n,--size", a->size, "Size of the scene (default and range: see below)");
    options.add("-o,--output", a->path, "Output file (default: -, standard output)").value("FILE");
    options.add_notes(list_of_families() + "\n");
    return [a] { return run(*a); };
}

constexpr Command command = {
    "etalon-scenes",
    "Write a scene of a family of test scenes, at any size, as P3F or PBRT",
    declare,
    {{{"sphereflake -o flake.p3f", "Write a sphereflake of the usual size"},
      {"mountain --size 4 | etalon info -", "Show what a smaller fractal mountain holds"}}}};

}  // namespace
}  // namespace etalon::generate

int main(int argc, char** argv) {
    return etalon::run_program(etalon::generate::command, argc, argv);
}
