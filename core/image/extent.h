#pragma once

namespace etalon {

/// How much of an image file is read. What a file's header says of its size, channels and encoding
/// is checked by both; an image read as `header` has no pixels, but holds the type that they have.
enum class Extent { header, whole };

}  // namespace etalon
