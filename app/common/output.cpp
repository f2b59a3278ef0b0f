#include "app/common/output.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "core/image/atomic_file.h"

namespace etalon {

std::string check_writable(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path parent = fs::path(path).parent_path();
    const std::string directory = parent.empty() ? "." : parent.string();
    const std::string unwritable = path + ": cannot be written: ";
    if (fs::is_directory(path, ignored)) return unwritable + "is a directory";
    if (!fs::is_directory(directory, ignored))
        return unwritable + directory + " is not a directory";
    if (access(directory.c_str(), W_OK) == 0) return {};
    const std::string place = parent.empty() ? "this folder" : directory;
    if (errno == EACCES) return unwritable + "no permission in " + place;
    return unwritable + place + ": " + std::generic_category().message(errno);
}

std::pair<std::string, int> check_outputs(const std::vector<std::string>& paths) {
    if (std::ranges::count(paths, "-") > 1) {
        return {"only one output can be -, standard output", exit_usage};
    }
    for (const std::string& path : paths) {
        if (path.empty() || path == "-") continue;
        if (std::string error = check_writable(path); !error.empty()) {
            return {std::move(error), exit_not_written};
        }
    }
    return {};
}

std::string check_image_to_standard_output() {
    if (::isatty(STDOUT_FILENO) == 0) return {};
    return "-o -: standard output is a terminal, which shows no image; expected a pipe or a file";
}

bool write_text(const std::string& path, const std::string& text) {
    if (path == "-") return write_result(text);
    const std::string error = write_file_atomically(path, text);
    if (!error.empty()) print_message("etalon: error: {}\n", error);
    return error.empty();
}

bool write_json(const std::string& path, const nlohmann::ordered_json& json) {
    constexpr auto lenient = nlohmann::ordered_json::error_handler_t::replace;
    return write_text(path, json.dump(2, ' ', false, lenient) + "\n");
}

void write_table(const std::string& json, const std::string& table) {
    if (json == "-") return write_message(table);
    write_result(table);
}

}  // namespace etalon
