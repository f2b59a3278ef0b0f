#include "core/formats/write/write.h"

#include <algorithm>
#include <array>

namespace etalon {
namespace {

// To add a format to write: its writer, declared in write.h, and a line here.
struct Entry {
    std::string_view extension;
    SceneWriter write;
};

constexpr std::array writers = {
    Entry{".pbrt", write_pbrt},
    Entry{".p3f", write_p3f},
};

}  // namespace

SceneWriter find_scene_writer(std::string_view extension) {
    const auto found = std::ranges::find(writers, extension, &Entry::extension);
    return found != writers.end() ? found->write : nullptr;
}

std::vector<std::string> writable_formats() {
    std::vector<std::string> names;
    for (const Entry& entry : writers) names.emplace_back(entry.extension.substr(1));
    return names;
}

std::string writable_extensions() {
    std::string list;
    for (const Entry& entry : writers) {
        list += (list.empty() ? "" : " or ") + std::string(entry.extension);
    }
    return list;
}

}  // namespace etalon
