// The files that an image is written to.
#pragma once

#include <string>

#include "app/render/arguments.h"
#include "app/render/kept_state.h"
#include "core/image/rendered_image.h"

namespace etalon {

/// Returns where an image of `scene` goes if nobody says it.
std::string default_output(const std::string& scene);

/// Returns the exit status for outputs that cannot be had, as far as can be told before, and says
/// why.
int check_image_files(const RenderArguments& a);

/// Writes the image to one of the outputs, with what is kept of a part where the format has room
/// for that. Returns false, and says why, if that failed.
bool write_image_file(const RenderArguments& a, const std::string& path, const RenderedImage& image,
                      const KeptState& kept);

}  // namespace etalon
