#include "core/shading/environment_map.h"

#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"
#include "core/image/io.h"

namespace etalon {
namespace {

/// A point on a face: s to the right and t upwards, both in [0, 1].
struct FacePoint {
    std::size_t face;
    double s, t;
};

/// Returns where a direction meets the cube. Faces are in the order of Skybox::faces: right is -X,
/// left +X, top +Y, bottom -Y, front +Z, back -Z, each as seen from inside.
FacePoint face_point(const Vec3& d) {
    const Vec3 a = abs(d);
    const auto at = [](std::size_t face, double s, double t, double major) {
        return FacePoint{face, (s / major + 1) / 2, (t / major + 1) / 2};
    };
    if (a.x > a.y && a.x > a.z) return d.x > 0 ? at(1, d.z, d.y, a.x) : at(0, -d.z, d.y, a.x);
    if (a.y > a.z) return d.y > 0 ? at(2, -d.x, -d.z, a.y) : at(3, -d.x, d.z, a.y);
    return d.z > 0 ? at(4, -d.x, d.y, a.z) : at(5, d.x, d.y, a.z);
}

Color nearest_texel(const Image& image, const FacePoint& p) {
    const int x = static_cast<int>((image.width - 1) * p.s);
    const int y = static_cast<int>((image.height - 1) * p.t);
    return image.color(x, image.height - 1 - y);
}

/// Interpolates texels, which are sampled at their centres; beyond the outermost centres the edge
/// texel is repeated.
Color bilinear(const Image& image, const FacePoint& p) {
    const double x = std::clamp(p.s * image.width - 0.5, 0.0, image.width - 1.0);
    const double y = std::clamp((1 - p.t) * image.height - 0.5, 0.0, image.height - 1.0);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, image.width - 1), y1 = std::min(y0 + 1, image.height - 1);
    const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    return image.with_colors([&](const auto& color) {
        const Color top = color(x0, y0) * (1 - fx) + color(x1, y0) * fx;
        const Color bottom = color(x0, y1) * (1 - fx) + color(x1, y1) * fx;
        return top * (1 - fy) + bottom * fy;
    });
}

/// Returns an image of one colour, for a face whose file cannot be read.
Image image_of_color(const Color& c, Encoding encoding) {
    return {1, 1, 3, std::vector<float>{c.x, c.y, c.z}, encoding, {}};
}

/// Converts light to display values or display values to light, where the two differ.
Color converted(const Color& stored, Encoding from, Encoding to) {
    const bool is_light = from == Encoding::linear;
    if (is_light == (to == Encoding::linear)) return stored;
    const auto convert = [&](float value) {
        return static_cast<float>(is_light ? srgb_encoded(value) : srgb_decoded(value));
    };
    return {convert(stored.x), convert(stored.y), convert(stored.z)};
}

/// Returns whether a vector points to a place of the sky: one that is zero, infinite or no number
/// does not, nor does a ray with such a direction hit anything.
bool is_direction(const Vec3& v) {
    return is_finite(v) && v != Vec3(0);
}

}  // namespace

EnvironmentMap::EnvironmentMap(const Environment& environment, Encoding values,
                               std::vector<std::string>& problems)
    : environment_(environment), values_(values) {
    if (!environment.skybox) return;
    has_skybox_ = true;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
        const std::string& path = environment.skybox->faces[k];
        const Result<Image> header = read_image(path, Extent::header);
        if (!header) problems.push_back(header.error);
        has_skybox_ = has_skybox_ && header;
        faces_[k].choose(path, image_of_color(environment.background, values));
    }
}

Color EnvironmentMap::radiance(const Vec3& direction) const {
    if (!has_skybox_ || !is_direction(direction)) return environment_.background;
    const FacePoint p = face_point(direction);
    const Image& face = faces_[p.face].get();
    const Color stored = environment_.skybox->nearest ? nearest_texel(face, p) : bilinear(face, p);
    return converted(stored, face.encoding, values_);
}

void EnvironmentMap::set_radiance(const Vec3Span& directions, std::span<const Hit> hits,
                                  std::span<Color> colors) const {
    if (!has_skybox_) {
        std::ranges::fill(colors, environment_.background);
        return;
    }
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (hits[i].primitive == no_index) colors[i] = radiance(directions[i]);
    }
}

std::vector<std::string> EnvironmentMap::late_problems() const {
    std::vector<std::string> problems;
    for (const LazyImage& face : faces_) {
        const std::string problem = face.problem();
        if (!problem.empty()) problems.push_back(problem);
    }
    return problems;
}

}  // namespace etalon
