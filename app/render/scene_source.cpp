#include "app/render/scene_source.h"

#include <filesystem>

namespace etalon {

std::string SceneSource::receive() {
    if (!is_sent()) return {};
    std::string error = copy_.receive(ranks_);
    for (std::string* const path : {&a_.scene.path, &a_.scene.options.root}) {
        if (std::filesystem::path(*path).is_absolute()) *path = copy_.place_of(*path);
    }
    return error;
}

LoadedScene SceneSource::load() {
    if (a_.integrator != scene_integrator) a_.scene.options.integrator = a_.integrator;
    if (!is_sent() || a_.scene.path != "-") return etalon::load(a_.scene);
    standard_input_ = read_file(ranks_.rank() == 0 ? "-" : copy_.place_of("-"));
    return etalon::load(a_.scene, standard_input_.text());
}

std::string SceneSource::path_read() const {
    const bool is_copied = is_sent() && ranks_.rank() != 0 && a_.scene.path == "-";
    return is_copied ? copy_.place_of("-") : a_.scene.path;
}

void SceneSource::send(const std::set<std::string>& files) {
    if (is_sent()) send_scene(ranks_, files, standard_input_.text());
}

}  // namespace etalon
