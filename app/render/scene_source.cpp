#include "app/render/scene_source.h"

#include <filesystem>

namespace etalon {

std::string SceneSource::receive() {
    if (!is_sent()) return {};
    std::string error = copy_.receive(ranks_);
    const bool is_absolute = std::filesystem::path(a_.scene.path).is_absolute();
    if (is_absolute) a_.scene.path = copy_.place_of(a_.scene.path);
    return error;
}

LoadedScene SceneSource::load() {
    if (!is_sent() || a_.scene.path != "-") return etalon::load(a_.scene);
    standard_input_ = read_file(ranks_.rank() == 0 ? "-" : copy_.place_of("-"));
    return etalon::load(a_.scene, standard_input_.text());
}

void SceneSource::send(const std::set<std::string>& files) {
    if (is_sent()) send_scene(ranks_, files, standard_input_.text());
}

}  // namespace etalon
