#include "core/light/infinite_light.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "core/numerics/luminance.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Number of columns of the image from which directions to a skybox are sampled.
constexpr int overview_width = 512;

/// Number of cells of a sky's table that fit a second-level cache.
constexpr std::size_t enough_cells = 1 << 15;

/// Largest increase of noise by larger cells, which media amplify.
constexpr double most_moment = 1.05;

/// Returns the inverse of a map, fast if its columns are orthogonal.
Affine inverse_directions(const Affine& m) {
    const double d = m.determinant();
    const Vec3 a = m.y.cross(m.z) / d, b = m.z.cross(m.x) / d, c = m.x.cross(m.y) / d;
    return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, Vec3(0)};
}

/// Returns whether a map keeps the angles between vectors, up to roundings.
bool keeps_angles(const Affine& m) {
    const double size = m.x.dot(m.x), enough = 1e-12 * size;
    const auto is_next_to_0 = [&](double number) { return std::abs(number) <= enough; };
    return is_next_to_0(m.y.dot(m.y) - size) && is_next_to_0(m.z.dot(m.z) - size) &&
           is_next_to_0(m.x.dot(m.y)) && is_next_to_0(m.y.dot(m.z)) && is_next_to_0(m.z.dot(m.x));
}

/// Returns a texel, or black where it is infinite or no number: no sample with its light counts,
/// and directions to all the others are sampled as if it were not there.
Color finite_part(const Color& texel) {
    return is_finite(texel) ? texel : Color(0.0F);
}

/// Returns ninths of a row's luminances, from the column before the first to the one after the
/// last.
std::vector<float> ninths_of_row(const SphericalImage& image, int y) {
    std::vector<float> ninths;
    for (int x = -1; x <= image.width(); ++x) {
        ninths.push_back(luminance(finite_part(image.texel(x, y))) / 9);
    }
    return ninths;
}

/// Returns the mean luminance of each texel and its neighbours.
std::vector<double> blurred_luminances(const SphericalImage& image) {
    const auto width = static_cast<std::size_t>(image.width());
    std::vector<double> means(width * image.height());
    std::array<std::vector<float>, 3> rows{ninths_of_row(image, -1), ninths_of_row(image, 0), {}};
    for (int y = 0; y < image.height(); ++y) {
        rows[2] = ninths_of_row(image, y + 1);
        double* mean = &means[y * width];
        for (std::size_t x = 0; x < width; ++x) {
            for (const auto& row : rows) mean[x] = mean[x] + row[x] + row[x + 1] + row[x + 2];
        }
        std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    }
    return means;
}

}  // namespace

InfiniteLight::InfiniteLight(const InfiniteSource& source, std::vector<std::string>& problems,
                             SkySampling sampling)
    : source_(source),
      to_world_(inverse_directions(source.to_light)),
      keeps_angles_(keeps_angles(source.to_light)),
      image_(source.image, problems),
      mean_(source.radiance) {
    if (source.skybox) {
        skybox_ = std::make_unique<SkyboxLight>(*source.skybox, problems);
        image_ = skybox_->overview(overview_width, overview_width / 2);
        source_.radiance = Color(1.0F);
    }
    if (!image_.empty()) prepare_sampling(sampling);
}

Vec2 InfiniteLight::place_of(const Vec3& direction) const {
    return SphericalImage::place_of(normalized(source_.to_light.vector(direction)));
}

/// Returns the light at a point that sample() has chosen.
Color InfiniteLight::lookup(const Vec2& place) const {
    if (skybox_) return skybox_->radiance(SphericalImage::direction_at(place));
    return image_.at(place) * source_.radiance;
}

Color InfiniteLight::radiance(const Vec3& direction) const {
    if (skybox_) return skybox_->radiance(direction);
    return image_.empty() ? source_.radiance : lookup(place_of(direction));
}

/// Returns the densities. That of a texel's cell is the mean luminance of the texels around it,
/// which a look-up in the cell may use, optionally minus the mean of all, times the sine of the map
/// from the square to the sphere.
void InfiniteLight::prepare_sampling(SkySampling sampling) {
    const int width = image_.width(), height = image_.height();
    CellValues cells{width, height, blurred_luminances(image_)};
    double sum = 0, weights = 0;
    Vec3 colors(0);
    for (int y = 0; y < height; ++y) {
        const double sine = std::sin(pi * (y + 0.5) / height);
        for (int x = 0; x < width; ++x) {
            sum += sine * cells.values[static_cast<std::size_t>(y) * width + x];
            colors += sine * Vec3(finite_part(image_.texel(x, y)));
            weights += sine;
        }
    }
    mean_ = Color(colors / weights) * source_.radiance;
    const double left_out = sampling == SkySampling::above_mean ? sum / weights : 0;
    for (int y = 0; y < height; ++y) {
        const double sine = std::sin(pi * (y + 0.5) / height);
        double* const row = &cells.values[static_cast<std::size_t>(y) * width];
        for (int x = 0; x < width; ++x) row[x] = sine * std::max(0.0, row[x] - left_out);
    }
    if (sampling == SkySampling::whole) {
        cells = joined_cells(std::move(cells), enough_cells, most_moment);
    }
    PiecewiseConstant2D places(cells.width, cells.height, std::move(cells.values));
    // An image of one colour, up to roundings, is sampled by surfaces alone.
    if (places.sum() > 1e-6 * sum && std::isfinite(places.sum())) places_ = std::move(places);
}

LightSample InfiniteLight::sample(const Vec2& uv) const {
    LightSample s;
    s.at_infinity = true;
    if (places_.empty()) return s;
    const auto [place, density] = places_.sample(uv);
    const double sine = std::sin(pi * place.y);
    s.wi = normalized(to_world_.vector(SphericalImage::direction_at(place)));
    s.pdf = static_cast<float>(density / (2 * pi * pi * sine) * stretch(s.wi));
    s.radiance = lookup(place);
    return s;
}

double InfiniteLight::pdf(const Vec3& direction) const {
    if (places_.empty()) return 0;
    const Vec2 place = place_of(direction);
    const double sine = std::sin(pi * place.y);
    return sine > 0 ? places_.density(place) / (2 * pi * pi * sine) * stretch(direction) : 0;
}

/// Returns the solid angle in the image of a small one around a unit vector, relative to that.
double InfiniteLight::stretch(const Vec3& direction) const {
    if (keeps_angles_) return 1;
    const double length = source_.to_light.vector(direction).length();
    return std::abs(source_.to_light.determinant()) / (length * length * length);
}

}  // namespace etalon
