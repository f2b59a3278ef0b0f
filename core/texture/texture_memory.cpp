#include "core/texture/texture_memory.h"

#include <set>

#include "core/image/io.h"
#include "core/texture/image_uses.h"

namespace etalon {
namespace {

Image header_of(const std::string& file) {
    Result<Image> header = read_image(file, Extent::header);
    return header ? std::move(header.value) : grey_pixel();
}

}  // namespace

std::size_t texture_memory_bytes(const Textures& textures) {
    const ImageUses uses = image_uses(textures);
    std::vector<Image> headers;
    for (const std::string& file : uses.files) headers.push_back(header_of(file));
    std::set<TexelKey> counted;
    std::size_t bytes = 0;
    for (const ImageUse& use : uses.list) {
        const TextureImage& how = textures.images[use.image];
        const KeptTexels kept = kept_texels(headers[use.file], use.what, how.decode_srgb);
        if (counted.insert(texel_key(use, kept, how)).second) bytes += kept.bytes();
    }
    return bytes;
}

}  // namespace etalon
