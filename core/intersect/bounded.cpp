#include "core/intersect/bounded.h"

#include <numeric>

#include "core/intersect/kernels.h"

namespace etalon {

SceneBounds SceneBounds::of(const Scene& scene) {
    SceneBounds result;
    std::vector<Box3> boxes;
    Box3 world;
    for (std::uint32_t id = 0; id < scene.primitives.size(); ++id) {
        const Box3 box = primitive_bounds(scene, id);
        if (box.isEmpty()) continue;
        if (!is_finite(box.min) || !is_finite(box.max)) {
            result.unbounded.push_back(id);
            continue;
        }
        boxes.push_back(box);
        result.bounded.push_back({Box3f(), id});
        world.extendBy(box);
    }
    result.frame = Frame(world);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        result.bounded[i].box = result.frame.box(boxes[i]);
    }
    return result;
}

SceneBounds SceneBounds::none_bounded(const Scene& scene) {
    SceneBounds result;
    result.unbounded.resize(scene.primitives.size());
    std::iota(result.unbounded.begin(), result.unbounded.end(), 0U);
    return result;
}

}  // namespace etalon
