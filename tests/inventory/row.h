// What a parameter of a PBRT plugin changes in a picture.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/formats/pbrt/plugin_type.h"

namespace etalon::test {

/// A parameter and another value for it. Every parameter of the tables of plugins needs a row.
struct Row {
    std::string_view plugin;  ///< or "*": all of the category that have no row of their own for it
    std::string_view parameter;
    /// Values as in a file, without brackets and quotes, with which the picture is another; or @
    /// and the name of one of the world's textures.
    std::string_view value;
    std::string_view with{};   ///< other parameters, of both pictures
    std::string_view other{};  ///< value for the first picture; none: it is not given there
    /// Why the picture is the same: of parameters that have no effect. docs/pbrt.md tells of them.
    std::string_view no_effect{};
};

/// The rows of a category.
std::span<const Row> rows_of(pbrt::Category category);

/// The row of a parameter; null if there is none.
const Row* find_row(const pbrt::PluginType& plugin, std::string_view parameter);

/// The default of a parameter as a value; empty where it has none that can be written.
std::string default_of(const pbrt::ParameterSpec& spec);

std::span<const Row> camera_rows();
std::span<const Row> sampler_rows();
std::span<const Row> film_rows();
std::span<const Row> filter_rows();
std::span<const Row> integrator_rows();
std::span<const Row> accelerator_rows();
std::span<const Row> shape_rows();
std::span<const Row> material_rows();
std::span<const Row> float_texture_rows();
std::span<const Row> spectrum_texture_rows();
std::span<const Row> light_rows();
std::span<const Row> area_light_rows();
std::span<const Row> medium_rows();

}  // namespace etalon::test
