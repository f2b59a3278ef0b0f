#include "tests/fuzz/image_target.h"
#include "tests/fuzz/target.h"

namespace etalon::fuzz {

const Target target = {
    [](std::string_view bytes) { read_image_file("image.exr", "\x76\x2f\x31\x01", bytes); }, false,
    false};

}  // namespace etalon::fuzz
