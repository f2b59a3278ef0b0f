#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Channel of values other than colour, one for each pixel.
struct Channel {
    std::string name;  ///< the part before the last dot names a layer: "albedo.R"
    std::variant<std::vector<float>, std::vector<std::uint32_t>> values;

    std::size_t size() const {
        return std::visit([](const auto& v) { return v.size(); }, values);
    }
};

/// A rendered image: linear scene values, or display values, in a data window inside the full
/// frame.
struct RenderedImage {
    int width = 0, height = 0;    ///< size of the full frame (display window)
    Imath::Box2i window;          ///< pixels present, inclusive on both ends as in OpenEXR
    std::vector<Color> pixels;    ///< window.size() + 1 in each axis, rows from the top
    bool display_colors = false;  ///< values are display values, which PNG stores without a curve

    using Attribute = std::variant<int, float, std::string, Imath::M44f>;
    std::map<std::string, Attribute> metadata;

    std::vector<Channel> channels{};  ///< each has one value for each pixel, in the same order

    /// True if an EXR stores display values unchanged, not the light for which they stand.
    bool keep_display_values = false;
};

}  // namespace etalon
