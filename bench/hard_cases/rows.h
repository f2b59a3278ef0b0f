// Construction of the rows of the catalogue of hard cases.
#pragma once

#include "bench/hard_cases/hard_case.h"

namespace etalon::hard {

using MakeRay = std::function<Ray(Random& random)>;
using MakeCaseSetup = std::function<CaseSetup()>;

/// The rows of one shape. Variants of float rays say so at the end of their name; their scenes must
/// have float coordinates.
class Rows {
  public:
    explicit Rows(std::string shape) : shape_(std::move(shape)) {}

    void add(const std::string& id, const std::string& variant, const MakeCaseSetup& make,
             Criterion criterion = Criterion::oracle);
    void add_in_float(const std::string& id, const std::string& variant, const MakeCaseSetup& make,
                      Criterion criterion = Criterion::oracle);

    /// Adds a row of rays as they are generated, and one of the same rays in float.
    void add_both(const std::string& id, const std::string& variant, const MakeCaseSetup& make,
                  Criterion criterion = Criterion::oracle);

    std::vector<HardCase> take() { return std::move(list_); }

  private:
    std::string shape_;
    std::vector<HardCase> list_;
};

/// Returns a scene with only `shape`.
template <class Shape>
CaseSetup only(const Shape& shape, double size, MakeRay ray) {
    CaseSetup setup{{}, size, std::move(ray)};
    setup.scene.geometry.add(shape, 0);
    return setup;
}

/// Returns "1e3".
std::string power_of_ten(int exponent);

/// Returns "2^-3".
std::string power_of_two(int exponent);

}  // namespace etalon::hard
