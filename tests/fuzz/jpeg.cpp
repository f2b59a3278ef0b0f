#include "tests/fuzz/image_target.h"
#include "tests/fuzz/target.h"

namespace etalon::fuzz {

const Target target = {
    [](std::string_view bytes) { read_image_file("image.jpeg", "\xff\xd8", bytes); }};

}  // namespace etalon::fuzz
