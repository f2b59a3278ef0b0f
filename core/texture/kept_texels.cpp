#include "core/texture/kept_texels.h"

#include "core/texture/packed_colors.h"
#include "core/texture/power_of_two.h"

namespace etalon {

std::size_t KeptTexels::bytes() const {
    const std::size_t texels = static_cast<std::size_t>(width) * height;
    switch (form) {
        case Form::bytes:
            return texels * channels;
        case Form::floats:
            return texels * channels * sizeof(float);
        case Form::packed:
            return texels * sizeof(PackedColor);
    }
    return 0;
}

KeptTexels kept_texels(const Image& image, Shown what, bool decode_srgb) {
    using Form = KeptTexels::Form;
    const bool has_bytes = std::holds_alternative<PixelBytes>(image.pixels);
    const bool is_grey = image.channels < 3;
    const bool is_stretched = !has_power_of_two_sides(image.width, image.height);
    if (!is_stretched && (what == Shown::colors || is_grey) && (has_bytes || !decode_srgb)) {
        const Form form = has_bytes ? Form::bytes : Form::floats;
        return {form, true, image.width, image.height, image.channels};
    }
    const int width = next_power_of_two(image.width), height = next_power_of_two(image.height);
    if (is_grey || what == Shown::numbers) return {Form::floats, false, width, height, 1};
    return {has_bytes ? Form::packed : Form::floats, false, width, height, 3};
}

}  // namespace etalon
