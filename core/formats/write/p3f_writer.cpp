#include "core/formats/write/p3f_writer.h"

namespace etalon {

void P3fWriter::comment(std::string_view text) {
    text_.line("# {}", text);
}

void P3fWriter::backend(std::string_view name) {
    text_.line("accel {}", name);
}

void P3fWriter::samples(int per_pixel) {
    text_.line("spp {}", per_pixel);
}

void P3fWriter::background(const Color& color) {
    text_.line("bclr {}", color);
}

void P3fWriter::skybox(std::string_view directory) {
    text_.line("env {}", directory);
}

void P3fWriter::camera(const Camera& c, const Imath::V2i& resolution) {
    text_.line("camera\neye {}\nat {}\nup {}\nangle {}", c.eye, c.at, c.up, c.fov_degrees);
    text_.line("hither 0\nresolution {} {}\naperture {}\nfocal {}", resolution.x, resolution.y,
               c.aperture, c.focal);
}

void P3fWriter::light(const Vec3& position, const Color& color) {
    text_.line("light punctual {} {}", position, color);
}

void P3fWriter::quad_light(const Vec3& corner, const Color& color, const Vec3& end1,
                           const Vec3& end2, int samples) {
    text_.line("light quad {} {} {} {} {}", corner, color, end1, end2, samples);
}

void P3fWriter::material(const P3fMaterial& m, bool absorbs) {
    text_.line("{} {} {} {} {} {} {} {}", absorbs ? "mat" : "f", m.diffuse, m.kd, m.specular, m.ks,
               m.shine, m.transmission, m.ior);
}

void P3fWriter::sphere(const Vec3& centre, double radius) {
    text_.line("s {} {}", centre, radius);
}

void P3fWriter::cone(const Vec3& base, double base_radius, const Vec3& top, double top_radius) {
    text_.line("c {} {} {} {}", base, base_radius, top, top_radius);
}

void P3fWriter::box(const Vec3& min, const Vec3& max) {
    text_.line("box {} {}", min, max);
}

void P3fWriter::plane(const Vec3& a, const Vec3& b, const Vec3& c) {
    text_.line("pl {} {} {}", a, b, c);
}

void P3fWriter::polygon(std::span<const Vec3> corners) {
    text_.line("p {}", corners.size());
    for (const Vec3& corner : corners) text_.line("{}", corner);
}

void P3fWriter::patch(std::span<const Vec3> corners, std::span<const Vec3> normals) {
    text_.line("pp {}", corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) text_.line("{} {}", corners[i], normals[i]);
}

void P3fWriter::mesh(std::span<const Vec3> vertices,
                     std::span<const std::array<std::uint32_t, 3>> faces) {
    text_.line("mesh {} {}", vertices.size(), faces.size());
    for (const Vec3& v : vertices) text_.line("{}", v);
    for (const auto& [a, b, c] : faces) text_.line("{} {} {}", a + 1, b + 1, c + 1);
}

}  // namespace etalon
