// Fuzzes the arguments of a command line, one a line, up to the point where rendering would begin.
#include <CLI/CLI.hpp>
#include <sstream>

#include "app/common/help.h"
#include "app/common/usage_error.h"
#include "app/render/arguments.h"
#include "tests/fuzz/target.h"

namespace etalon::fuzz {
namespace {

void run(std::string_view text) {
    std::vector<std::string> words;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);)
        words.push_back(line.substr(0, line.find('\0')));
    std::vector<const char*> arguments{"render"};
    for (const std::string& word : words) arguments.push_back(word.c_str());
    CLI::App parser("", "render");
    ValueChoices choices;
    Options options(parser, choices);
    RenderArguments a;
    declare_render_options(options, a);
    try {
        parser.parse(static_cast<int>(arguments.size()), arguments.data());
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) {
            require(!usage_error(parser, error).empty(), "an error without words");
        }
        return;
    }
    RenderSettings settings;
    settings.resolution = {64, 48};  // a scene always has one
    Scene scene;
    if (!apply_overrides(a, scene, settings).empty()) return;
    const Imath::Box2i window = settings.window();
    require(!window.isEmpty() && window.min.x >= 0 && window.max.x < settings.resolution.x &&
                window.min.y >= 0 && window.max.y < settings.resolution.y,
            "a window outside of the image");
}

}  // namespace

const Target target = {run, true, false};

}  // namespace etalon::fuzz
