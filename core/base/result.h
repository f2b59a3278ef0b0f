#pragma once

#include <string>

namespace etalon {

/// A result, or the reason why there is none.
template <class T>
struct Result {
    T value{};
    std::string error;  ///< empty on success
    explicit operator bool() const { return error.empty(); }
};

}  // namespace etalon
