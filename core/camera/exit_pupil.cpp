#include "core/camera/exit_pupil.h"

#include <algorithm>

#include "core/camera/lens_tracer.h"

namespace etalon {
namespace {

using Box = Imath::Box2d;

constexpr int pupils = 64;

/// Number of columns of the finest grid of points that determines a pupil, the same as of pbrt-v3's
/// samples of that square.
constexpr int finest = 1024;

/// Number of columns of the first grid, one point of which is in the middle. The pupil of a small
/// stop is also searched where the last one was.
constexpr int coarsest = 32;

/// Finds the pupils of points of the film, one after the other away from the middle.
class PupilFinder {
  public:
    explicit PupilFinder(const std::vector<LensSurface>& surfaces)
        : tracer_(surfaces),
          half_(1.5 * tracer_.rear_radius()),
          whole_(Vec2(-half_), Vec2(half_)) {}

    const Box& whole() const { return whole_; }

    /// Returns bounds of the points in the plane of the last surface through which light reaches
    /// the film at `x` from its middle.
    Box find(double x) {
        film_ = {x, 0, 0};
        Box found;
        add_grid(whole_, found);
        if (!last_.isEmpty()) {
            const Vec2 size = last_.size();
            add_grid({last_.min - size, last_.max + size}, found);
        }
        if (!found.isEmpty()) refine(found);
        return last_ = found;
    }

  private:
    bool passes(const Vec2& rear) const {
        const Vec3 at(rear.x, rear.y, tracer_.rear_z());
        return tracer_.from_film({film_, at - film_}).has_value();
    }

    /// Adds a point to the box if light passes it, and its mirror image: pupils are symmetric.
    void add(const Vec2& p, Box& found) const {
        if (found.intersects(p) || !passes(p)) return;
        found.extendBy(p);
        found.extendBy(Vec2(p.x, -p.y));
    }

    /// Adds the points of a grid.
    void add_grid(const Box& box, Box& found) const {
        const Vec2 step = Vec2(box.max.x - box.min.x, std::max(box.max.y, 0.0)) / coarsest;
        for (int j = 0; j <= coarsest; ++j) {
            for (int i = 0; i <= coarsest; ++i) {
                add({box.min.x + i * step.x, j * step.y}, found);
            }
        }
    }

    /// Extends the box by ever finer strips around it, until they are as fine as the finest grid.
    void refine(Box& found) const {
        const double end = 2 * half_ / finest;
        constexpr int points = 64;
        for (double step = 2 * half_ / coarsest; step > end; step /= 2) {
            const Box inner = found;
            for (double out = step; out > step / 4; out /= 2) {
                for (int i = 0; i <= points; ++i) {
                    const double part = static_cast<double>(i) / points;
                    const double y = part * inner.max.y;
                    add({inner.min.x + part * inner.size().x, inner.max.y + out}, found);
                    add({inner.min.x - out, y}, found);
                    add({inner.max.x + out, y}, found);
                }
            }
        }
    }

    LensTracer tracer_;
    double half_;  ///< half side of the square that is searched
    Box whole_, last_;
    Vec3 film_{0.0};
};

}  // namespace

std::vector<Box> exit_pupils(const std::vector<LensSurface>& surfaces, double film_diagonal) {
    PupilFinder finder(surfaces);
    const Vec2 margin(2 * finder.whole().size().length() / finest);
    std::vector<Box> result;
    Box before = finder.find(0);
    for (int i = 1; i <= pupils; ++i) {
        const Box here = finder.find(film_diagonal / 2 * i / pupils);
        Box both = before;
        both.extendBy(here);
        before = here;
        result.push_back(both.isEmpty() ? finder.whole()
                                        : Box(both.min - margin, both.max + margin));
    }
    return result;
}

}  // namespace etalon
