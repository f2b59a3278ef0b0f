#pragma once

#include <algorithm>
#include <cstddef>

namespace etalon {

/// Reserves room for `more` elements of a vector, in steps that keep many small requests cheap.
template <class Vector>
void make_room(Vector& v, std::size_t more) {
    const std::size_t needed = v.size() + more;
    if (needed > v.capacity()) v.reserve(std::max(needed, 2 * v.capacity()));
}

}  // namespace etalon
