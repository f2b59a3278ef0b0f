#include "core/tessellate/nurbs.h"

#include <fmt/format.h>

#include <cmath>

#include "core/tessellate/b_spline_basis.h"

namespace etalon {
namespace {

std::string axis_error(const NurbsAxis& axis, char name) {
    std::string error = knots_error(axis.knots, axis.order, axis.points);
    if (error.empty()) {
        const double first = axis.knots[axis.order - 1], last = axis.knots[axis.points];
        const auto is_within = [&](double t) { return first <= t && t <= last; };
        if (is_within(axis.begin) && is_within(axis.end)) return {};
        error = fmt::format("its part from {} to {} is not within {} to {}", axis.begin, axis.end,
                            first, last);
    }
    return fmt::format("along {}: {}", name, error);
}

/// A point in homogeneous coordinates.
struct Weighted {
    Vec3 point{0};
    double weight = 0;

    void add(double factor, const Weighted& other) {
        point += factor * other.point;
        weight += factor * other.weight;
    }
};

/// Returns the derivative of the point in space, where `change` is that of the homogeneous point.
Vec3 derivative(const Weighted& at, const Weighted& change) {
    return (change.point - (change.weight / at.weight) * at.point) / at.weight;
}

struct Sample {
    BSplineBasis basis;
    float coordinate;
};

std::vector<Sample> samples_of(const NurbsAxis& axis, std::size_t side) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < side; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(side - 1);
        const double t = (1 - part) * axis.begin + part * axis.end;
        samples.push_back({b_spline_basis(axis.knots, axis.order, t), static_cast<float>(t)});
    }
    return samples;
}

void add_point(const Nurbs& surface, const Sample& u, const Sample& v, NurbsGrid& grid) {
    Weighted at, along_u, along_v;
    for (std::size_t j = 0; j < surface.v.order; ++j) {
        const std::size_t row = (v.basis.first + j) * surface.u.points + u.basis.first;
        Weighted value, change;
        for (std::size_t i = 0; i < surface.u.order; ++i) {
            const auto& [x, y, z, w] = surface.points[row + i];
            const Weighted control{{x, y, z}, w};
            value.add(u.basis.weights[i], control);
            change.add(u.basis.derivatives[i], control);
        }
        at.add(v.basis.weights[j], value);
        along_u.add(v.basis.weights[j], change);
        along_v.add(v.basis.derivatives[j], value);
    }
    const Vec3 normal = derivative(at, along_u).cross(derivative(at, along_v));
    const double length = std::sqrt(normal.dot(normal));
    const bool has_normal = length > 0 && length < infinity;
    grid.points.push_back(at.point / at.weight);
    grid.normals.push_back(has_normal ? normal / length : Vec3(0));
    grid.uvs.push_back({u.coordinate, v.coordinate});
}

}  // namespace

std::string nurbs_error(const Nurbs& surface) {
    std::string error = axis_error(surface.u, 'u');
    if (error.empty()) error = axis_error(surface.v, 'v');
    const std::size_t expected = surface.u.points * surface.v.points;
    if (error.empty() && surface.points.size() != expected) {
        error = fmt::format("{} x {} control points are {}, not {}", surface.u.points,
                            surface.v.points, expected, surface.points.size());
    }
    return error;
}

NurbsGrid diced(const Nurbs& surface, std::size_t side) {
    NurbsGrid grid;
    const std::vector<Sample> columns = samples_of(surface.u, side);
    for (const Sample& v : samples_of(surface.v, side)) {
        for (const Sample& u : columns) add_point(surface, u, v, grid);
    }
    return grid;
}

}  // namespace etalon
