#include "core/intersect/bounded.h"

#include "core/intersect/kernels.h"

namespace etalon {

SceneBounds::SceneBounds(const Scene& scene) {
    std::vector<Box3> boxes;
    Box3 world;
    for (std::uint32_t id = 0; id < scene.primitives.size(); ++id) {
        const Box3 box = primitive_bounds(scene, id);
        if (box.isEmpty()) continue;
        if (!is_finite(box.min) || !is_finite(box.max)) {
            unbounded.push_back(id);
            continue;
        }
        boxes.push_back(box);
        bounded.push_back({Box3f(), id});
        world.extendBy(box);
    }
    frame = Frame(world);
    for (std::size_t i = 0; i < boxes.size(); ++i) bounded[i].box = frame.box(boxes[i]);
}

}  // namespace etalon
