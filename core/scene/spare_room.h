// Unused capacity of long arrays. Memory that was never written takes no space.
#pragma once

#include "core/parallel/large_pages.h"

namespace etalon {

/// Returns the bytes of memory that an array takes.
template <class T>
std::size_t written_bytes(const LargeVector<T>& v) {
    return v.size() * sizeof(T);
}

/// Releases the unused capacity of an array, unless it is small or in large pages: those were never
/// written, and copying the array would only write others.
template <class T>
void release_spare_capacity(LargeVector<T>& v) {
    const std::size_t room = v.capacity() - v.size();
    if (room > v.size() / 16 && room * sizeof(T) < large_page) v.shrink_to_fit();
}

}  // namespace etalon
