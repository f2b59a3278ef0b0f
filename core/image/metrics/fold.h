#pragma once

#include <vector>

#include "core/parallel/chunks.h"

namespace etalon {

/// Combines T(0) with term(0), ..., term(count - 1), on all threads but always in the same order.
template <class T, class Term, class Combine>
T fold(std::size_t count, const Term& term, const Combine& combine) {
    const Chunks chunks(count, 8192);
    std::vector<T> parts(chunks.number(), T(0));
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        T part(0);
        for (std::size_t i = begin; i < end; ++i) part = combine(part, term(i));
        parts[chunk] = part;
    });
    T whole(0);
    for (const T& part : parts) whole = combine(whole, part);
    return whole;
}

template <class T, class Term>
T sum(std::size_t count, const Term& term) {
    return fold<T>(count, term, [](const T& a, const T& b) { return a + b; });
}

}  // namespace etalon
