#include "core/formats/sce/sce.h"

#include <algorithm>
#include <array>

#include "core/formats/nearest_name.h"
#include "core/formats/sce/sce_loader.h"

namespace etalon {
namespace {

using sce::Loader;

struct Command {
    std::string_view name;
    std::size_t values;  ///< number of its values
    sce::Handler read;
};

void do_nothing(Loader&, Reader&) {}

// To add a command: its reader in the fitting file of this folder, declared in sce_loader.h, and a
// line here.
constexpr std::array commands = {
    Command{"sce1.0", 0, do_nothing},  // the first line of every real file
    Command{"{", 0, sce::open_braces},
    Command{"}", 0, sce::close_braces},
    Command{"push_matrix", 0, sce::push_matrix},
    Command{"pop_matrix", 0, sce::pop_matrix},
    Command{"rotate", 4, sce::rotate},
    Command{"translate", 3, sce::translate},
    Command{"scale", 3, sce::scale},
    Command{"ca", 3, sce::read_ambient},
    Command{"cr", 3, sce::read_diffuse},
    Command{"cp", 3, sce::read_specular},
    Command{"shininess", 1, sce::read_shininess},
    Command{"ball", 4, sce::read_ball},
    Command{"cylinder", 0, sce::read_cylinder},
    Command{"triangle", 9, sce::read_triangle},
    Command{"object_flat", 1, sce::read_flat_object},
    Command{"object_phong", 1, sce::read_smooth_object},
    Command{"pointlight", 6, sce::read_point_light},
    Command{"arealight", 4, sce::read_area_light},
    Command{"eyepos", 3, sce::read_eye},
    Command{"eyedir", 3, sce::read_direction},
    Command{"eyeup", 3, sce::read_up},
    Command{"wdist", 1, sce::read_view_distance},
    Command{"fovy_deg", 1, sce::read_field_of_view},
    Command{"nx", 1, sce::read_width},
    Command{"ny", 1, sce::read_height},
    Command{"max_recursion", 1, sce::read_recursion},
    Command{"aasample", 1, sce::read_samples},
    Command{"background", 3, sce::read_background},
    Command{"end", 0, do_nothing},
};

/// Material commands that a single program has added.
constexpr std::array<std::string_view, 2> private_commands = {"alpha", "ri"};

constexpr auto names = [] {
    std::array<std::string_view, commands.size()> result;
    for (std::size_t i = 0; i < commands.size(); ++i) result[i] = commands[i].name;
    return result;
}();

bool has_right_values(Reader& in, std::size_t expected) {
    Tokenizer rest = in.tokens();
    std::size_t place = rest.offset(), found = 0;
    for (; !rest.at_end(); ++found) {
        if (found == expected) place = rest.offset();
        rest.next();
    }
    if (found == expected) return true;
    if (found < expected) place = rest.offset();
    in.warn_at(place, "values", "expected {} values after '{}', found {}; this line is left out",
               expected, in.keyword(), found);
    return false;
}

void report_unknown(Reader& in) {
    const std::string_view word = in.keyword();
    if (std::ranges::find(private_commands, word) != private_commands.end()) {
        in.warn("extension", "'{}' is a private extension of one program; it is left out", word);
    } else {
        in.warn("keyword", "unknown command {}{}", in_quotes(word), did_you_mean(word, names));
    }
}

void read_command(Loader& loader, Reader& in) {
    const auto command = std::ranges::find(commands, in.keyword(), &Command::name);
    if (command == commands.end()) {
        report_unknown(in);
    } else if (has_right_values(in, command->values)) {
        command->read(loader, in);
    }
}

/// Reads the lines up to `end`; the rest is not part of the scene.
void read_lines(Loader& loader, std::string_view text) {
    Tokenizer lines(text);
    while (!lines.at_end()) {
        Reader in(lines.take_line(), loader.log);
        if (in.begin() == "end") break;
        read_command(loader, in);
    }
    for (const sce::Block& open : loader.blocks) {
        loader.log.warn(open.offset, "block", "'{}' is never closed",
                        open.braces ? "{" : "push_matrix");
    }
}

}  // namespace

LoadResult load_sce(std::string_view text, const std::string& path, const LoadOptions& options) {
    DiagnosticLog log(path, text, options.strict);
    Loader loader{options, log, std::filesystem::path(path).parent_path()};
    Scene& scene = loader.scene;
    scene.whitted().environment.background = Color(0, 0, 0.3F);
    loader.settings.display_colors = true;
    loader.settings.max_depth = 6 + 1;
    loader.settings.resolution = {100, 100};
    scene.camera.eye = Vec3(0);
    scene.camera.up = Vec3(0, 1, 0);
    read_lines(loader, text);
    finalize_camera(loader);
    LoadResult result;
    if (!log.has_errors()) result.scene = std::move(loader.scene);
    result.settings = loader.settings;
    result.diagnostics = log.take();
    return result;
}

}  // namespace etalon
