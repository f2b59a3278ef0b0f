// Interface of the OpenImageIO module to the rest of the program: C types only, so that
// no exception and no type of a library crosses it. Texts are UTF-8 and end in a zero.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

struct EtalonImageFormat {
    int width, height, channels;
    int is_float;  ///< else bytes
    int is_srgb;   ///< encoded by its curve, else linear
};

/// Receiver of results. Both functions return 0 on failure, and their caller then gives up.
struct EtalonSink {
    void* context;
    int (*begin)(void* context, const EtalonImageFormat* format);  ///< null if there is no format
    int (*append)(void* context, const void* data, std::size_t size);
    void (*fail)(void* context, const char* reason);
};

struct EtalonOiio {
    int version;  ///< etalon_oiio_version

    /// Reads the first image of a file: begin, then rows from the top in any number of appends.
    /// The image has at most four channels. Returns 0 after fail.
    int (*read)(const char* path, const EtalonSink* sink);

    /// Appends a PNG file of width * height RGB bytes in sRGB. Returns 0 after fail.
    int (*encode_png)(const std::uint8_t* rgb, int width, int height, const EtalonSink* sink);
};

/// The module's one symbol has this type and the name etalon_oiio.
using EtalonOiioEntry = const EtalonOiio* (*)();

}  // extern "C"

inline constexpr int etalon_oiio_version = 2;
