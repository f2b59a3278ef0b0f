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
    {"embree", "Embree's hierarchy over the exact kernels", true, build<EmbreeUserGeometry>, false,
     false, 6},
    {"embree-user", "Embree's user geometry, one primitive per callback: the independent check",
     true, build<PlainUserGeometry>, false, false, 4},
    {"embree-builtin", "Embree's own float triangles, quads, spheres and instances", false,
     build<EmbreeBuiltin>, false, false, 2, EmbreeBuiltin::has_own_kernels},
};

constexpr Backend robust = {"embree-builtin-robust",
                            "the same with RTC_SCENE_FLAG_ROBUST",
                            false,
                            build_robust,
                            false,
                            false,
                            5,
                            EmbreeBuiltin::has_own_kernels};

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
