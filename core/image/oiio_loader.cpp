#include "core/image/oiio_loader.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace etalon {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> module_folders() {
    if (const char* chosen = std::getenv("ETALON_MODULE_PATH")) return {chosen};
    std::error_code none;
    const fs::path prefix = fs::read_symlink("/proc/self/exe", none).parent_path().parent_path();
    return {prefix / "lib", prefix / "lib" / "etalon"};
}

Result<const EtalonOiio*> open_module(const fs::path& file) {
    void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module) return {nullptr, ::dlerror()};
    const auto entry = reinterpret_cast<EtalonOiioEntry>(::dlsym(module, "etalon_oiio"));
    const EtalonOiio* table = entry ? entry() : nullptr;
    if (!table || table->version != etalon_oiio_version) {
        return {nullptr, file.string() + ": belongs to another version of the program"};
    }
    return {table, {}};
}

Result<const EtalonOiio*> find_module() {
    std::string places;
    for (const fs::path& folder : module_folders()) {
        const fs::path file = fs::absolute(folder) / "etalon_oiio.so";
        std::error_code none;
        if (fs::exists(file, none)) return open_module(file);
        places += (places.empty() ? "" : " and ") + file.string();
    }
    return {nullptr, "no such file: " + places};
}

Result<const EtalonOiio*> load() {
    try {
        Result<const EtalonOiio*> found = find_module();
        if (!found) found.error = "the OpenImageIO module cannot be loaded: " + found.error;
        return found;
    } catch (const std::exception& e) {
        return {nullptr, e.what()};
    }
}

}  // namespace

const Result<const EtalonOiio*>& load_oiio() {
    static const Result<const EtalonOiio*> module = load();
    return module;
}

}  // namespace etalon
