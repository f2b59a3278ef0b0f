#include <libdeflate.h>

#include "tests/fuzz/image_target.h"
#include "tests/fuzz/target.h"

namespace etalon::fuzz {
namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number = number << 8 | static_cast<std::uint8_t>(bytes[place + i]);
    return number;
}

/// Returns the file with the checksums of its chunks corrected: otherwise the reader would reject
/// most inputs at once.
std::string with_checksums(std::string_view bytes) {
    std::string file(bytes);
    for (std::size_t i = 8; i + 12 <= file.size();) {
        const std::size_t end = i + 8 + number_at(file, i);
        if (end + 4 > file.size()) break;
        std::uint32_t sum = libdeflate_crc32(0, &file[i + 4], end - i - 4);
        for (std::size_t k = 4; k-- > 0; sum >>= 8) file[end + k] = static_cast<char>(sum);
        i = end + 4;
    }
    return file;
}

}  // namespace

const Target target = {[](std::string_view bytes) {
    read_image_file("image.png", "\x89PNG\r\n\x1a\n", with_checksums(bytes));
}};

}  // namespace etalon::fuzz
