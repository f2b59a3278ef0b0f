// What a long array does with room that it does not use: memory that was never written is none.
#pragma once

#include "core/parallel/large_pages.h"

namespace etalon {

/// Bytes of memory that an array takes.
template <class T>
std::size_t written_bytes(const LargeVector<T>& v) {
    return v.size() * sizeof(T);
}

/// Gives back the room that an array does not use, unless it is little or has large pages: those
/// were not written, and copying the array would only write others.
template <class T>
void give_back_room(LargeVector<T>& v) {
    const std::size_t room = v.capacity() - v.size();
    if (room > v.size() / 16 && room * sizeof(T) < large_page) v.shrink_to_fit();
}

}  // namespace etalon
