#pragma once

#include <string>
#include <vector>

#include "core/image/io.h"
#include "tests/catch.h"

namespace etalon::test {

/// Returns the values of an image file of floats, which must be readable.
inline std::vector<float> pixels(const std::string& path) {
    const auto image = read_image(path);
    REQUIRE(image.error == "");
    return std::get<std::vector<float>>(image.value.pixels);
}

}  // namespace etalon::test
