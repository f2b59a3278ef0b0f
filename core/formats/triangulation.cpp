#include "core/formats/triangulation.h"

#include <algorithm>

#include "core/formats/degenerate.h"

namespace etalon {
namespace {

using Corners = std::vector<std::uint32_t>;

/// Triangulates a polygon by a fan about its first corner if that covers it, else by ear clipping
/// (Meisters 1975, "Polygons Have Ears").
class Triangulator {
  public:
    explicit Triangulator(std::span<const Vec3> corners)
        : points_(corners), normal_(area_normal(corners)), left_(corners.size()) {
        for (std::uint32_t i = 0; i < left_.size(); ++i) left_[i] = i;
    }

    /// Returns whether the whole polygon turns one way, seen from the first corner.
    bool is_fan() const {
        for (std::uint32_t i = 2; i < points_.size(); ++i) {
            if (!(area(0, i - 1, i) >= 0)) return false;
        }
        return true;
    }

    std::vector<std::array<std::uint32_t, 3>> fan() const {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::uint32_t i = 2; i < points_.size(); ++i) triangles.push_back({0, i - 1, i});
        return triangles;
    }

    std::vector<std::array<std::uint32_t, 3>> cut_ears() {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        while (left_.size() >= 3) {
            const std::size_t tip = find_ear();
            triangles.push_back({before(tip), left_[tip], after(tip)});
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(tip));
        }
        return triangles;
    }

  private:
    std::uint32_t before(std::size_t i) const {
        return left_[(i + left_.size() - 1) % left_.size()];
    }
    std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

    /// Returns twice the area, positive if counter-clockwise.
    double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return (points_[b] - points_[a]).cross(points_[c] - points_[a]).dot(normal_);
    }

    /// Finds an ear. If roundings or a self-intersecting polygon leave none, returns any corner.
    std::size_t find_ear() const {
        for (std::size_t i = 0; i < left_.size(); ++i) {
            if (is_ear(i)) return i;
        }
        return 0;
    }

    bool is_ear(std::size_t tip) const {
        const std::uint32_t a = before(tip), b = left_[tip], c = after(tip);
        if (!(area(a, b, c) > 0)) return false;
        return std::ranges::none_of(left_, [&](std::uint32_t p) {
            const Vec3& q = points_[p];  // a cut to a hole repeats a point
            const bool corner = q == points_[a] || q == points_[b] || q == points_[c];
            return !corner && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
        });
    }

    std::span<const Vec3> points_;
    Vec3 normal_;
    Corners left_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners) {
    constexpr std::size_t bearable = 4096;  // the time is at least quadratic
    Triangulator polygon(corners);
    return polygon.is_fan() || corners.size() > bearable ? polygon.fan() : polygon.cut_ears();
}

}  // namespace etalon
