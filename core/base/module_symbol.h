#pragma once

#include <dlfcn.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace etalon {
namespace detail {

/// Throws if the folder is unknown, as the program's own is without /proc: any other folder, such
/// as the current one, may be a stranger's.
inline std::vector<std::filesystem::path> module_folders() {
    namespace fs = std::filesystem;
    if (const char* chosen = std::getenv("ETALON_MODULE_PATH")) {
        if (*chosen == 0)
            throw std::runtime_error("ETALON_MODULE_PATH is empty; expected a folder");
        return {chosen};
    }
    const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
    return {prefix / "lib", prefix / "lib" / "etalon"};
}

inline Result<void*> symbol_of(const std::filesystem::path& file, const char* symbol) {
    void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* found = module ? ::dlsym(module, symbol) : nullptr;
    return found ? Result<void*>{found, {}} : Result<void*>{nullptr, ::dlerror()};
}

}  // namespace detail

/// Loads a module, a library that few runs of a program need, and returns its symbol of that name.
/// The file is searched in the folder ETALON_MODULE_PATH if that is set, else in ../lib and
/// ../lib/etalon beside the program's own folder.
inline Result<void*> module_symbol(const std::string& file_name, const char* symbol) {
    namespace fs = std::filesystem;
    try {
        std::string places;
        for (const fs::path& folder : detail::module_folders()) {
            const fs::path file = fs::absolute(folder) / file_name;
            std::error_code none;
            if (fs::exists(file, none)) return detail::symbol_of(file, symbol);
            places += (places.empty() ? "" : " and ") + file.string();
        }
        return {nullptr, "no such file: " + places};
    } catch (const std::exception& e) {
        return {nullptr, e.what()};
    }
}

}  // namespace etalon
