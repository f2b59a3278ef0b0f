#include "app/common/stand_ins.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <utility>

#include "core/image/io.h"

namespace etalon {
namespace {

constexpr const char* kind = "image";

/// Takes the number after the last colon off a place; 0 if there is none.
int take_number(std::string& place) {
    const std::size_t colon = std::min(place.rfind(':'), place.size());
    int number = 0;
    if (colon < place.size()) {
        std::from_chars(&place[colon + 1], place.data() + place.size(), number);
    }
    place.erase(colon);
    return number;
}

Diagnostic diagnostic_of(const NamedImage& image, Severity severity, const std::string& reason) {
    std::string file = image.where;
    const int column = take_number(file), line = take_number(file);
    const std::string what = image.file.empty() ? "'filename' is missing" : reason;
    return {severity, kind,   std::move(file),
            line,     column, fmt::format("{}; {} stands in", what, image.stand_in)};
}

/// Returns the statements that name images, in their order for each path_in_reason().
std::multimap<std::string, const NamedImage*> images_by_name(const Scene& scene) {
    std::multimap<std::string, const NamedImage*> images;
    if (!scene.is_physical()) return images;
    for (const NamedImage& image : scene.physical().named_images) {
        images.emplace(path_in_reason(image.file), &image);
    }
    return images;
}

}  // namespace

std::vector<Diagnostic> stand_ins(const Scene& scene, const std::string& path,
                                  const std::vector<ImageProblem>& problems) {
    const auto named_images = images_by_name(scene);
    std::vector<Diagnostic> list;
    for (const auto& [severity, reason] : problems) {
        const auto [first, last] = named_images.equal_range(path_of_reason(reason));
        for (auto i = first; i != last; ++i) {
            list.push_back(diagnostic_of(*i->second, severity, reason));
        }
        if (first != last) continue;
        list.push_back({severity, kind, path, 0, 0, reason + "; the background colour stands in"});
    }
    return list;
}

std::string stand_in_warnings(const Scene& scene, const std::string& path,
                              const std::vector<std::string>& problems) {
    std::vector<ImageProblem> list;
    for (const std::string& problem : std::set<std::string>(problems.begin(), problems.end())) {
        list.push_back({Severity::warning, problem});
    }
    return report(stand_ins(scene, path, list));
}

}  // namespace etalon
