#pragma once

#include <optional>

#include "core/oracle/definitions.h"

namespace etalon::definition {

/// The interval of a line within a closed box, if there may be one.
struct LineInterval {
    Tracked entry, exit;
    Certainty exists;
};

std::optional<LineInterval> within_box(const Vec3& min, const Vec3& max, const Ray& ray);

/// Returns the ends of an interval, as crossings of the solid's surface.
Crossings ends(const std::optional<LineInterval>& interval);

}  // namespace etalon::definition
