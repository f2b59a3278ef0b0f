#include "core/texture/texture_images.h"

#include <algorithm>
#include <map>

#include "core/image/io.h"
#include "core/parallel/parallel.h"
#include "core/texture/image_uses.h"
#include "core/texture/shown_rows.h"

namespace etalon {
namespace {

using SharedImage = std::shared_ptr<const Image>;

std::vector<SharedImage> read_files(const std::vector<std::string>& files,
                                    std::vector<std::string>& problems) {
    std::vector<SharedImage> images(files.size());
    std::vector<std::string> errors(files.size());
    parallel_for(files.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Result<Image> file = read_image(files[i]);
            errors[i] = std::move(file.error);
            images[i] = std::make_shared<const Image>(errors[i].empty() ? std::move(file.value)
                                                                        : grey_pixel());
        }
    });
    for (std::string& error : errors) {
        if (!error.empty()) problems.push_back(std::move(error));
    }
    return images;
}

SharedTexels packed_texels(const KeptTexels& kept, const TexelRows& rows, Wrap wrap) {
    auto image = std::make_shared<PackedImage>(PackedImage{kept.width, kept.height, {}});
    const auto width = static_cast<std::size_t>(kept.width);
    image->texels.resize(width * kept.height);
    for_each_stretched_row(rows, wrap, [&](int y, std::span<const float> row) {
        PackedColor* const texels = &image->texels[y * width];
        for (std::size_t x = 0; x < width; ++x) {
            texels[x] = packed({row[3 * x], row[3 * x + 1], row[3 * x + 2]});
        }
    });
    return image;
}

SharedTexels float_texels(const KeptTexels& kept, const TexelRows& rows, Wrap wrap) {
    std::vector<float> values;
    const std::size_t count = kept.bytes() / sizeof(float);
    values.reserve(count);
    prefer_large_pages(values.data(), kept.bytes());
    values.resize(count);
    for_each_stretched_row(rows, wrap, [&](int y, std::span<const float> row) {
        std::ranges::copy(row, values.begin() + static_cast<std::ptrdiff_t>(y * row.size()));
    });
    return std::make_shared<const Image>(
        Image{kept.width, kept.height, kept.channels, std::move(values), {}, {}});
}

SharedTexels texels_of(const SharedImage& image, const KeptTexels& kept, Shown what,
                       const TextureImage& how) {
    if (kept.same_as_file) return image;
    const TexelRows rows = shown_rows(*image, what, how.decode_srgb);
    return kept.form == KeptTexels::Form::packed ? packed_texels(kept, rows, how.wrap)
                                                 : float_texels(kept, rows, how.wrap);
}

}  // namespace

TextureImages read_texture_images(const Textures& textures, std::vector<std::string>& problems) {
    const std::size_t count = textures.images.size();
    const ImageUses uses = image_uses(textures);
    const std::vector<SharedImage> files = read_files(uses.files, problems);
    std::map<TexelKey, SharedTexels> made;
    TextureImages result{std::vector<Texels>(count), std::vector<Texels>(count)};
    for (const ImageUse& use : uses.list) {
        const TextureImage& how = textures.images[use.image];
        const KeptTexels kept = kept_texels(*files[use.file], use.what, how.decode_srgb);
        const auto [texels, is_new] = made.try_emplace(texel_key(use, kept, how));
        if (is_new) texels->second = texels_of(files[use.file], kept, use.what, how);
        auto& all = use.what == Shown::colors ? result.colors : result.numbers;
        all[use.image] = {texels->second, how};
    }
    return result;
}

}  // namespace etalon
