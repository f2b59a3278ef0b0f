#include "core/texture/image_uses.h"

#include <map>

namespace etalon {
namespace {

/// Returns the images that textures of type T use.
template <class T>
std::vector<bool> shown_images(const std::vector<Texture<T>>& textures, std::size_t images) {
    std::vector<bool> shown(images, false);
    for (const Texture<T>& texture : textures) {
        if (const auto* image = std::get_if<ImageTexture<T>>(&texture)) shown[image->image] = true;
    }
    return shown;
}

}  // namespace

ImageUses image_uses(const Textures& textures) {
    const std::size_t count = textures.images.size();
    const std::vector<bool> as_colors = shown_images(textures.colors, count);
    const std::vector<bool> as_numbers = shown_images(textures.numbers, count);
    std::map<std::string, std::size_t> numbers;
    ImageUses uses;
    for (std::size_t i = 0; i < count; ++i) {
        if (!as_colors[i] && !as_numbers[i]) continue;
        const auto [file, is_new] = numbers.emplace(textures.images[i].file, numbers.size());
        if (is_new) uses.files.push_back(file->first);
        if (as_colors[i]) uses.list.push_back({i, file->second, Shown::colors});
        if (as_numbers[i]) uses.list.push_back({i, file->second, Shown::numbers});
    }
    return uses;
}

TexelKey texel_key(const ImageUse& use, const KeptTexels& kept, const TextureImage& how) {
    if (kept.same_as_file) return {use.file};
    return {use.file, false, use.what, how.decode_srgb, how.wrap};
}

Image grey_pixel() {
    return {1, 1, 1, std::vector<float>{0.5F}, Encoding::linear, {}};
}

}  // namespace etalon
