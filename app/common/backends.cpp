#include "app/common/backends.h"

#include <stdexcept>

#include "embree_backend/embree_backends.h"
#include "native_accel/native_backends.h"

namespace etalon {

namespace {

std::vector<Backend>& backends() {
    static std::vector<Backend> list = [] {
        std::vector<Backend> own;
        for (const auto& part : {native_backends(), embree_backends()}) {
            own.insert(own.end(), part.begin(), part.end());
        }
        return own;
    }();
    return list;
}

}  // namespace

const std::vector<Backend>& all_backends() {
    return backends();
}

void add_backend(const Backend& backend) {
    if (find_backend(backend.name)) {
        throw std::invalid_argument(std::string(backend.name) +
                                    ": there is a backend of that name");
    }
    backends().push_back(backend);
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
