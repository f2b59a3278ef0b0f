// Fuzzes image readers: any bytes must give an image of the size in its header, or an error.
#pragma once

#include <string>
#include <string_view>

namespace etalon::fuzz {

/// Reads bytes as a file of that name: first the header alone, then the whole image. The first
/// bytes are replaced by `start`, the signature of the format. Without a known signature
/// OpenImageIO would try all its readers, which is slow and tests none of them.
void read_image_file(const std::string& name, std::string_view start, std::string_view bytes);

}  // namespace etalon::fuzz
