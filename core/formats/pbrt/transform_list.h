#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>

#include "core/formats/pbrt/matrix4.h"

namespace etalon::pbrt {

/// The transforms of a frame, of which a scene may have millions: three rows of each are kept, and
/// the last row of those that are not affine. A deque, as a vector that doubles is written about
/// twice.
class TransformList {
  public:
    /// Returns the number of the added transform; that of the identity is always 0.
    std::uint32_t add(const Matrix4& m) {
        if (m == Matrix4{}) return 0;
        const auto number = static_cast<std::uint32_t>(rows_.size());
        rows_.push_back({m[0], m[1], m[2]});
        if (!is_affine(m)) last_rows_.emplace(number, m[3]);
        return number;
    }

    std::size_t size() const { return rows_.size(); }

    Matrix4 operator[](std::uint32_t number) const {
        const auto& [x, y, z] = rows_[number];
        Matrix4 m{{x, y, z, {0, 0, 0, 1}}};
        if (const auto found = last_rows_.find(number); found != last_rows_.end()) {
            m[3] = found->second;
        }
        return m;
    }

  private:
    using Row = std::array<double, 4>;

    std::deque<std::array<Row, 3>> rows_ = {{Row{1, 0, 0, 0}, Row{0, 1, 0, 0}, Row{0, 0, 1, 0}}};
    std::map<std::uint32_t, Row> last_rows_;  ///< by the transform's number
};

}  // namespace etalon::pbrt
