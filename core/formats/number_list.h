// Long lists of numbers, as meshes in scene files are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace etalon {

/// Reads numbers with blanks and comments, from '#' to the end of the line, between them, until
/// `values` are full or the text goes on with anything else: its end, a bracket or a quotation
/// mark, or a word that is no number as a whole, or none of the type. Moves p there. Returns how
/// many were read. T is float, double or std::int32_t, to which what has a point is cut off.
template <class T>
std::size_t read_numbers(const char*& p, const char* last, std::span<T> values);

/// Appends all numbers up to such a place to `values`, those of a long list on all threads. Room is
/// made as if the list went on to the next bracket with numbers as long as those before.
template <class T>
void read_numbers(const char*& p, const char* last, std::vector<T>& values);

}  // namespace etalon
