// Reading and writing of image files. A file is written completely or not at all: beside its place
// and then renamed. EXR, PNG and JPEG have libraries of their own; everything else goes through
// OpenImageIO, whose module is loaded at the first call that needs it.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/image/compact_image.h"
#include "core/image/extent.h"
#include "core/image/image.h"
#include "core/image/rendered_image.h"

namespace etalon {

/// Writes .exr (float RGB, ZIP, data window, all metadata and channels) or .png (8 bit), chosen by
/// the extension. The PNG of a crop has the crop and its offset. `exposure` in stops applies to PNG
/// only. Returns the reason of a failure, beginning with the path, or an empty string.
std::string write_image(const std::string& path, const RenderedImage& image, double exposure = 0);

/// Returns the bytes of such a file; the extension of `name` chooses its format.
Result<std::string> encode_image(const std::string& name, const RenderedImage& image,
                                 double exposure = 0);

/// Returns whether write_image() knows the extension.
bool can_write(const std::string& path);

/// Returns whether files of this extension can store an image's channels.
bool can_hold_channels(const std::string& path);

/// Returns whether write_image() applies the exposure to a file of this extension.
bool has_exposure(const std::string& path);

/// Reads an image file of the type that its first bytes show: EXR by OpenEXR, PNG by libpng, JPEG
/// by libjpeg; anything else by OpenImageIO. A failure's reason begins with the path, quotes no
/// library, and is a printable() line of bounded length.
Result<Image> read_image(const std::string& path, Extent extent = Extent::whole);

/// Reads the same colours in the form that takes least memory.
Result<CompactImage> read_compact_image(const std::string& path);

/// Returns a path as such a reason begins with it.
std::string path_in_reason(const std::string& path);

/// Returns what such a reason begins with.
std::string path_of_reason(const std::string& reason);

}  // namespace etalon
