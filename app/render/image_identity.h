#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/scene_arguments.h"

namespace etalon {

/// Names and values of all that an image's samples depend on, but threads and exact backends: two
/// renderings of the same identity take the same samples. `scene` is the hash of what the scene's
/// files hold.
nlohmann::ordered_json image_identity(const SceneArguments& arguments, std::uint64_t scene,
                                      const Scene& loaded, const RenderSettings& settings);

/// Says in words where identities differ: "spp is 4, here 16; seed is ...". Empty where they do
/// not.
std::string identity_difference(const nlohmann::ordered_json& there,
                                const nlohmann::ordered_json& here);

}  // namespace etalon
