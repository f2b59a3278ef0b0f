#include "embree_backend/embree_backends.h"

#include "core/parallel/float_environment.h"
#include "embree_backend/builtin.h"
#include "embree_backend/plain_user_geometry.h"
#include "embree_backend/user_geometry.h"

namespace etalon {
namespace {

/// Restores the float environment: Embree's builder leaves the calling thread flushing denormals.
template <class Accelerator>
std::unique_ptr<Intersector> build(const Geometry& geometry) {
    const DefaultFloatEnvironment restored;
    return std::make_unique<Accelerator>(geometry);
}

std::unique_ptr<Intersector> build_robust(const Geometry& geometry) {
    const DefaultFloatEnvironment restored;
    return std::make_unique<EmbreeBuiltin>(geometry, EmbreeBuiltin::Traversal::robust);
}

constexpr Backend backends[] = {
    {.name = "embree",
     .summary = "Embree's hierarchy over the exact kernels",
     .exact = true,
     .build = build<EmbreeUserGeometry>,
     .colour = 6},
    {.name = "embree-user",
     .summary = "Embree's user geometry, one primitive per callback: the independent check",
     .exact = true,
     .build = build<PlainUserGeometry>,
     .colour = 4},
    {.name = "embree-builtin",
     .summary = "Embree's own float triangles, quads, spheres and instances",
     .exact = false,
     .build = build<EmbreeBuiltin>,
     .colour = 2,
     .has_own_kernels = EmbreeBuiltin::has_own_kernels},
};

constexpr Backend robust = {.name = "embree-builtin-robust",
                            .summary = "the same with RTC_SCENE_FLAG_ROBUST",
                            .exact = false,
                            .build = build_robust,
                            .colour = 5,
                            .has_own_kernels = EmbreeBuiltin::has_own_kernels};

}  // namespace

std::span<const Backend> embree_backends() {
    return backends;
}

const Backend& embree_builtin_robust() {
    return robust;
}

EmbreeLibrary embree_library() {
    const DefaultFloatEnvironment restored;
    const EmbreeDevice device;
    const auto v = rtcGetDeviceProperty(device.handle(), RTC_DEVICE_PROPERTY_VERSION);
    const std::string version = std::to_string(v / 10000) + '.' + std::to_string(v / 100 % 100) +
                                '.' + std::to_string(v % 100);
    return {version, RTC_VERSION_STRING, device.isa()};
}

}  // namespace etalon
