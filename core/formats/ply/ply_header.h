// The header of a PLY file.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/formats/diagnostic_log.h"

namespace etalon::ply {

enum class FileFormat : std::uint8_t { ascii, little_endian, big_endian };

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Returns the size of a binary number in bytes.
std::size_t size_of(Type type);

struct Property {
    std::string_view name;
    Type type;
    std::optional<Type> count;  ///< type of the number of values, if it is a list
};

struct Element {
    std::string_view name;
    std::uint64_t count;
    std::size_t offset;  ///< offset of its line in the file
    std::vector<Property> properties;

    /// Returns the least number of bytes of an element in a binary file; exact if it has no lists.
    std::size_t least_bytes() const;
    bool has_lists() const;

    /// Returns the first property of that name that is, or is not, a list. Nothing if there is
    /// none.
    const Property* find(std::string_view property, bool list) const;
};

struct Header {
    FileFormat format;
    std::vector<Element> elements;  ///< in the order of the file, with different names
    std::size_t size;               ///< number of bytes before the first number

    const Element* find(std::string_view element) const;
};

/// Reads the header; its names refer to `bytes`. Nothing, after an error, if it is wrong.
std::optional<Header> read_header(std::string_view bytes, DiagnosticLog& log);

}  // namespace etalon::ply
