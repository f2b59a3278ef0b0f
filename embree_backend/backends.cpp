#include "embree_backend/backends.h"

#include "embree_backend/builtin.h"
#include "embree_backend/user_geometry.h"

namespace etalon {
namespace {

template <class Accelerator>
std::unique_ptr<Intersector> build(const Scene& scene) {
    return std::make_unique<Accelerator>(scene);
}

constexpr Backend backends[] = {
    {"embree", "Embree's hierarchy over the exact kernels", true, build<EmbreeUserGeometry>},
    {"embree-builtin", "Embree's own float triangles, quads and spheres", false,
     build<EmbreeBuiltin>},
};

}  // namespace

std::span<const Backend> embree_backends() {
    return backends;
}

}  // namespace etalon
