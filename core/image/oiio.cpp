#include "core/image/oiio.h"

#include "core/image/oiio_loader.h"

namespace etalon {
namespace {

/// Collects what the module appends. It must let nothing be thrown into the module.
template <class Value>
struct Collector {
    Result<Value> result;

    static Collector& of(void* context) { return *static_cast<Collector*>(context); }

    static void fail(void* context, const char* reason) { of(context).result.error = reason; }

    template <class Step>
    int attempt(Step step) noexcept {
        try {
            step(result.value);
            return 1;
        } catch (const std::exception&) {
            result.error = "not enough memory";
            return 0;
        }
    }
};

using FileCollector = Collector<std::string>;
using ImageCollector = Collector<Image>;

int append_to_file(void* context, const void* data, std::size_t size) {
    return FileCollector::of(context).attempt(
        [&](std::string& file) { file.append(static_cast<const char*>(data), size); });
}

template <class T>
std::vector<T> room(const EtalonImageFormat& format) {
    std::vector<T> pixels;
    pixels.reserve(static_cast<std::size_t>(format.width) * format.height * format.channels);
    return pixels;
}

int begin_image(void* context, const EtalonImageFormat* format) {
    return ImageCollector::of(context).attempt([&](Image& image) {
        image = {format->width, format->height, format->channels, {}, {}, {}};
        if (format->is_srgb != 0) image.encoding = Encoding::srgb;
        if (format->is_float)
            image.pixels = room<float>(*format);
        else
            image.pixels = room<std::uint8_t>(*format);
    });
}

int append_to_image(void* context, const void* data, std::size_t size) {
    return ImageCollector::of(context).attempt([&](Image& image) {
        std::visit(
            [&](auto& pixels) {
                using T = typename std::decay_t<decltype(pixels)>::value_type;
                const auto* first = static_cast<const T*>(data);
                pixels.insert(pixels.end(), first, first + size / sizeof(T));
            },
            image.pixels);
    });
}

}  // namespace

Result<Image> read_oiio(const std::string& path) {
    const auto& module = load_oiio();
    if (!module) return {{}, path + ": cannot be read: " + module.error};
    ImageCollector image;
    const EtalonSink sink{&image, begin_image, append_to_image, ImageCollector::fail};
    if (module.value->read(path.c_str(), &sink) != 0) return std::move(image.result);
    return {{}, path + ": cannot be read: " + image.result.error};
}

Result<std::string> encode_png(std::span<const std::uint8_t> rgb, int width, int height) {
    const auto& module = load_oiio();
    if (!module) return {{}, module.error};
    FileCollector file;
    const EtalonSink sink{&file, nullptr, append_to_file, FileCollector::fail};
    module.value->encode_png(rgb.data(), width, height, &sink);
    return std::move(file.result);
}

}  // namespace etalon
