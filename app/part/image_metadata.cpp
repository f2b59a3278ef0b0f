#include "app/part/image_metadata.h"

#include <nlohmann/json.hpp>
#include <vector>

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json metadata_json(const RenderedImage& image) {
    Json json = Json::object();
    for (const auto& [name, value] : image.metadata) {
        if (const auto* matrix = std::get_if<Imath::M44f>(&value)) {
            json[name] = std::vector<float>((*matrix)[0], (*matrix)[0] + 16);
        } else if (const auto* text = std::get_if<std::string>(&value)) {
            json[name] = *text;
        } else if (const auto* number = std::get_if<float>(&value)) {
            json[name] = *number;
        }
    }
    return json;
}

std::map<std::string, RenderedImage::Attribute> metadata_of(const Json& json) {
    std::map<std::string, RenderedImage::Attribute> metadata;
    for (const auto& [name, value] : json.items()) {
        if (value.is_array() && value.size() == 16) {
            Imath::M44f matrix;
            for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = value[i];
            metadata[name] = matrix;
        } else if (value.is_string()) {
            metadata[name] = value.get<std::string>();
        } else if (value.is_number()) {
            metadata[name] = value.get<float>();
        }
    }
    return metadata;
}

}  // namespace etalon
