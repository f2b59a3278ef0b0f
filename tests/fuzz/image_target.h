// Image files: whatever is in them, an image of the size it says or an error.
#pragma once

#include <string>
#include <string_view>

namespace etalon::fuzz {

/// Reads bytes as a file of that name, its header alone and whole.
void read_image_file(const std::string& name, std::string_view bytes);

}  // namespace etalon::fuzz
