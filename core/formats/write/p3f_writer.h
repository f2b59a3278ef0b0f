// Writes the statements of a P3F scene (dialect of 2025) one by one, for etalon-scenes and for the
// conversion of scenes.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/formats/p3f/p3f_statement.h"
#include "core/formats/write/text.h"
#include "core/scene/camera.h"
#include "core/scene/shapes.h"

namespace etalon {

class P3fWriter {
  public:
    explicit P3fWriter(LineWriter::Sink sink) : text_(std::move(sink)) {}

    void comment(std::string_view text);
    void backend(std::string_view name);
    void samples(int per_pixel);
    void background(const Color& color);
    void skybox(std::string_view directory);
    void camera(const Camera& camera, const Imath::V2i& resolution);
    void light(const Vec3& position, const Color& color);
    void quad_light(const Vec3& corner, const Color& color, const Vec3& end1, const Vec3& end2,
                    int samples);
    void material(const P3fMaterial& material, bool absorbs = true);

    void sphere(const Vec3& centre, double radius);
    void cone(const Vec3& base, double base_radius, const Vec3& top, double top_radius);
    void box(const Vec3& min, const Vec3& max);
    void plane(const Vec3& a, const Vec3& b, const Vec3& c);
    void polygon(std::span<const Vec3> corners);  ///< at least 3, planar, concave or not
    void patch(std::span<const Vec3> corners, std::span<const Vec3> normals);
    /// Writes a mesh. Vertices are counted from 0 here, from 1 in the file.
    void mesh(std::span<const Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> faces);

    /// Flushes the output. This and all of the above pass on exceptions of the sink.
    void flush() { text_.flush(); }

  private:
    LineWriter text_;
};

}  // namespace etalon
