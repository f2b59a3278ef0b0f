#include "core/texture/difference_steps.h"

#include <algorithm>
#include <cmath>

#include "core/texture/fractal_noise.h"

namespace etalon {
namespace {

constexpr double of_texel = 1.0 / 4, of_noise_cell = 1.0 / 16;

/// Octaves after these have no steps of their own: heights are floats, whose roundings would show.
constexpr int most_octaves = 10;

/// Finds the steps of one texture from those of the textures that it refers to.
struct Finder {
    const std::vector<DifferenceSteps>& earlier;
    const std::vector<Texels>& images;

    DifferenceSteps operator()(const ScaleTexture<float>& t) const { return least(t.a, t.b); }
    DifferenceSteps operator()(const MixTexture<float>& t) const {
        const DifferenceSteps parts = least(t.a, t.b), amount = of(t.amount);
        return {std::min(parts.uv, amount.uv), std::min(parts.space, amount.space)};
    }
    DifferenceSteps operator()(const Checkerboard2<float>& t) const { return least(t.even, t.odd); }
    DifferenceSteps operator()(const Checkerboard3<float>& t) const { return least(t.even, t.odd); }
    DifferenceSteps operator()(const DotsTexture<float>& t) const { return least(t.dot, t.ground); }

    DifferenceSteps operator()(const ImageTexture<float>& t) const {
        const Vec2 texel = Vec2(of_texel) / Vec2(images[t.image].size());
        return std::visit([&](const auto& mapping) { return mapped(mapping, texel); }, t.mapping);
    }

    DifferenceSteps operator()(const FbmTexture& t) const { return noise(t, t.noise.octaves); }
    DifferenceSteps operator()(const WrinkledTexture& t) const { return noise(t, t.noise.octaves); }
    DifferenceSteps operator()(const WindyTexture& t) const { return noise(t, windy_octaves); }
    DifferenceSteps operator()(const MarbleTexture& t) const {
        const DifferenceSteps unscaled = noise(t, t.noise.octaves);
        return {infinity, unscaled.space / std::abs(t.scale)};
    }

    /// Constants, and textures whose slopes are even.
    template <class Other>
    DifferenceSteps operator()(const Other&) const {
        return {};
    }

  private:
    DifferenceSteps of(const NumberSlot& slot) const {
        return slot.texture == no_index ? DifferenceSteps{} : earlier[slot.texture];
    }

    DifferenceSteps least(const NumberSlot& a, const NumberSlot& b) const {
        const DifferenceSteps of_a = of(a), of_b = of(b);
        return {std::min(of_a.uv, of_b.uv), std::min(of_a.space, of_b.space)};
    }

    static DifferenceSteps mapped(const UvMapping& m, const Vec2& texel) {
        return {std::min(texel.x / std::abs(m.u_scale), texel.y / std::abs(m.v_scale)), infinity};
    }
    static DifferenceSteps mapped(const PlanarMapping& m, const Vec2& texel) {
        return {infinity, std::min(texel.x / m.u_axis.length(), texel.y / m.v_axis.length())};
    }
    /// The size of a texel depends on the distance from the texture's origin.
    template <class Angular>
    static DifferenceSteps mapped(const Angular&, const Vec2&) {
        return {};
    }

    template <class Noise>
    static DifferenceSteps noise(const Noise& t, int octaves) {
        const Affine& m = t.to_texture;
        const double scale = std::max({m.x.length(), m.y.length(), m.z.length()});
        const double finest = std::pow(lacunarity, std::clamp(octaves, 1, most_octaves) - 1);
        return {infinity, of_noise_cell / (scale * finest)};
    }
};

}  // namespace

std::vector<DifferenceSteps> difference_steps(const Textures& textures,
                                              const std::vector<Texels>& images) {
    std::vector<DifferenceSteps> steps;
    for (const Texture<float>& texture : textures.numbers) {
        steps.push_back(std::visit(Finder{steps, images}, texture));
    }
    return steps;
}

}  // namespace etalon
