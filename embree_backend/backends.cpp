#include "embree_backend/backends.h"

#include "core/parallel/float_environment.h"
#include "embree_backend/builtin.h"
#include "embree_backend/user_geometry.h"

namespace etalon {
namespace {

/// Embree's builder leaves the calling thread flushing denormals to zero: that ends here.
template <class Accelerator>
std::unique_ptr<Intersector> build(const Scene& scene) {
    const DefaultFloatEnvironment restored;
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
