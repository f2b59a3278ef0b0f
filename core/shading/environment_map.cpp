#include "core/shading/environment_map.h"

#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"
#include "core/image/bilinear.h"
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

/// Returns the texel that the old programs take.
Color nearest(const CompactImage& face, const FacePoint& p, Encoding values) {
    const auto look_up = [&](const auto& image) {
        const int x = static_cast<int>((image.width - 1) * p.s);
        const int y = static_cast<int>((image.height - 1) * p.t);
        return converted(image.color(x, image.height - 1 - y), image.encoding, values);
    };
    return std::visit(look_up, face);
}

/// Returns whether a vector points to a place of the sky: one that is zero, infinite or no number
/// does not, nor does a ray with such a direction hit anything.
bool is_direction(const Vec3& v) {
    return is_finite(v) && v != Vec3(0);
}

/// Rays that look at one face, to be coloured together.
class FaceRays {
  public:
    bool is_full() const { return points_.is_full(); }

    void add(const CompactImage& face, const FacePoint& p, std::size_t ray) {
        rays_[points_.count] = ray;
        std::visit([&](const auto& image) { points_.add(image.width, image.height, p.s, 1 - p.t); },
                   face);
    }

    /// Sets the colours of the rays, which are no longer kept.
    void look_up(const CompactImage& face, Encoding values, std::span<Color> colors) {
        const auto interpolate_all = [&](const auto& image) {
            BilinearColors found;
            interpolate(image, points_, found);
            for (std::size_t i = 0; i < points_.count; ++i)
                colors[rays_[i]] = converted(found[i], image.encoding, values);
        };
        std::visit(interpolate_all, face);
        points_.count = 0;
    }

    bool is_empty() const { return points_.count == 0; }

  private:
    BilinearPoints points_;
    std::array<std::size_t, BilinearPoints::most> rays_;
};

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
    constexpr Hit missed{0, no_index};
    Color color;
    set_radiance({&direction.x, &direction.y, &direction.z}, {&missed, 1}, {&color, 1});
    return color;
}

void EnvironmentMap::set_radiance(const Vec3Span& directions, std::span<const Hit> hits,
                                  std::span<Color> colors) const {
    if (!has_skybox_) {
        std::ranges::fill(colors, environment_.background);
        return;
    }
    std::array<FaceRays, 6> faces;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (hits[i].primitive != no_index) continue;
        const Vec3 direction = directions[i];
        if (!is_direction(direction)) {
            colors[i] = environment_.background;
            continue;
        }
        const FacePoint p = face_point(direction);
        const CompactImage& face = faces_[p.face].get();
        if (environment_.skybox->nearest) {
            colors[i] = nearest(face, p, values_);
            continue;
        }
        faces[p.face].add(face, p, i);
        if (faces[p.face].is_full()) faces[p.face].look_up(face, values_, colors);
    }
    for (std::size_t k = 0; k < faces.size(); ++k) {
        if (!faces[k].is_empty()) faces[k].look_up(faces_[k].get(), values_, colors);
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
