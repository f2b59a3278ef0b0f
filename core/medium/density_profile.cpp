#include "core/medium/density_profile.h"

#include "core/medium/grid_cell.h"
#include "core/medium/lattice_traversal.h"

namespace etalon {
namespace {

double simpson(double width, double first, double middle, double last) {
    return width / 6 * (first + 4 * middle + last);
}

}  // namespace

void DensityProfile::make(const DensityGrid& grid, const DensityBounds& bounds,
                          const RaySegment& ray, double enough) {
    grid_ = &grid;
    ray_ = ray;
    knots_.clear();
    DensityBounds::Traversal traversal(bounds, ray);
    double at = traversal.begin();
    while (const auto step = traversal.next()) {
        if (step->most > 0) add_cells(at, step->end);
        if (total() >= enough) return;
        at = step->end;
    }
}

/// Adds the part of the ray that is in the cells between two distances.
void DensityProfile::add_cells(double begin, double end) {
    LatticeTraversal traversal(grid_->size, 0.5, ray_, begin, end);
    const Vec3 size(grid_->size[0], grid_->size[1], grid_->size[2]);
    const Vec3 origin = size * ray_.origin - Vec3(0.5), direction = size * ray_.direction;
    double at = begin;
    while (const auto next = traversal.next()) {
        if (!(at < next->end)) continue;
        const GridCell cell(*grid_, next->index);
        const Vec3 corner(next->index[0], next->index[1], next->index[2]);
        const auto density = [&](double distance) {
            const Vec3 place = origin + distance * direction - corner;
            return std::max(cell.at(static_cast<float>(place.x), static_cast<float>(place.y),
                                    static_cast<float>(place.z)),
                            0.0F);
        };
        if (knots_.empty() || knots_.back().distance < at) {
            knots_.push_back({at, total(), density(at)});
        }
        const float last = density(next->end);
        const double part =
            simpson(next->end - at, knots_.back().density, density((at + next->end) / 2), last);
        knots_.push_back({next->end, total() + part, last});
        at = next->end;
    }
}

DensityProfile::Point DensityProfile::find(double integral) const {
    const auto after = std::ranges::upper_bound(knots_, integral, {}, &Knot::integral);
    const Knot &first = after[-1], &last = after[0];
    const double width = last.distance - first.distance, whole = last.integral - first.integral;
    const double part = (integral - first.integral) / whole;
    const double sum = static_cast<double>(first.density) + last.density;
    const double a = sum > 0 ? first.density / sum : 0.5;  // half the density relative to its mean
    const double root = std::sqrt(a * a + (1 - 2 * a) * part);
    const double x = part > 0 ? std::min(part / (a + root), 1.0) : 0;
    const double distance = first.distance + x * width;
    const double density = density_at(*grid_, ray_.point(distance));
    const double middle = density_at(*grid_, ray_.point(first.distance + x * width / 2));
    const double expected = 2 * root * whole / width;
    return {distance, first.integral + simpson(x * width, first.density, middle, density),
            expected > 0 ? density / expected : 0};
}

}  // namespace etalon
