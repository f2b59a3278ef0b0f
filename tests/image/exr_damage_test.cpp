// EXR files whose last block of pixels is shorter than its lines or its tile. OpenEXR's C++ library
// gave what was in its memory.
#include <cstring>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/foreign_exr.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr int height = 64;

/// The last block of pixels in a file that ends with it.
struct LastBlock {
    std::size_t begin;  ///< of its size, a 32-bit number before its bytes
    std::string bytes;
};

std::uint64_t offset_at(const std::string& file, std::size_t at) {
    std::uint64_t offset = 0;
    std::memcpy(&offset, file.data() + at, sizeof offset);
    return offset;
}

/// Finds the last of a file's blocks by the table of their offsets, which ends where the first of
/// them begins.
LastBlock last_block(const std::string& file, const Layout& layout) {
    const std::size_t coordinates = layout.tiled ? 16 : 4;
    for (std::size_t at = 0; at + 8 < file.size(); ++at) {
        const std::uint64_t first = offset_at(file, at);
        if (first <= at || first > file.size() || (first - at) % 8 != 0) continue;
        const std::uint64_t last = offset_at(file, first - 8);
        const std::size_t begin = last + coordinates;
        if (last < first || begin + 4 > file.size()) continue;
        std::uint32_t size = 0;
        std::memcpy(&size, file.data() + begin, sizeof size);
        if (begin + 4 + size == file.size()) return {begin, file.substr(begin + 4)};
    }
    throw std::logic_error("no table of offsets");
}

/// Returns an EXR of two columns of tiles, or of lines as long, with R, G and B.
std::string file_of_width(int width, Layout layout) {
    const TemporaryFolder folder;
    layout.tile = {width, 32};
    write_foreign_exr<Imath::half>(folder / "p.exr", layout, Imf::HALF,
                                   {{0, 0}, {2 * width - 1, height - 1}});
    return content_of(folder / "p.exr");
}

std::string with_last_block(std::string file, const LastBlock& place, const std::string& bytes) {
    const auto size = static_cast<std::uint32_t>(bytes.size());
    file.resize(place.begin);
    file.append(reinterpret_cast<const char*>(&size), sizeof size);
    return file + bytes;
}

}  // namespace

TEST_CASE("an EXR whose last block lacks values is damaged, in each compression") {
    Layout layout{{"B", "G", "R"}};
    layout.tiled = GENERATE(false, true);
    layout.compression = GENERATE(
        Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
        Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION,
        Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION);
    CAPTURE(layout.tiled, layout.compression);
    const std::string file = file_of_width(24, layout);
    const LastBlock block = last_block(file, layout);
    std::vector<std::string> short_blocks = {""};
    // PIZ takes missing bits for zeros, which are code words of some values.
    if (layout.compression != Imf::PIZ_COMPRESSION) {
        short_blocks.push_back(last_block(file_of_width(12, layout), layout).bytes);
    }

    const TemporaryFolder folder;
    const std::string path = folder / "p.exr";
    put(path, with_last_block(file, block, block.bytes));
    CHECK(read_image(path).error == "");
    for (const std::string& bytes : short_blocks) {
        put(path, with_last_block(file, block, bytes));
        CHECK_THAT(read_image(path).error, ContainsSubstring("the EXR is damaged or cut short"));
    }
}
