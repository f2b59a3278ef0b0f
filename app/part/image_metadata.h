#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/image/rendered_image.h"

namespace etalon {

/// Convert the image's metadata to JSON and back.
nlohmann::ordered_json metadata_json(const RenderedImage& image);
std::map<std::string, RenderedImage::Attribute> metadata_of(const nlohmann::ordered_json& json);

}  // namespace etalon
