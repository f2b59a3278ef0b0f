#include "app/render/prepared_scene.h"

#include "app/common/backends.h"
#include "app/common/exit_status.h"
#include "app/render/aovs.h"
#include "app/render/fail_with.h"
#include "app/render/memory.h"
#include "app/replaced_images.h"
#include "core/shading/textured_cut_outs.h"

namespace etalon {

int PreparedScene::load(SceneSource& source) {
    LoadedScene loaded = source.load();
    if (!loaded.scene) return loaded.status;
    scene_ = std::move(*loaded.scene);
    settings_ = std::move(loaded.settings);
    files_ = std::move(loaded.files);
    prepare_scene(a_.integrator, scene_, settings_);
    if (const std::string error = apply_overrides(a_, scene_, settings_); !error.empty()) {
        return fail_with(error), exit_usage;
    }
    if (const std::string missing = check_memory(a_, settings_); !missing.empty()) {
        return fail_with(missing), exit_unusable;
    }
    return exit_done;
}

bool PreparedScene::build() {
    std::vector<std::string> problems;
    make_cut_outs(scene_, problems);
    const Backend& backend = chosen_backend(settings_);
    intersector_ = backend.build(scene_.geometry);
    packets_.emplace(scene_.geometry, *intersector_, backend.exact);
    integrator_ =
        find_integrator(settings_.integrator)->make(scene_, *packets_, settings_, problems);
    if (need_materials(a_.aovs) && scene_.is_physical() && integrator_->shading() == nullptr) {
        shading_.emplace(scene_, problems);
    }
    return tolerates(scene_, a_.scene, problems);
}

const PhysicalShading* PreparedScene::shading() const {
    return shading_ ? &*shading_ : integrator_->shading();
}

}  // namespace etalon
