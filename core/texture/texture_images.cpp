#include "core/texture/texture_images.h"

#include <map>

#include "core/color/srgb.h"
#include "core/image/io.h"
#include "core/numerics/luminance.h"
#include "core/parallel/parallel.h"
#include "core/texture/power_of_two.h"

namespace etalon {
namespace {

using SharedImage = std::shared_ptr<const Image>;

/// The images that textures of type T show.
template <class T>
std::vector<bool> shown_images(const std::vector<Texture<T>>& textures, std::size_t images) {
    std::vector<bool> shown(images, false);
    for (const Texture<T>& texture : textures) {
        if (const auto* image = std::get_if<ImageTexture<T>>(&texture)) shown[image->image] = true;
    }
    return shown;
}

Image grey_pixel() {
    return {1, 1, 1, std::vector<float>{0.5F}, Encoding::linear, {}};
}

/// Files by name, in the order in which they were first asked for.
class FileImages {
  public:
    /// Adds a file and returns its number.
    std::size_t add(const std::string& file) {
        const auto [place, is_new] = numbers_.emplace(file, files_.size());
        if (is_new) files_.push_back(file);
        return place->second;
    }

    void read(std::vector<std::string>& problems) {
        images_.resize(files_.size());
        std::vector<std::string> errors(files_.size());
        parallel_for(files_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Result<Image> file = read_image(files_[i]);
                errors[i] = std::move(file.error);
                images_[i] = std::make_shared<const Image>(errors[i].empty() ? std::move(file.value)
                                                                             : grey_pixel());
            }
        });
        for (std::string& error : errors) {
            if (!error.empty()) problems.push_back(std::move(error));
        }
    }

    const SharedImage& image(std::size_t number) const { return images_[number]; }

  private:
    std::map<std::string, std::size_t> numbers_;
    std::vector<std::string> files_;
    std::vector<SharedImage> images_;
};

/// Returns value(i) of all i below `count`, worked out on all threads.
template <class Value>
std::vector<float> values_of(std::size_t count, const Value& value) {
    std::vector<float> values(count);
    parallel_for(count, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) values[i] = value(i);
    });
    return values;
}

/// An image whose floats say what they show: those of a file may be encoded, if rarely.
SharedImage decoded_floats(const SharedImage& image, bool decode_srgb) {
    const auto* stored = std::get_if<std::vector<float>>(&image->pixels);
    if (!stored || !decode_srgb) return image;
    auto result =
        std::make_shared<Image>(Image{image->width, image->height, image->channels, {}, {}, {}});
    result->pixels = values_of(stored->size(), [&](std::size_t i) {
        return static_cast<float>(srgb_decoded((*stored)[i]));
    });
    return result;
}

/// An image of one number a pixel. As in pbrt-v3 the luminance is that of what is stored, and
/// decoded afterwards.
SharedImage luminance_image(const SharedImage& image, bool decode_srgb) {
    if (image->channels < 3) return decoded_floats(image, decode_srgb);
    const auto width = static_cast<std::size_t>(image->width);
    auto result = std::make_shared<Image>(Image{image->width, image->height, 1, {}, {}, {}});
    result->pixels = values_of(width * image->height, [&](std::size_t i) {
        const Color c = image->color(static_cast<int>(i % width), static_cast<int>(i / width));
        const float y = luminance(c);
        return decode_srgb ? static_cast<float>(srgb_decoded(y)) : y;
    });
    return result;
}

/// The numbers that an image shows, of one channel or three, by rows.
TexelGrid texels_of(const Image& image, bool decode_srgb) {
    const int channels = image.channels < 3 ? 1 : 3;
    const auto& bytes = decode_srgb ? decoded_byte_values() : detail::byte_values;
    const auto width = static_cast<std::size_t>(image.width) * channels;
    const auto number = [&](auto stored) {
        if constexpr (sizeof(stored) == 1) {
            return bytes[stored];
        } else {
            return stored;
        }
    };
    return {image.width, image.height, channels,
            std::visit(
                [&](const auto& stored) {
                    return values_of(width * image.height, [&](std::size_t i) {
                        return number(stored[i / channels * image.channels + i % channels]);
                    });
                },
                image.pixels)};
}

/// An image with sides of powers of two, as pbrt-v3 makes it of any other. Its floats are what they
/// say.
SharedImage stretched(const SharedImage& image, const TextureImage& how) {
    if (has_power_of_two_sides(image->width, image->height)) return image;
    TexelGrid grid = stretched_to_powers_of_two(texels_of(*image, how.decode_srgb), how.wrap);
    return std::make_shared<const Image>(
        Image{grid.width, grid.height, grid.channels, std::move(grid.values), {}, {}});
}

}  // namespace

TextureImages read_texture_images(const Textures& textures, std::vector<std::string>& problems) {
    const std::size_t count = textures.images.size();
    const std::vector<bool> as_colors = shown_images(textures.colors, count);
    const std::vector<bool> as_numbers = shown_images(textures.numbers, count);
    FileImages files;
    std::vector<std::size_t> file_of(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (as_colors[i] || as_numbers[i]) file_of[i] = files.add(textures.images[i].file);
    }
    files.read(problems);
    TextureImages result{std::vector<Texels>(count), std::vector<Texels>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        const TextureImage& how = textures.images[i];
        if (as_colors[i]) {
            result.colors[i] = {
                stretched(decoded_floats(files.image(file_of[i]), how.decode_srgb), how), how};
        }
        if (as_numbers[i]) {
            result.numbers[i] = {
                stretched(luminance_image(files.image(file_of[i]), how.decode_srgb), how), how};
        }
    }
    return result;
}

}  // namespace etalon
