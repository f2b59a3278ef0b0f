#include "scenes/generate/instances.h"

#include "scenes/generate/arithmetic.h"

namespace etalon::generate {
namespace {

/// Numbers of a point as text: the shortest that read back as the floats.
std::string text_of(const Vec3f& v) {
    return fmt::format("{} {} {}", v.x + 0.0F, v.y + 0.0F, v.z + 0.0F);
}

}  // namespace

void Mesh::add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::uint32_t first = add(a);
    add(b);
    add_face(first, first + 1, add(c));
}

void Mesh::add_prism(std::uint32_t sides, double low, double high, double low_radius,
                     double high_radius) {
    const auto first = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < sides; ++i) {
        const Vec2 at = on_circle(static_cast<double>(i) / sides);
        add({low_radius * at.x, low, low_radius * at.y});
        add({high_radius * at.x, high, high_radius * at.y});
    }
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % sides);
        if (high_radius > 0) add_face(a, a + 1, b + 1);
        add_face(a, b + 1, b);
    }
}

void Mesh::write(LineWriter& out) const {
    out.line("Shape \"trianglemesh\" \"point P\" [");
    for (const Vec3f& p : points_) out.line("{}", text_of(p));
    out.line("] \"integer indices\" [");
    for (const auto& [a, b, c] : faces_) out.line("{} {} {}", a, b, c);
    out.line("]");
}

void begin_world(LineWriter& out, const Vec3& eye, const Vec3& at, double fov_degrees) {
    out.line("Scale -1 1 1\nLookAt {}  {}  0 1 0", eye, at);
    out.line("Camera \"perspective\" \"float fov\" {}", fov_degrees);
    out.line("Film \"image\" \"integer xresolution\" 512 \"integer yresolution\" 512");
    out.line("Sampler \"halton\" \"integer pixelsamples\" 16");
    out.line("Integrator \"path\" \"integer maxdepth\" 4\nWorldBegin");
    out.line("LightSource \"infinite\" \"rgb L\" [0.5 0.6 0.75]");
    out.line("LightSource \"distant\" \"rgb L\" [2.4 2.2 1.8] \"point from\" [-2 3 1.5]");
}

void matte(LineWriter& out, const Color& color) {
    out.line("Material \"matte\" \"rgb Kd\" [{}]", color);
}

void write_instance(LineWriter& out, std::uint32_t object, const InstanceTransform& place) {
    out.line("Transform [{} 0 {} 0 {} 0 {} 1] ObjectInstance \"{}\"", text_of(Vec3f(place.x)),
             text_of(Vec3f(place.y)), text_of(Vec3f(place.z)), text_of(Vec3f(place.origin)),
             object);
}

void write_ground(LineWriter& out, double half) {
    matte(out, {0.3F, 0.27F, 0.2F});
    Mesh ground;
    for (const double x : {-half, half}) {
        for (const double z : {-half, half}) ground.add({x, 0, z});
    }
    ground.add_face(0, 1, 3);
    ground.add_face(0, 3, 2);
    ground.write(out);
}

}  // namespace etalon::generate
