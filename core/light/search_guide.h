#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace etalon {

/// Speeds up the search in rows of increasing sums for a share of the last sum. The bounds of the
/// search are stored for equal steps of the share, so that a search in a long row reads little of
/// it (Chen & Asau 1974).
class SearchGuide {
  public:
    /// Adds a row. All have the same length.
    void add(std::span<const double> sums);

    /// Returns the index of the first sum of a row above `share`, in [0, 1), times its last sum,
    /// rounded; the row's length if there is none. `sums` must be those that were added.
    std::size_t first_above(std::size_t row, std::span<const double> sums, double share) const {
        const std::uint32_t* bounds = &bounds_[row * (steps + 1)];
        const auto step = static_cast<std::size_t>(share * steps);
        const auto from = sums.begin() + bounds[step], to = sums.begin() + bounds[step + 1];
        return static_cast<std::size_t>(std::upper_bound(from, to, share * sums.back()) -
                                        sums.begin());
    }

  private:
    static constexpr std::size_t steps = 64;

    std::vector<std::uint32_t> bounds_;
};

inline void SearchGuide::add(std::span<const double> sums) {
    auto found = sums.begin();
    for (std::size_t step = 0; step <= steps; ++step) {
        const double value = static_cast<double>(step) / steps * sums.back();
        while (found != sums.end() && *found <= value) ++found;
        bounds_.push_back(static_cast<std::uint32_t>(found - sums.begin()));
    }
}

}  // namespace etalon
