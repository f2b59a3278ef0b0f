#include "app/common/program_facts.h"

#include <filesystem>
#include <system_error>

namespace etalon {

extern const char* const etalon_commit;

namespace {

std::string& noted_program_name() {
    static std::string name = "etalon";
    return name;
}

std::string& noted_command_line() {
    static std::string text;
    return text;
}

std::filesystem::path& noted_folder() {
    static std::filesystem::path folder;
    return folder;
}

/// Returns the folder of a program as it was called, from the working folder on if it is below
/// that.
std::filesystem::path folder_of(const std::filesystem::path& program) {
    std::error_code none;
    const std::filesystem::path folder = program.parent_path();
    const auto below = folder.lexically_relative(std::filesystem::current_path(none));
    return below.empty() || *below.begin() == ".." ? folder : below;
}

}  // namespace

std::string shell_quoted(std::string_view word) {
    constexpr std::string_view plain =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_@%+=:,./-";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) {
        return std::string(word);
    }
    std::string text(1, '\'');
    for (const char c : word) {
        if (c == '\'') text += "'\\'";
        text += c;
    }
    return text += '\'';
}

const BuildFacts& build_facts() {
    static const BuildFacts facts{ETALON_VERSION, etalon_commit, ETALON_COMPILER, ETALON_FLAGS};
    return facts;
}

void note_program_name(const std::string& name) {
    noted_program_name() = name;
}

const std::string& program_name() {
    return noted_program_name();
}

void note_command_line(int argc, char** argv) {
    if (argc > 0) noted_folder() = folder_of(argv[0]);
    std::string& text = noted_command_line();
    for (int i = 0; i < argc; ++i) {
        if (i > 0) text += ' ';
        text += shell_quoted(argv[i]);
    }
}

const std::string& command_line() {
    return noted_command_line();
}

std::string sibling_program(const std::string& name) {
    return shell_quoted((noted_folder() / name).string());
}

}  // namespace etalon
