#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/scene/camera.h"

namespace etalon {

/// How a lens is focused.
struct LensFocus {
    double film_distance;   ///< from the last surface to the film
    double image_distance;  ///< from the principal plane on the film's side to the film
};

/// Where the film must be for what is at `distance` from it to be sharp, by the thick lens that the
/// lens is to rays near its axis. The error says why there is no such place.
Result<LensFocus> focused(const LensSystem& lens, double distance);

}  // namespace etalon
