#include "app/common/output.h"

#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/common/console.h"
#include "core/image/atomic_file.h"

namespace etalon {

std::string check_writable(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path parent = fs::path(path).parent_path();
    const std::string directory = parent.empty() ? "." : parent.string();
    if (fs::is_directory(path, ignored)) return path + ": is a directory";
    if (!fs::is_directory(directory, ignored)) return directory + ": no such directory";
    if (access(directory.c_str(), W_OK) != 0) return directory + ": no permission to write there";
    return {};
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
