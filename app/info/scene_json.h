// Output of `info` as JSON: docs/json.md has the keys.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "app/scene_arguments.h"

namespace etalon {

/// Returns the contents of a loaded scene, what it needs, and the diagnostics about it.
nlohmann::ordered_json scene_json(const SceneArguments& arguments, const LoadedScene& loaded);

/// Returns the diagnostics; "more" is the number of further ones of the same kind, which are left
/// out.
nlohmann::ordered_json diagnostics_json(const std::vector<Diagnostic>& list);

}  // namespace etalon
