#include "core/intersect/batch_intersector.h"

#include <vector>

namespace etalon {
namespace {

std::vector<Ray> put_together(const RayStream& stream) {
    std::vector<Ray> rays;
    rays.reserve(stream.size());
    for (std::size_t i = 0; i < stream.size(); ++i) rays.push_back(stream[i]);
    return rays;
}

}  // namespace

void BatchIntersector::closest(const RayStream& rays, std::span<Hit> hits) const {
    const std::vector<Ray> all = put_together(rays);
    closest(std::span<const Ray>(all), hits);
}

void BatchIntersector::occluded(const RayStream& rays, std::span<std::uint8_t> blocked) const {
    const std::vector<Ray> all = put_together(rays);
    occluded(std::span<const Ray>(all), blocked);
}

}  // namespace etalon
