#pragma once

namespace etalon {

/// Part of an image file that is read. Both check what a file's header says of its size, channels
/// and encoding; an image read as `header` has no pixels, but the type that they have.
enum class Extent { header, whole };

}  // namespace etalon
