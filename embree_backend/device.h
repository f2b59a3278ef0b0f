#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <type_traits>

#include "embree_backend/embree_shim.h"

namespace etalon {

struct EmbreeRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    void operator()(RTCBuffer buffer) const { rtcReleaseBuffer(buffer); }
    void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};

/// Owns what an rtcNew... function returned.
template <class Handle>
using EmbreeOwned = std::unique_ptr<std::remove_pointer_t<Handle>, EmbreeRelease>;

/// An Embree device that tracks how much memory it uses.
class EmbreeDevice {
  public:
    /// Throws std::runtime_error, with Embree's reason, if no device can be created on this
    /// machine.
    EmbreeDevice();
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;

    RTCDevice handle() const { return device_.get(); }

    /// Throws std::bad_alloc or std::runtime_error if a call since the last check failed.
    void check() const;

    /// Builds `scene` on the threads of the caller's TBB arena, as many as it may use.
    void commit(RTCScene scene) const;

    std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }

    /// Returns "sse2", "sse4.2", "avx", "avx2" or "neon".
    std::string isa() const;

  private:
    std::atomic<std::ptrdiff_t> bytes_{0};
    EmbreeOwned<RTCDevice> device_;  ///< reports to bytes_ until it is released
};

/// The device of a scene, which the intersectors of its objects share: Embree requires that of its
/// instances, and version 3 fails to make thousands of devices.
class SceneDevice {
  public:
    /// Creates a device, or shares that of the scene which contains an object. Throws as
    /// EmbreeDevice does.
    explicit SceneDevice(const SceneDevice* of_scene)
        : is_shared_(of_scene != nullptr),
          device_(is_shared_ ? of_scene->device_ : std::make_shared<const EmbreeDevice>()) {}

    const EmbreeDevice& operator*() const { return *device_; }
    const EmbreeDevice* operator->() const { return device_.get(); }

    /// Returns the bytes that the device uses; 0 for an object, whose scene counts them.
    std::size_t bytes() const { return is_shared_ ? 0 : device_->bytes(); }

  private:
    bool is_shared_;
    std::shared_ptr<const EmbreeDevice> device_;
};

}  // namespace etalon
