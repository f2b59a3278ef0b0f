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
#include "app/common/fail.h"
#include "app/common/started_rank.h"
#include "core/base/link_target.h"
#include "core/base/uninterrupted.h"
#include "core/base/write_target.h"
#include "core/image/atomic_file.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

bool is_named(const std::string& path) {
    return !path.empty() && path != "-";
}

bool is_device(const std::string& path) {
    std::error_code none;
    return fs::exists(path, none) && !fs::is_regular_file(path, none);
}

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code none;
    if (const bool a_exists = fs::exists(a, none); a_exists || fs::exists(b, none)) {
        return fs::equivalent(a, b, none);
    }
    const auto place_of = [&](const std::string& path) {
        return fs::weakly_canonical(fs::absolute(link_target(path), none), none);
    };
    const fs::path place = place_of(a);
    return place.empty() ? a == b : place == place_of(b);
}

/// Returns why a new file cannot be made in the folder; empty if it looks possible.
std::string check_folder(const std::string& folder, const std::string& name) {
    const std::string place = folder.empty() ? "." : folder;
    std::error_code error;
    if (!fs::is_directory(place, error)) {
        const bool is_known = !error || error == std::errc::no_such_file_or_directory ||
                              error == std::errc::not_a_directory;
        return place + (is_known ? " is not a directory" : ": " + error.message());
    }
    const long longest = ::pathconf(place.c_str(), _PC_NAME_MAX);
    if (longest > 0 && name.size() > static_cast<std::size_t>(longest)) {
        return error_text(ENAMETOOLONG);
    }
    if (::access(place.c_str(), W_OK) == 0) return {};
    const std::string shown = folder.empty() ? "this folder" : folder;
    if (errno == EACCES) return "no permission in " + shown;
    return shown + ": " + error_text(errno);
}

}  // namespace

std::string check_writable(const std::string& path) {
    std::error_code none;
    const std::string unwritable = path + ": cannot be written: ";
    if (fs::is_directory(path, none)) return unwritable + "is a directory";
    if (fs::exists(path, none) && ::access(path.c_str(), W_OK) != 0) {
        return unwritable + error_text(errno);
    }
    if (is_device(path)) return {};
    const fs::path target = link_target(path);
    const std::string error = check_folder(target.parent_path(), target.filename());
    return error.empty() ? "" : unwritable + error;
}

bool is_replaceable(const std::string& path) {
    return is_named(path) && !WriteTarget(path).is_in_place();
}

std::string find_clash(const std::vector<std::string>& outputs,
                       const std::vector<std::string>& inputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const std::string& output = outputs[i];
        if (!is_named(output) || is_device(output)) continue;
        const auto is_it = [&](const std::string& other) {
            return is_named(other) && is_same_file(output, other);
        };
        if (std::any_of(outputs.begin(), outputs.begin() + i, is_it)) {
            return output + ": is given for two outputs; expected two files";
        }
        if (std::ranges::any_of(inputs, is_it)) {
            return output + ": is an input, which would be lost; expected another file";
        }
    }
    return {};
}

std::pair<std::string, int> check_outputs(const std::vector<std::string>& outputs,
                                          const std::vector<std::string>& inputs) {
    if (std::ranges::count(outputs, "-") > 1) {
        return {"only one output can be -, standard output", exit_usage};
    }
    if (std::string error = find_clash(outputs, inputs); !error.empty()) {
        return {std::move(error), exit_usage};
    }
    for (const std::string& path : outputs) {
        if (!is_named(path)) continue;
        if (std::string error = check_writable(path); !error.empty()) {
            return {std::move(error), exit_not_written};
        }
    }
    return {};
}

std::string check_image_to_standard_output() {
    if (::isatty(STDOUT_FILENO) == 0 || started_rank().size != 1) return {};
    return "-o -: standard output is a terminal, which shows no image; expected a pipe or a file";
}

bool write_text(const std::string& path, const std::string& text) {
    if (path == "-") return write_result(text);
    const std::string error = write_file_atomically(path, text);
    if (!error.empty()) fail(exit_not_written, error);
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
