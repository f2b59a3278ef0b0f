#pragma once

#include <algorithm>
#include <array>

#include "core/scene/polygon.h"

namespace etalon {

/// Least number of corners of a polygon whose projection is kept: for fewer, kernels that test
/// single rays gain nothing from it.
inline constexpr std::size_t least_corners_for_columns = 8;

/// Writes the projected corners to two columns of the same length: see OutlineColumns.
inline void project_outline(std::span<const Vec3> corners, const PolygonFacts& facts,
                            std::span<double> x, std::span<double> y) {
    const OutlineProjection& projection = facts.projection;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t last = corners.size() - 1;
        const Vec3 p = corners[i == 0 ? last : std::min(i - 1, last)] - facts.box.min;
        x[i] = p[projection.x_axis()] * projection.scale.x;
        y[i] = p[projection.y_axis()] * projection.scale.y;
    }
}

/// The projection of a polygon of few corners, which it does not keep. For kernels that test edge
/// after edge: without copies of the last corner.
class SmallOutline {
  public:
    explicit SmallOutline(const StoredPolygon& polygon) : edges_(polygon.corners.size()) {
        project_outline(polygon.corners, polygon.facts, std::span(x_).first(edges_ + 1),
                        std::span(y_).first(edges_ + 1));
    }

    OutlineColumns columns() const { return {x_.data(), y_.data(), edges_}; }

  private:
    std::size_t edges_;
    std::array<double, least_corners_for_columns> x_, y_;
};

}  // namespace etalon
