#include "app/common/backends.h"

#include "embree_backend/embree_backends.h"
#include "native_accel/native_backends.h"

namespace etalon {

const std::vector<Backend>& all_backends() {
    static const std::vector<Backend> backends = [] {
        std::vector<Backend> list;
        for (const auto& part : {native_backends(), embree_backends()}) {
            list.insert(list.end(), part.begin(), part.end());
        }
        return list;
    }();
    return backends;
}

const Backend* find_backend(std::string_view name) {
    for (const Backend& backend : all_backends()) {
        if (backend.name == name) return &backend;
    }
    return nullptr;
}

const Backend& chosen_backend(const RenderSettings& settings) {
    return *find_backend(settings.backend.empty() ? default_backend : settings.backend);
}

std::vector<std::string> backend_names() {
    std::vector<std::string> names;
    for (const Backend& backend : all_backends()) names.emplace_back(backend.name);
    return names;
}

}  // namespace etalon
