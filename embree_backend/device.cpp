#include "embree_backend/device.h"

#include <new>
#include <stdexcept>

#if defined(__SANITIZE_THREAD__)
/// Suppresses false data races: Embree's threads synchronise in oneTBB, which TSan cannot see.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
    return "race:libembree\n";
}
#endif

namespace etalon {
namespace {

/// Limits Embree to AVX2: for single rays its AVX-512 kernels are 4 to 12 % slower on Zen 4 and
/// within 4 % on a recent Xeon, and the baseline should measure the same code everywhere.
constexpr const char* configuration = "max_isa=avx2";

const char* describe(RTCError error) {
    switch (error) {
        case RTC_ERROR_INVALID_ARGUMENT:
            return "invalid argument";
        case RTC_ERROR_INVALID_OPERATION:
            return "invalid operation";
        case RTC_ERROR_OUT_OF_MEMORY:
            return "out of memory";
        case RTC_ERROR_UNSUPPORTED_CPU:
            return "this processor is not supported";
        case RTC_ERROR_CANCELLED:
            return "cancelled";
        default:
            return "unknown error";
    }
}

void throw_if(RTCError error) {
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw std::runtime_error(std::string("Embree " RTC_VERSION_STRING ": ") + describe(error));
}

bool count_bytes(void* counter, ssize_t bytes, bool) {
    static_cast<std::atomic<std::ptrdiff_t>*>(counter)->fetch_add(bytes, std::memory_order_relaxed);
    return true;
}

}  // namespace

EmbreeDevice::EmbreeDevice() : device_(rtcNewDevice(configuration)) {
    check();
    rtcSetDeviceMemoryMonitorFunction(handle(), count_bytes, &bytes_);
}

void EmbreeDevice::check() const {
    throw_if(rtcGetDeviceError(handle()));
}

void EmbreeDevice::commit(RTCScene geometry) const {
    rtcCommitScene(geometry);
    check();
}

std::string EmbreeDevice::isa() const {
#if defined(__x86_64__)
    if (rtcGetDeviceProperty(handle(), RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) == 0) {
        return __builtin_cpu_supports("sse4.2") ? "sse4.2" : "sse2";
    }
    return __builtin_cpu_supports("avx2") ? "avx2" : "avx";
#else
    return "neon";
#endif
}

}  // namespace etalon
