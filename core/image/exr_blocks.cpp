#include "core/image/exr_blocks.h"

#include <bit>
#include <cstring>
#include <map>
#include <span>
#include <string>

#include "core/color/decode_srgb.h"
#include "core/image/exr_zip.h"
#include "core/parallel/chunks.h"
#include "core/parallel/spares.h"

namespace etalon {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// A channel's 32-bit values, one for each pixel, and the byte stride.
struct Plane {
    const std::uint8_t* first;
    std::size_t stride;
    bool is_encoded = false;  ///< holds display values, but the file stores light
};

const std::uint8_t* data(const Channel& channel) {
    return std::visit([](const auto& v) { return reinterpret_cast<const std::uint8_t*>(v.data()); },
                      channel.values);
}

/// Returns the planes in the order of the file: by name.
std::map<std::string, Plane> planes_of(const RenderedImage& image) {
    std::map<std::string, Plane> planes;
    for (int k = 0; k < 3; ++k) {
        const auto* first = reinterpret_cast<const std::uint8_t*>(&(*image.pixels.data())[k]);
        planes[exr_color_names[k]] = {first, sizeof(Color),
                                      image.display_colors && !image.keep_display_values};
    }
    for (const Channel& c : image.channels) planes[c.name] = {data(c), sizeof(float)};
    return planes;
}

/// Gathers and compresses blocks of rows. Keeps its memory from block to block.
class BlockWriter {
  public:
    BlockWriter(const std::map<std::string, Plane>& planes, std::size_t width)
        : planes_(planes), width_(width) {}

    /// Returns rows [begin, end) of the image as the file stores them. Valid until the next call.
    Bytes operator()(std::size_t begin, std::size_t end) {
        gather(begin, end);
        return is_worth_zipping(end - begin) ? zip_(rows(0, end - begin)) : rows(0, end - begin);
    }

  private:
    /// Copies the values row by row, and in each row plane by plane.
    void gather(std::size_t begin, std::size_t end) {
        static_assert(std::endian::native == std::endian::little, "as in the file");
        values_.resize((end - begin) * planes_.size() * width_);
        float* row = values_.data();
        for (std::size_t y = begin; y < end; ++y) {
            for (const auto& [name, plane] : planes_) {
                const std::uint8_t* value = plane.first + y * width_ * plane.stride;
                for (std::size_t x = 0; x < width_; ++x, value += plane.stride) {
                    std::memcpy(row + x, value, sizeof(float));
                }
                if (plane.is_encoded) decode_srgb({row, width_});
                row += width_;
            }
        }
    }

    /// Returns the bytes of `count` of the rows gathered.
    Bytes rows(std::size_t first, std::size_t count) const {
        const std::size_t row = planes_.size() * width_ * sizeof(float);
        return {reinterpret_cast<const std::uint8_t*>(values_.data()) + first * row, count * row};
    }

    /// Returns false if some rows in the middle of the block compress by less than 4 %, as noise
    /// does. What all rows would then gain is not worth the time of the compressor, for which a
    /// small rendering would take a quarter longer.
    bool is_worth_zipping(std::size_t count) {
        constexpr std::size_t sample_bytes = 8192;  // the codes of less would count too much
        const std::size_t some = sample_bytes / rows(0, 1).size() + 1;
        if (count < exr_zip_rows / 2 || some > count / 2) return true;
        const Bytes middle = rows((count - some) / 2, some);
        return 25 * zip_(middle).size() < 24 * middle.size();
    }

    const std::map<std::string, Plane>& planes_;
    std::size_t width_;
    std::vector<float> values_;  ///< the bits of all values, of integers too
    ExrZip zip_;
};

}  // namespace

/// OpenEXR would start threads of its own in addition, and its compressor is slower.
std::vector<std::vector<std::uint8_t>> make_exr_blocks(const RenderedImage& image) {
    const std::map<std::string, Plane> planes = planes_of(image);
    const Imath::V2i last = image.window.size();
    const Chunks chunks(static_cast<std::size_t>(last.y) + 1, exr_zip_rows);
    std::vector<std::vector<std::uint8_t>> blocks(chunks.number());
    Spares<BlockWriter> writers;
    chunks.parallel_for_each([&](std::size_t i, std::size_t begin, std::size_t end) {
        const auto loan = writers.lend(planes, static_cast<std::size_t>(last.x) + 1);
        const Bytes block = (*loan)(begin, end);
        blocks[i].assign(block.begin(), block.end());
    });
    return blocks;
}

}  // namespace etalon
