#include "app/common/stand_ins.h"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace etalon {
namespace {

/// Returns the place of the statement that names the image with which a problem begins, and what
/// stands in for it.
std::pair<std::string_view, std::string_view> statement_of(const Scene& scene,
                                                           std::string_view path,
                                                           std::string_view problem) {
    if (scene.is_physical()) {
        for (const NamedImage& image : scene.physical().named_images) {
            if (problem.starts_with(image.file + ": ")) return {image.where, image.stand_in};
        }
    }
    return {path, "the background colour"};
}

}  // namespace

std::string stand_in_message(const Scene& scene, std::string_view path, std::string_view severity,
                             std::string_view problem) {
    const auto [where, stand_in] = statement_of(scene, path, problem);
    return fmt::format("{}: {}: {}; {} stands in\n", where, severity, problem, stand_in);
}

std::string stand_in_warnings(const Scene& scene, std::string_view path,
                              const std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& problem : std::set<std::string>(problems.begin(), problems.end())) {
        text += stand_in_message(scene, path, "warning", problem);
    }
    return text;
}

}  // namespace etalon
