// JPEG and PNG files of every kind, made by the libraries themselves.
#pragma once

#include <cstdio>  // jpeglib.h needs it

#include <jpeglib.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace etalon::test {

struct JpegKind {
    std::string name;
    J_COLOR_SPACE given = JCS_RGB, stored = JCS_YCbCr;
    int channels = 3;
    int sampling = 2;  ///< of the first channel; 2 halves the resolution of the others
    bool progressive = false, arithmetic = false;
    int restart = 0;       ///< rows of blocks between restart markers
    std::string marker{};  ///< content of an APP1 segment
};

/// Returns all kinds that libjpeg can write and that are decoded differently.
std::vector<JpegKind> jpeg_kinds();

/// Returns an image of smooth ramps with noise.
std::string encoded_jpeg(const JpegKind& kind, int width, int height);

struct PngKind {
    int color_type = PNG_COLOR_TYPE_RGB, depth = 8;
    bool transparent = false;  ///< a tRNS chunk
    bool interlaced = false;
    double gamma = 0;     ///< of a gAMA chunk; 0: none
    int place_unit = -1;  ///< of an oFFs chunk, which has the place (3, 2); -1: none

    std::string name() const;
};

/// Returns all combinations that the format allows.
std::vector<PngKind> png_kinds();

/// Returns an image of random values.
std::string encoded_png(const PngKind& kind, int width, int height);

}  // namespace etalon::test
