// Effects of the parameters of PBRT plugins on an image.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/formats/pbrt/plugin_type.h"

namespace etalon::test {

/// A parameter and another value for it. Every parameter of the tables of plugins needs a row.
struct Row {
    std::string_view plugin;  ///< or "*": all of the category without a row of their own for it
    std::string_view parameter;
    /// Values as in a file, without brackets and quotes, for which the image differs; or @ and the
    /// name of one of the world's textures.
    std::string_view value;
    std::string_view with{};   ///< other parameters, of both images
    std::string_view other{};  ///< value for the first image; empty: it is not given there
    /// Reason why the image is the same, for parameters without effect. docs/pbrt.md mentions them.
    std::string_view no_effect{};
};

/// Returns the rows of a category.
std::span<const Row> rows_of(pbrt::Category category);

/// Returns the row of a parameter; null if there is none.
const Row* find_row(const pbrt::PluginType& plugin, std::string_view parameter);

/// Returns the default of a parameter as a value; empty if it has none that can be written.
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
