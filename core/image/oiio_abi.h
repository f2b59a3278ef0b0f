// Interface between the OpenImageIO module and the rest of the program, in C types only, so that no
// exception and no type of a library crosses it. Texts are UTF-8 and end in a zero.
#pragma once

#include <cstddef>

extern "C" {

struct EtalonImageFormat {
    int width, height, channels;
    int is_float;     ///< 0 for bytes
    int is_srgb;      ///< encoded by sRGB's curve; 0 for linear
    int orientation;  ///< as in TIFF and Exif, 1 to 8; 1: rows from the top, each from the left
};

/// Receiver of an image. The first two functions return 0 on failure; their caller then gives up.
struct EtalonSink {
    void* context;
    int (*begin)(void* context, const EtalonImageFormat* format);
    int (*append)(void* context, const void* data, std::size_t size);
    void (*fail)(void* context, const char* reason);
};

struct EtalonOiio {
    int version;  ///< etalon_oiio_version

    /// Reads the first image of a file: begin, then rows as stored in any number of appends, or
    /// none with `header_only`. The image has at most four channels. Returns 0 after fail.
    int (*read)(const char* path, int header_only, const EtalonSink* sink);
};

/// The module's one symbol has this type and the name etalon_oiio.
using EtalonOiioEntry = const EtalonOiio* (*)();

}  // extern "C"

inline constexpr int etalon_oiio_version = 4;
