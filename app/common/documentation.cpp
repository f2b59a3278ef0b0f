#include "app/common/documentation.h"

#include <CLI/CLI.hpp>
#include <fstream>

#include "app/common/completion.h"
#include "app/common/console.h"
#include "app/common/man_page.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

bool write(const fs::path& file, const std::string& text) {
    std::error_code none;
    fs::create_directories(file.parent_path(), none);
    std::ofstream stream(file, std::ios::binary);
    stream << text << std::flush;
    if (!stream) print_message("{}: cannot be written\n", file.string());
    return stream.good();
}

}  // namespace

bool write_documentation(const CLI::App& program, const ValueChoices& choices,
                         const fs::path& folder) {
    const std::string& name = program.get_name();
    const fs::path pages = folder / "man1";
    const fs::path completions = folder / "completions";
    bool written =
        write(completions / "bash" / name, bash_completion(program, choices)) &&
        write(completions / "fish" / (name + ".fish"), fish_completion(program, choices)) &&
        write(completions / "zsh" / ("_" + name), zsh_completion(program, choices)) &&
        write(pages / (name + ".1"), man_page(program, name));
    for (const CLI::App* command : program.get_subcommands({})) {
        const std::string& sub = command->get_name();
        written = written &&
                  write(pages / (name + "-" + sub + ".1"), man_page(*command, name + " " + sub));
    }
    return written;
}

}  // namespace etalon
