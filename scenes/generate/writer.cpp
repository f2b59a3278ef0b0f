#include "scenes/generate/writer.h"

#include <cerrno>
#include <iterator>
#include <system_error>
#include <utility>

// Adding zero turns -0 into 0.
template <>
struct fmt::formatter<etalon::Vec3> : fmt::formatter<double> {
    auto format(const etalon::Vec3& v, fmt::format_context& context) const {
        return fmt::format_to(context.out(), "{} {} {}", v.x + 0.0, v.y + 0.0, v.z + 0.0);
    }
};

template <>
struct fmt::formatter<etalon::Color> : fmt::formatter<float> {
    auto format(const etalon::Color& c, fmt::format_context& context) const {
        return fmt::format_to(context.out(), "{} {} {}", c.x, c.y, c.z);
    }
};

namespace etalon::generate {
namespace {

constexpr std::size_t chunk = std::size_t{1} << 16;

}  // namespace

template <class... T>
void Writer::line(fmt::format_string<T...> text, T&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), text, std::forward<T>(arguments)...);
    buffer_.push_back('\n');
    if (buffer_.size() >= chunk) flush();
}

void Writer::flush() {
    const std::size_t written = std::fwrite(buffer_.data(), 1, buffer_.size(), out_);
    if (written != buffer_.size() || std::fflush(out_) != 0) {
        throw std::system_error(errno, std::generic_category());
    }
    buffer_.clear();
}

void Writer::comment(std::string_view text) {
    line("# {}", text);
}

void Writer::background(const Color& color) {
    line("bclr {}", color);
}

void Writer::camera(const Camera& c) {
    line("camera\neye {}\nat {}\nup {}\nangle {}", c.eye, c.at, c.up, c.fov_degrees);
    line("hither 0\nresolution {} {}\naperture {}\nfocal {}", c.width, c.height, c.aperture,
         c.focal);
}

void Writer::light(const Vec3& position, const Color& color) {
    line("light punctual {} {}", position, color);
}

void Writer::material(const P3fMaterial& m) {
    line("mat {} {} {} {} {} {} {}", m.diffuse, m.kd, m.specular, m.ks, m.shine, m.transmission,
         m.ior);
}

void Writer::sphere(const Vec3& centre, double radius) {
    line("s {} {}", centre, radius);
}

void Writer::cone(const Vec3& base, double base_radius, const Vec3& top, double top_radius) {
    line("c {} {} {} {}", base, base_radius, top, top_radius);
}

void Writer::polygon(std::span<const Vec3> corners) {
    line("p {}", corners.size());
    for (const Vec3& corner : corners) line("{}", corner);
}

}  // namespace etalon::generate
