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

/// Says in words where an identity differs from another one: "spp is 4, here 16; seed is ...",
/// with `where` for "here". Empty where it does not.
std::string identity_difference(const nlohmann::ordered_json& identity,
                                const nlohmann::ordered_json& other, std::string_view where);

/// Returns what an identity says of the film. Throws a nlohmann::json::exception if it is none.
RenderSettings film_settings(const nlohmann::ordered_json& identity);

}  // namespace etalon
