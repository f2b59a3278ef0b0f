#include "core/light/infinite_light.h"

#include <algorithm>
#include <numbers>

#include "core/numerics/luminance.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Columns of the image by which directions to a skybox are chosen.
constexpr int overview_width = 512;

/// The inverse of a map whose columns are at right angles to each other, or any other.
Affine inverse_directions(const Affine& m) {
    const double d = m.determinant();
    const Vec3 a = m.y.cross(m.z) / d, b = m.z.cross(m.x) / d, c = m.x.cross(m.y) / d;
    return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, Vec3(0)};
}

/// Number of the first sum above `value`, and how far `value` is on the way there from the last.
std::pair<std::size_t, double> find_in(const double* first, std::size_t count, double value) {
    const double* found = std::upper_bound(first, first + count, value);
    auto i = std::min(static_cast<std::size_t>(found - first), count - 1);
    while (i > 0 && first[i] == first[i - 1]) --i;  // a cell of density 0 at the end
    const double before = i == 0 ? 0 : first[i - 1], size = first[i] - before;
    return {i, size > 0 ? std::clamp((value - before) / size, 0.0, 1 - 0x1p-53) : 0.5};
}

}  // namespace

InfiniteLight::InfiniteLight(const InfiniteSource& source, std::vector<std::string>& problems)
    : source_(source),
      to_world_(inverse_directions(source.to_light)),
      image_(source.image, problems),
      mean_(source.radiance) {
    if (source.skybox) {
        skybox_ = std::make_unique<SkyboxLight>(*source.skybox, source.decode_srgb, problems);
        image_ = skybox_->overview(overview_width, overview_width / 2);
        source_.radiance = Color(1.0F);
    }
    if (!image_.empty()) prepare_sampling();
}

Vec2 InfiniteLight::place_of(const Vec3& direction) const {
    return SphericalImage::place_of(normalized(source_.to_light.vector(direction)));
}

/// The light of a place that sample() has chosen.
Color InfiniteLight::lookup(const Vec2& place) const {
    if (skybox_) return skybox_->radiance(SphericalImage::direction_at(place));
    return image_.at(place) * source_.radiance;
}

Color InfiniteLight::radiance(const Vec3& direction) const {
    if (skybox_) return skybox_->radiance(direction);
    return image_.empty() ? source_.radiance : lookup(place_of(direction));
}

/// Densities: of each texel's cell the mean luminance of the texels about it, which a lookup in it
/// may show, less the mean of all, times the sine that makes a square of the sphere.
void InfiniteLight::prepare_sampling() {
    const int width = image_.width(), height = image_.height();
    std::vector<double> bright(static_cast<std::size_t>(width) * height);
    double sum = 0, weights = 0;
    Vec3 colors(0);
    for (int y = 0; y < height; ++y) {
        const double sine = std::sin(pi * (y + 0.5) / height);
        for (int x = 0; x < width; ++x) {
            double around = 0;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx)
                    around += luminance(image_.texel(x + dx, y + dy)) / 9;
            }
            bright[static_cast<std::size_t>(y) * width + x] = around;
            sum += sine * around;
            colors += sine * Vec3(image_.texel(x, y));
            weights += sine;
        }
    }
    mean_ = Color(colors / weights) * source_.radiance;
    const double mean = sum / weights;
    cells_.resize(bright.size());
    sums_.resize(bright.size());
    double total = 0;
    std::vector<double> row_sums(height);
    for (int y = 0; y < height; ++y) {
        const double sine = std::sin(pi * (y + 0.5) / height);
        double row = 0;
        for (int x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * width + x;
            cells_[i] = sine * std::max(0.0, bright[i] - mean);
            sums_[i] = row += cells_[i];
        }
        row_sums[y] = total += row;
    }
    // An image of one colour, up to roundings, is sampled by surfaces alone.
    if (!(total > 1e-6 * sum) || !std::isfinite(total)) return;
    row_sums_ = std::move(row_sums);
    const double cell_area = 1.0 / (static_cast<double>(width) * height);
    for (double& cell : cells_) cell /= total * cell_area;
}

LightSample InfiniteLight::sample(const Vec2& uv) const {
    LightSample s;
    s.at_infinity = true;
    if (row_sums_.empty()) return s;
    const auto width = static_cast<std::size_t>(image_.width());
    const auto [row, v] = find_in(row_sums_.data(), row_sums_.size(), uv.y * row_sums_.back());
    const double* cells = &sums_[row * width];
    const auto [column, u] = find_in(cells, width, uv.x * cells[width - 1]);
    const Vec2 place((static_cast<double>(column) + u) / image_.width(),
                     (static_cast<double>(row) + v) / image_.height());
    const double sine = std::sin(pi * place.y);
    s.wi = normalized(to_world_.vector(SphericalImage::direction_at(place)));
    s.pdf = static_cast<float>(cells_[row * width + column] / (2 * pi * pi * sine));
    s.radiance = lookup(place);
    return s;
}

double InfiniteLight::pdf(const Vec3& direction) const {
    if (row_sums_.empty()) return 0;
    const Vec2 place = place_of(direction);
    const int width = image_.width(), height = image_.height();
    const int x = std::min(static_cast<int>(place.x * width), width - 1);
    const int y = std::min(static_cast<int>(place.y * height), height - 1);
    const double sine = std::sin(pi * place.y);
    if (!(sine > 0)) return 0;
    return cells_[static_cast<std::size_t>(y) * width + x] / (2 * pi * pi * sine);
}

}  // namespace etalon
