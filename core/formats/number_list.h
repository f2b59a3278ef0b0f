// Reading of long lists of numbers, as in meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace etalon {

/// Reads numbers separated by blanks and by comments, from '#' to the end of the line. Stops when
/// `values` are full or the text continues with anything else: its end, a bracket, a quotation
/// mark, or a word that is not a number of the type as a whole. Moves p there. Returns how many
/// were read. T is float, double or std::int32_t; for the last, fractions are cut off.
template <class T>
std::size_t read_numbers(const char*& p, const char* last, std::span<T> values);

/// Appends all numbers up to such a place to `values`, those of a long list on all threads. Space
/// is reserved for a list up to the next bracket with numbers as long as those so far.
template <class T>
void read_numbers(const char*& p, const char* last, std::vector<T>& values);

}  // namespace etalon
