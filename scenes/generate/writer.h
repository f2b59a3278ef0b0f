// A P3F scene (dialect of 2025) written as it is generated: nothing but a small buffer is held, so
// a scene may be larger than memory. Numbers are the shortest that read back to the same value.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <span>
#include <string_view>

#include "core/numerics/vec.h"
#include "core/scene/camera.h"

namespace etalon::generate {

/// The eleven numbers of a `mat` line.
struct P3fMaterial {
    Color diffuse{1.0F};
    double kd = 1;
    Color specular{1.0F};
    double ks = 0;  ///< also the weight of the mirrored ray
    double shine = 1;
    double transmission = 0;  ///< 1 for glass
    double ior = 1;
};

class Writer {
  public:
    explicit Writer(std::FILE* out) : out_(out) {}

    void comment(std::string_view text);
    void background(const Color& color);
    void camera(const Camera& camera);
    void light(const Vec3& position, const Color& color);
    void material(const P3fMaterial& material);

    void sphere(const Vec3& centre, double radius);
    void cone(const Vec3& base, double base_radius, const Vec3& top, double top_radius);
    void polygon(std::span<const Vec3> corners);  ///< at least 3, planar, concave or not

    /// Hands everything to the file. This and all of the above throw std::system_error when the
    /// file cannot be written: a full disk ends the work at once.
    void flush();

  private:
    template <class... T>
    void line(fmt::format_string<T...> text, T&&... arguments);

    std::FILE* out_;
    fmt::memory_buffer buffer_;
};

}  // namespace etalon::generate
