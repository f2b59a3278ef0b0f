// All intersection backends, by name.
#pragma once

#include <string_view>
#include <vector>

#include "core/intersect/backend_roles.h"
#include "core/intersect/intersector.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Returns all backends in the order of help and reports. CONTRIBUTING.md lists the steps to add
/// one.
const std::vector<Backend>& all_backends();

/// Adds a backend of a program that is built on the installed libraries. Must be called first in
/// main(): it invalidates what the functions here returned before. Throws std::invalid_argument if
/// there is a backend of that name.
void add_backend(const Backend& backend);

/// Returns a backend by its name; nullptr if there is none.
const Backend* find_backend(std::string_view name);

/// Returns the backend that the settings name, else the default one.
const Backend& chosen_backend(const RenderSettings& settings);

/// Returns "none, grid, bvh, ..."
std::vector<std::string> backend_names();

}  // namespace etalon
