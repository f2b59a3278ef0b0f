#include "core/image/oiio.h"

#include "core/image/lack_of_memory.h"
#include "core/image/oiio_loader.h"
#include "core/image/orientation.h"

namespace etalon {
namespace {

/// Collects what the module appends. No exception may reach the module.
struct Collector {
    Result<Image> result;
    int orientation = 1;

    static Collector& of(void* context) { return *static_cast<Collector*>(context); }

    static void fail(void* context, const char* reason) { of(context).result.error = reason; }

    template <class Step>
    int attempt(Step step) noexcept {
        try {
            step(result.value);
            return 1;
        } catch (const std::exception&) {
            result.error = lack_of_memory;
            return 0;
        }
    }
};

template <class Pixels>
Pixels room(const EtalonImageFormat& format) {
    Pixels pixels;
    pixels.reserve(static_cast<std::size_t>(format.width) * format.height * format.channels);
    return pixels;
}

int begin_image(void* context, const EtalonImageFormat* format) {
    Collector::of(context).orientation = format->orientation;
    return Collector::of(context).attempt([&](Image& image) {
        image = {format->width, format->height, format->channels, {}, {}, {}};
        if (format->is_srgb != 0) image.encoding = Encoding::srgb;
        if (format->is_float)
            image.pixels = room<std::vector<float>>(*format);
        else
            image.pixels = room<PixelBytes>(*format);
    });
}

int append_to_image(void* context, const void* data, std::size_t size) {
    return Collector::of(context).attempt([&](Image& image) {
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

Result<Image> read_oiio(const std::string& path, Extent extent) {
    const auto& module = load_oiio();
    if (!module) return {{}, module.error};
    Collector image;
    const EtalonSink sink{&image, begin_image, append_to_image, Collector::fail};
    const int header_only = extent == Extent::header ? 1 : 0;
    if (module.value->read(path.c_str(), header_only, &sink) == 0) return {{}, image.result.error};
    put_upright(image.result.value, image.orientation);
    return std::move(image.result);
}

}  // namespace etalon
