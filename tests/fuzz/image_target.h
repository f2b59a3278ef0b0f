// Image files: whatever is in them, an image of the size it says or an error.
#pragma once

#include <string>
#include <string_view>

namespace etalon::fuzz {

/// Reads bytes as a file of that name, its header alone and whole. The first bytes become `start`,
/// which tells the format: what is of no known one is offered to all readers of OpenImageIO, which
/// takes most of the time and tests none of them.
void read_image_file(const std::string& name, std::string_view start, std::string_view bytes);

}  // namespace etalon::fuzz
