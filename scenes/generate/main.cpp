// etalon-scenes FAMILY [--size N] [-o FILE.p3f]: a scene of a classic family, at any size.
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <system_error>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/parse_exit.h"
#include "scenes/generate/generator_families.h"
#include "scenes/generate/scene_output.h"

namespace etalon::generate {
namespace {

int fail(ExitStatus status, const std::string& message) {
    print_message("etalon-scenes: {}\n", message);
    return status;
}

/// The families, for --help and for who asks for one that does not exist.
std::string list_of_families() {
    std::string text = "Families (N is the size; in parentheses the default and the range):\n";
    for (const Family& f : families()) {
        text += fmt::format("  {:<12} {} ({}; {} to {})\n", f.name, f.description, f.default_size,
                            f.min_size, f.max_size);
    }
    return text;
}

int write_scene(const Family& family, std::int64_t size, const std::string& path) {
    try {
        Output output(path);
        Writer writer([&](std::string_view text) { output.write(text); });
        writer.comment(fmt::format("etalon-scenes {} --size {}", family.name, size));
        family.generate(writer, size);
        writer.flush();
        output.commit();
        return exit_done;
    } catch (const std::system_error& e) {
        if (path.empty()) return exit_not_written;  // status_after_results() says why
        return fail(exit_not_written, fmt::format("{}: {}", path, e.code().message()));
    }
}

int run(int argc, char** argv) {
    std::string name;
    std::string path;
    std::optional<std::int64_t> size;
    CLI::App app{"Writes a P3F scene of a classic family of test scenes, at any size."};
    app.name("etalon-scenes");
    app.add_option("FAMILY", name, "Family of scenes, see below")->required();
    app.add_option("-n,--size", size, "Size of the scene (default and range: see below)")
        ->type_name("N");
    app.add_option("-o,--output", path, "Output file (default: standard output)")
        ->type_name("FILE");
    app.footer(list_of_families());
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return exit_after_parsing(app, e);
    }

    const Family* family = find_family(name);
    if (family == nullptr) {
        return fail(exit_usage, fmt::format("no family '{}'\n{}", name, list_of_families()));
    }
    const std::int64_t n = size.value_or(family->default_size);
    if (n < family->min_size || n > family->max_size) {
        return fail(exit_usage, fmt::format("{} takes sizes from {} to {}, not {}", name,
                                            family->min_size, family->max_size, n));
    }
    return write_scene(*family, n, path);
}

}  // namespace
}  // namespace etalon::generate

int main(int argc, char** argv) {
    etalon::prepare_standard_streams();
    return etalon::status_after_results("etalon-scenes", etalon::generate::run(argc, argv));
}
