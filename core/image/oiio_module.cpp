// The only file that includes OpenImageIO. It is a module of its own because an empty program
// linked to OpenImageIO loads some 260 libraries before main.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/announced_size.h"
#include "core/image/lack_of_memory.h"
#include "core/image/oiio_abi.h"

namespace {

constexpr int max_side = 65536;
constexpr int max_channels = 4;

/// Thrown when the sink gives up; it knows why.
struct Refused {};

[[noreturn]] void fail(const std::string& reason) {
    throw std::runtime_error(reason);
}

/// First bytes of the files of a format. OpenImageIO takes a PFM with other line ends for one whose
/// pixels begin a byte later: it has no reader here.
struct Signature {
    std::string_view start;
    std::string_view name;    ///< for messages
    std::string_view format;  ///< OpenImageIO's; empty if it reads these wrong
};
constexpr Signature signatures[] = {{"#?", "HDR", "hdr"},
                                    {"PF\n", "PFM", "pnm"},
                                    {"Pf\n", "PFM", "pnm"},
                                    {"\xff\xd8", "JPEG", "jpeg"},
                                    {"BM", "BMP", "bmp"},
                                    {"GIF8", "GIF", "gif"},
                                    {"RIFF", "WebP", "webp"},
                                    {{"II*\0", 4}, "TIFF", "tiff"},
                                    {{"MM\0*", 4}, "TIFF", "tiff"},
                                    {"8BPS", "PSD", "psd"},
                                    {"PF\r", "PFM", ""},
                                    {"Pf\r", "PFM", ""}};

std::string first_bytes(const char* path) {
    std::string bytes(etalon::announcement_size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

/// Returns the signature that a file begins with, or null if its format is unknown.
const Signature* signature_of(std::string_view start) {
    for (const Signature& s : signatures) {
        if (start.substr(0, s.start.size()) == s.start) return &s;
    }
    return nullptr;
}

/// Throws the reason why OpenImageIO cannot read a file, as its own messages are about internal
/// steps. `otherwise` is the reason if the format is unknown.
[[noreturn]] void fail_by_content(const Signature* signature, const char* otherwise) {
    if (signature == nullptr) fail(otherwise);
    fail("the " + std::string(signature->name) +
         " is damaged, cut short or of a kind not supported");
}

/// Throws if a file is too small for so many bytes of pixels.
void check_size(const char* path, const Signature* signature, std::int64_t bytes) {
    if (etalon::may_contain(path, bytes)) return;
    fail_by_content(signature, "the image is damaged or cut short");
}

/// Returns the bytes of an image or, if that is more, of one of its tiles.
std::int64_t bytes_of(const OIIO::ImageSpec& spec) {
    const std::int64_t width = std::max(spec.width, spec.tile_width);
    const std::int64_t height = std::max(spec.height, spec.tile_height);
    return width * height * spec.nchannels * static_cast<std::int64_t>(spec.format.size());
}

/// Runs `task` and catches whatever it throws.
template <class Task>
int guarded(const EtalonSink& sink, Task task) noexcept {
    try {
        task();
        return 1;
    } catch (const Refused&) {
    } catch (const std::bad_alloc&) {
        sink.fail(sink.context, etalon::lack_of_memory);
    } catch (const std::exception& e) {
        sink.fail(sink.context, e.what());
    }
    return 0;
}

void append(const EtalonSink& sink, const void* data, std::size_t size) {
    if (sink.append(sink.context, data, size) == 0) throw Refused();
}

/// Opens a file by the reader for what it begins with, or else for its name. No other is tried:
/// OpenImageIO would offer what one refuses to all that it has, those of films and raw photographs
/// too, which takes a hundred times as long and is more for a damaged file to break. Null if the
/// file cannot be opened.
std::unique_ptr<OIIO::ImageInput> open_by_kind(const char* path, const Signature* signature) {
    OIIO::attribute("try_all_readers", 0);
    OIIO::ImageSpec found, options;
    options["oiio:UnassociatedAlpha"] = 1;  // colours as stored, not multiplied by alpha
    auto input = OIIO::ImageInput::create(signature != nullptr ? signature->format : path);
    if (input && input->open(path, found, options)) return input;
    // What is not asked for is printed at the end.
    if (input) static_cast<void>(input->geterror());
    static_cast<void>(OIIO::geterror());
    return nullptr;
}

std::unique_ptr<OIIO::ImageInput> open(const char* path, const Signature* signature) {
    auto input = open_by_kind(path, signature);
    if (!input) {
        fail_by_content(signature, "it is not an image; expected EXR, PNG, JPEG, HDR or PFM");
    }
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.depth != 1 || spec.deep) fail("volumes and deep images are not supported");
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) fail("it has no pixels");
    if (std::max(spec.width, spec.height) > max_side) fail("larger than 65536 pixels");
    check_size(path, signature, bytes_of(spec));
    // OpenImageIO multiplies its colours by alpha, although they are asked for as stored.
    if (signature != nullptr && signature->format == "webp" && spec.nchannels > 3) {
        fail("a WebP with alpha is not supported");
    }
    return input;
}

/// Returns the order of the stored pixels, for formats that have it in their own header: Exif's is
/// for viewers of photographs. OpenImageIO 2.4 takes two orders of HDR for each other.
int orientation_of(const OIIO::ImageInput& input) {
    const std::string_view format = input.format_name();
    const int orientation = input.spec().get_int_attribute("Orientation", 1);
    if (format == "hdr" && (orientation == 6 || orientation == 8)) {
        fail("the order of its pixels is not supported; expected -Y +X");
    }
    return format == "hdr" || format == "tiff" ? orientation : 1;
}

/// Reads rows of the image into `rows`, a few at a time, so that memory grows with the file's
/// contents. Returns false if some are missing.
bool read_rows(OIIO::ImageInput& input, const EtalonImageFormat& format, const EtalonSink& sink) {
    const OIIO::ImageSpec& spec = input.spec();
    const OIIO::TypeDesc type = format.is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    const int step = spec.tile_height > 0 ? spec.tile_height : 64;
    const std::size_t row = type.size() * static_cast<std::size_t>(format.width * format.channels);
    std::vector<char> rows(row * static_cast<std::size_t>(std::min(step, format.height)));
    for (int y = 0; y < format.height; y += step) {
        const int count = std::min(step, format.height - y);
        const int y0 = spec.y + y, y1 = y0 + count, x1 = spec.x + spec.width;
        const bool read =
            spec.tile_height > 0
                ? input.read_tiles(0, 0, spec.x, x1, y0, y1, spec.z, spec.z + 1, 0, format.channels,
                                   type, rows.data())
                : input.read_scanlines(0, 0, y0, y1, spec.z, 0, format.channels, type, rows.data());
        if (!read) return false;
        append(sink, rows.data(), row * static_cast<std::size_t>(count));
    }
    // A JPEG that ends early is read as grey from there on, with only a warning.
    const std::string remark = input.geterror();
    return remark.find("Premature end") == std::string::npos;
}

int read(const char* path, int header_only, const EtalonSink* sink) {
    return guarded(*sink, [&] {
        const std::string start = first_bytes(path);
        const Signature* const signature = signature_of(start);
        check_size(path, signature, etalon::bytes_at_opening(start));
        const auto input = open(path, signature);
        const OIIO::ImageSpec& spec = input->spec();
        const EtalonImageFormat format{spec.width,
                                       spec.height,
                                       std::min(spec.nchannels, max_channels),
                                       spec.format != OIIO::TypeDesc::UINT8,
                                       !spec.format.is_floating_point(),
                                       orientation_of(*input)};
        if (sink->begin(sink->context, &format) == 0) throw Refused();
        if (header_only == 0 && !read_rows(*input, format, *sink)) {
            fail_by_content(signature, "the image is damaged or cut short");
        }
    });
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const EtalonOiio* etalon_oiio() {
    static constexpr EtalonOiio table = {etalon_oiio_version, read};
    return &table;
}
