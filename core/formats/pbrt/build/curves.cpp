// Curves, as parts of cubic Bezier curves, which the kernels intersect.
#include <bit>

#include "core/formats/pbrt/build/shape_builder.h"

namespace etalon::pbrt {
namespace {

Vec3 weighted(const Vec3& a, double weight_a, const Vec3& b, double weight_b) {
    return weight_a * a + weight_b * b;
}

/// Returns a quadratic curve as a cubic one.
std::array<Vec3, 4> raised(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {a, weighted(a, 1.0 / 3, b, 2.0 / 3), weighted(b, 2.0 / 3, c, 1.0 / 3), c};
}

/// Returns the Bezier points of the piece of a uniform B-spline that begins at the first of `p`,
/// which are one more than the degree.
std::array<Vec3, 4> from_b_spline(std::span<const Vec3> p) {
    if (p.size() == 3) {
        return raised(weighted(p[0], 0.5, p[1], 0.5), p[1], weighted(p[1], 0.5, p[2], 0.5));
    }
    const auto third = [&](std::size_t near, std::size_t far) {
        return weighted(p[near], 2.0 / 3, p[far], 1.0 / 3);
    };
    const Vec3 b = third(1, 2), c = third(2, 1);
    return {weighted(third(1, 0), 0.5, b, 0.5), b, c, weighted(c, 0.5, third(2, 3), 0.5)};
}

std::array<Vec3, 4> from_bezier(std::span<const Vec3> p) {
    return p.size() == 3 ? raised(p[0], p[1], p[2]) : std::array<Vec3, 4>{p[0], p[1], p[2], p[3]};
}

CurveType type_of(const Parameters& p) {
    const std::string_view name = p.string("type");
    if (name == "flat") return CurveType::flat;
    return name == "ribbon" ? CurveType::ribbon : CurveType::cylinder;
}

std::vector<Vec3> triples(std::span<const float> numbers) {
    std::vector<Vec3> list;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
        list.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    return list;
}

/// Returns the pieces of the file's curve, one after the other.
class StatedCurve {
  public:
    explicit StatedCurve(const Parameters& p)
        : points_(triples(p.numbers("P"))),
          degree_(static_cast<std::size_t>(p.integer("degree"))),
          is_b_spline_(p.string("basis") == "bspline"),
          width0_(p.number("width0")),
          width1_(p.number("width1")),
          type_(type_of(p)) {
        if (type_ == CurveType::ribbon) normals_ = triples(p.numbers("N"));
    }

    bool has_width() const { return width0_ != 0 || width1_ != 0; }
    std::size_t size() const {
        return is_b_spline_ ? points_.size() - degree_ : (points_.size() - 1) / degree_;
    }

    BezierCurve operator[](std::size_t i) const {
        const std::size_t first = is_b_spline_ ? i : i * degree_;
        const auto own = std::span(points_).subspan(first, degree_ + 1);
        const std::array<Vec3, 4> points = is_b_spline_ ? from_b_spline(own) : from_bezier(own);
        BezierCurve c{{}, {width_at(i), width_at(i + 1)}};
        for (std::size_t k = 0; k < 4; ++k) c.points[k] = Vec3f(points[k]);
        for (std::size_t k = 0; k < 2 && !normals_.empty(); ++k) {
            c.normals[k] = Vec3f(normals_[i + k].normalized());
        }
        c.type = type_;
        return c;
    }

  private:
    float width_at(std::size_t end) const {
        const double part = static_cast<double>(end) / static_cast<double>(size());
        return static_cast<float>((1 - part) * width0_ + part * width1_);
    }

    std::vector<Vec3> points_, normals_;
    std::size_t degree_;
    bool is_b_spline_;
    double width0_, width1_;
    CurveType type_;
};

}  // namespace

void build_curve(ShapeBuilder& s) {
    constexpr int deepest = std::countr_zero(CurveList::most_parts);
    const StatedCurve stated(s.parameters());
    if (!stated.has_width()) return s.skip("it has no width");
    const int depth = std::clamp(s.parameters().integer("splitdepth"), 0, deepest);
    const std::uint32_t parts = 1U << depth;
    SurfaceBinding binding;
    binding.flipped = s.flips_normals();
    s.begin(binding);
    for (std::size_t i = 0; i < stated.size(); ++i) {
        const BezierCurve piece = stated[i];
        for (std::uint32_t part = 0; part < parts; ++part) {
            s.add(Curve(piece, s.to_world, {part, parts}));
        }
    }
}

}  // namespace etalon::pbrt
