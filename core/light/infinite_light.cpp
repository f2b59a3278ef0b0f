#include "core/light/infinite_light.h"

#include <algorithm>
#include <numbers>

#include "core/image/io.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

double luminance(const Color& c) {
    return 0.212671 * c.x + 0.715160 * c.y + 0.072169 * c.z;
}

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
    : source_(source), to_world_(inverse_directions(source.to_light)), mean_(source.radiance) {
    if (source.image.empty()) return;
    const Result<Image> image = read_image(source.image);
    if (!image) {
        problems.push_back(image.error);
        return;
    }
    width_ = image.value.width;
    height_ = image.value.height;
    texels_ = linear_pixels(image.value);
    for (Color& texel : texels_) texel *= source.radiance;
    prepare_sampling();
}

Color InfiniteLight::texel(int x, int y) const {
    x = (x % width_ + width_) % width_;
    y = (y % height_ + height_) % height_;
    return texels_[static_cast<std::size_t>(y) * width_ + x];
}

Color InfiniteLight::lookup(const Vec2& place) const {
    const double x = place.x * width_ - 0.5, y = place.y * height_ - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    const auto i = static_cast<int>(left), j = static_cast<int>(top);
    const auto u = static_cast<float>(x - left), v = static_cast<float>(y - top);
    return (1 - v) * ((1 - u) * texel(i, j) + u * texel(i + 1, j)) +
           v * ((1 - u) * texel(i, j + 1) + u * texel(i + 1, j + 1));
}

Vec2 InfiniteLight::place_of(const Vec3& direction) const {
    const Vec3 d = normalized(source_.to_light.vector(direction));
    const double phi = std::atan2(d.y, d.x);
    return {(phi < 0 ? phi + 2 * pi : phi) / (2 * pi), std::atan2(std::hypot(d.x, d.y), d.z) / pi};
}

Color InfiniteLight::radiance(const Vec3& direction) const {
    return texels_.empty() ? source_.radiance : lookup(place_of(direction));
}

/// Densities: of each texel's cell the mean luminance of the texels about it, which a lookup in it
/// may show, less the mean of all, times the sine that makes a square of the sphere.
void InfiniteLight::prepare_sampling() {
    std::vector<double> bright(texels_.size());
    double sum = 0, weights = 0;
    Vec3 colors(0);
    for (int y = 0; y < height_; ++y) {
        const double sine = std::sin(pi * (y + 0.5) / height_);
        for (int x = 0; x < width_; ++x) {
            double around = 0;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) around += luminance(texel(x + dx, y + dy)) / 9;
            }
            bright[static_cast<std::size_t>(y) * width_ + x] = around;
            sum += sine * around;
            colors += sine * Vec3(texel(x, y));
            weights += sine;
        }
    }
    mean_ = Color(colors / weights);
    const double mean = sum / weights;
    cells_.resize(bright.size());
    sums_.resize(bright.size());
    double total = 0;
    std::vector<double> row_sums(height_);
    for (int y = 0; y < height_; ++y) {
        const double sine = std::sin(pi * (y + 0.5) / height_);
        double row = 0;
        for (int x = 0; x < width_; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * width_ + x;
            cells_[i] = sine * std::max(0.0, bright[i] - mean);
            sums_[i] = row += cells_[i];
        }
        row_sums[y] = total += row;
    }
    // An image of one colour, up to roundings, is sampled by surfaces alone.
    if (!(total > 1e-6 * sum) || !std::isfinite(total)) return;
    row_sums_ = std::move(row_sums);
    const double cell_area = 1.0 / (static_cast<double>(width_) * height_);
    for (double& cell : cells_) cell /= total * cell_area;
}

LightSample InfiniteLight::sample(const Vec2& uv) const {
    LightSample s;
    s.at_infinity = true;
    if (row_sums_.empty()) return s;
    const auto [row, v] = find_in(row_sums_.data(), row_sums_.size(), uv.y * row_sums_.back());
    const double* cells = &sums_[row * width_];
    const auto [column, u] = find_in(cells, width_, uv.x * cells[width_ - 1]);
    const Vec2 place((static_cast<double>(column) + u) / width_,
                     (static_cast<double>(row) + v) / height_);
    const double theta = pi * place.y, phi = 2 * pi * place.x, sine = std::sin(theta);
    s.wi =
        normalized(to_world_.vector({sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)}));
    s.pdf = static_cast<float>(cells_[row * width_ + column] / (2 * pi * pi * sine));
    s.radiance = lookup(place);
    return s;
}

double InfiniteLight::pdf(const Vec3& direction) const {
    if (row_sums_.empty()) return 0;
    const Vec2 place = place_of(direction);
    const int x = std::min(static_cast<int>(place.x * width_), width_ - 1);
    const int y = std::min(static_cast<int>(place.y * height_), height_ - 1);
    const double sine = std::sin(pi * place.y);
    if (!(sine > 0)) return 0;
    return cells_[static_cast<std::size_t>(y) * width_ + x] / (2 * pi * pi * sine);
}

}  // namespace etalon
