// Messages to tev, the image viewer, over the network. The README of its repository describes them
// (Tom94/tev, "Over the Network"), and Ipc.h has the numbers of the operations. Integers and floats
// are little-endian, texts end with a zero byte.
#pragma once

#include <string>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon::tev {

/// Returns the message that creates a black image with channels R, G and B.
std::string create_image(const std::string& name, int width, int height);

/// Returns the message with the colours of a part of it, inclusive on both ends, in rows.
std::string update_image(const std::string& name, const Imath::Box2i& part,
                         const std::vector<Color>& colors);

}  // namespace etalon::tev
