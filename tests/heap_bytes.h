#pragma once

#include <malloc.h>

#include <cstddef>

namespace etalon::test {

/// Returns the bytes allocated by all threads. A sanitizer has a heap of its own.
inline std::size_t heap_bytes() {
    const auto info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

}  // namespace etalon::test
