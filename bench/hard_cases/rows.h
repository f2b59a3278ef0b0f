// Rows of the catalogue of hard cases, as they are written down.
#pragma once

#include "bench/hard_cases/hard_case.h"

namespace etalon::hard {

using MakeRay = std::function<Ray(Random& random)>;
using MakeCaseSetup = std::function<CaseSetup()>;

/// The rows of one shape. Those of rays in float say so at the end of their variant; their scenes
/// must be made of floats.
class Rows {
  public:
    explicit Rows(std::string shape) : shape_(std::move(shape)) {}

    void add(const std::string& id, const std::string& variant, const MakeCaseSetup& make,
             Criterion criterion = Criterion::oracle);
    void add_in_float(const std::string& id, const std::string& variant, const MakeCaseSetup& make,
                      Criterion criterion = Criterion::oracle);

    /// A row of rays as they are made and one of them in float.
    void add_both(const std::string& id, const std::string& variant, const MakeCaseSetup& make,
                  Criterion criterion = Criterion::oracle);

    std::vector<HardCase> take() { return std::move(list_); }

  private:
    std::string shape_;
    std::vector<HardCase> list_;
};

/// A scene of nothing but `shape`.
template <class Shape>
CaseSetup only(const Shape& shape, double size, MakeRay ray) {
    CaseSetup setup{{}, size, std::move(ray)};
    setup.scene.geometry.add(shape, 0);
    return setup;
}

/// "1e3"
std::string power_of_ten(int exponent);

/// "2^-3"
std::string power_of_two(int exponent);

}  // namespace etalon::hard
