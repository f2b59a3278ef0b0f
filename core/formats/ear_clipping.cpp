#include "core/formats/ear_clipping.h"

#include <functional>
#include <queue>

#include "core/formats/corner_tree.h"
#include "core/numerics/orientation.h"

namespace etalon {
namespace {

class EarClipper {
  public:
    explicit EarClipper(const std::vector<Vec2>& outline)
        : outline_(outline), corners_(outline.size()), blockers_(outline) {
        const auto count = static_cast<std::uint32_t>(outline.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            corners_[i] = {(i + count - 1) % count, (i + 1) % count, false};
        }
        for (std::uint32_t i = 0; i < count; ++i) update(i);
    }

    std::vector<std::array<std::uint32_t, 3>> clip() {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        while (triangles.size() + 2 < outline_.size()) {
            const std::uint32_t tip = next_ear();
            const auto [before, after, gone] = corners_[tip];
            triangles.push_back({before, tip, after});
            remove(tip);
        }
        return triangles;
    }

  private:
    struct Corner {
        std::uint32_t before, after;  ///< its neighbours among the corners that are left
        bool is_clipped;
    };

    bool is_convex(std::uint32_t i) const {
        const auto& [before, after, clipped] = corners_[i];
        return orientation(outline_[before], outline_[i], outline_[after]) > 0;
    }

    /// Tests only corners that are not convex: of the corners in a triangle of an outline that does
    /// not cross itself, the one next to its tip is none.
    bool is_ear(std::uint32_t i) const {
        const auto& [before, after, clipped] = corners_[i];
        return is_convex(i) && !blockers_.any_in({outline_[before], outline_[i], outline_[after]});
    }

    /// Finds the first ear. If a polygon that crosses itself leaves none, returns the first corner.
    std::uint32_t next_ear() {
        while (!candidates_.empty()) {
            const std::uint32_t i = candidates_.top();
            candidates_.pop();
            if (!corners_[i].is_clipped && is_ear(i)) return i;
        }
        while (corners_[first_].is_clipped) ++first_;
        return first_;
    }

    void remove(std::uint32_t i) {
        const auto [before, after, clipped] = corners_[i];
        corners_[i].is_clipped = true;
        blockers_.set(i, false);
        corners_[before].after = after;
        corners_[after].before = before;
        update(before);
        update(after);
    }

    /// Notes the shape of a corner with new neighbours: only these can have become ears.
    void update(std::uint32_t i) {
        const bool convex = is_convex(i);
        blockers_.set(i, !convex);
        if (convex) candidates_.push(i);
    }

    const std::vector<Vec2>& outline_;
    std::vector<Corner> corners_;
    CornerTree blockers_;
    std::uint32_t first_ = 0;  ///< no corner before it is left
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> candidates_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> clip_ears(const std::vector<Vec2>& outline) {
    return EarClipper(outline).clip();
}

}  // namespace etalon
