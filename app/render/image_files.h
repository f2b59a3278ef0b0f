// The output files of an image.
#pragma once

#include <string>
#include <vector>

#include "app/render/arguments.h"
#include "app/render/kept_state.h"
#include "core/image/rendered_image.h"

namespace etalon {

/// Returns the default output of `scene`.
std::string default_output(const std::string& scene);

/// Returns the exit status if outputs cannot be written, as far as can be told in advance, or would
/// replace one of the scene's files, and prints why.
int check_image_files(const RenderArguments& a, const std::vector<std::string>& scene_files);

/// Writes the image to one of the outputs, with the film of a part if the format can hold it.
/// Returns false, and prints why, if that failed.
bool write_image_file(const RenderArguments& a, const std::string& path, const RenderedImage& image,
                      const KeptState& kept);

}  // namespace etalon
