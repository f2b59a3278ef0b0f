#include "app/common/output.h"

#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

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
    if (path == "-") return fmt::print("{}", text), true;
    const std::string error = write_file_atomically(path, text);
    if (!error.empty()) fmt::print(stderr, "etalon: error: {}\n", error);
    return error.empty();
}

bool write_json(const std::string& path, const nlohmann::ordered_json& json) {
    constexpr auto lenient = nlohmann::ordered_json::error_handler_t::replace;
    return write_text(path, json.dump(2, ' ', false, lenient) + "\n");
}

}  // namespace etalon
