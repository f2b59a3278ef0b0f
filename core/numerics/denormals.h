// Exact arithmetic needs denormals: they are the errors of products of small numbers.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace etalon {

/// Enables denormals during its lifetime, even if the calling thread flushes them to zero, as
/// Embree recommends. Nearly free if it does not.
class DenormalsCount {
  public:
#if defined(__SSE2__)
    DenormalsCount() : mode_(_mm_getcsr()) {
        if ((mode_ & flushing) != 0) _mm_setcsr(mode_ & ~flushing);
    }
    ~DenormalsCount() {
        if ((mode_ & flushing) != 0) _mm_setcsr(mode_);
    }
#else
    DenormalsCount() {}
    ~DenormalsCount() {}
#endif
    DenormalsCount(const DenormalsCount&) = delete;
    DenormalsCount& operator=(const DenormalsCount&) = delete;

#if defined(__SSE2__)
  private:
    static constexpr unsigned flushing = 0x8040;  // flush-to-zero, denormals-are-zero
    unsigned mode_;
#endif
};

}  // namespace etalon
