#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/scene_arguments.h"

namespace etalon {

/// Returns names and values of everything on which an image's samples depend, except for threads
/// and exact backends: two renderings with the same identity take the same samples. `scene` is the
/// hash of the contents of the scene's files.
nlohmann::ordered_json image_identity(const SceneArguments& arguments, std::uint64_t scene,
                                      const Scene& loaded, const RenderSettings& settings);

/// Returns where an identity differs from another one: "spp is 4, here 16; seed is ...", with
/// `where` for "here". Empty if it does not.
std::string identity_difference(const nlohmann::ordered_json& identity,
                                const nlohmann::ordered_json& other, std::string_view where);

/// Returns the film's settings in an identity. Throws a nlohmann::json::exception if it is
/// malformed.
RenderSettings film_settings(const nlohmann::ordered_json& identity);

}  // namespace etalon
