// Textures: values that vary over a surface, as PBRT's scenes name them. Plain data.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/numerics/affine.h"
#include "core/scene/shapes.h"

namespace etalon {

/// A value, or the number of a texture of that type, which replaces the value.
template <class T>
struct Slot {
    T value{};
    std::uint32_t texture = no_index;
};

using ColorSlot = Slot<Color>;
using NumberSlot = Slot<float>;

/// Maps the surface's (u, v) to (u_scale u + u_offset, v_scale v + v_offset).
struct UvMapping {
    float u_scale = 1, v_scale = 1, u_offset = 0, v_offset = 0;
};

/// Maps a point, relative to the texture's origin, to its angles (theta / pi, phi / 2 pi).
struct SphericalMapping {
    Affine to_texture;
};

/// Maps a point to its angle about z, and z.
struct CylindricalMapping {
    Affine to_texture;
};

/// Maps a point p in world space to (u_offset + p.u_axis, v_offset + p.v_axis).
struct PlanarMapping {
    Vec3 u_axis{1, 0, 0}, v_axis{0, 1, 0};
    float u_offset = 0, v_offset = 0;
};

using Mapping = std::variant<UvMapping, SphericalMapping, CylindricalMapping, PlanarMapping>;

template <class T>
struct ConstantTexture {
    T value{};
};

template <class T>
struct ScaleTexture {
    Slot<T> a, b;
};

template <class T>
struct MixTexture {
    Slot<T> a, b;
    NumberSlot amount;  ///< 0 gives a, 1 gives b
};

template <class T>
struct BilinearTexture {
    Mapping mapping;
    T v00{}, v01{}, v10{}, v11{};
};

/// Values beyond the borders of an image.
enum class Wrap : std::uint8_t { repeat, black, clamp };

/// An image of image textures. A texture of numbers has its luminance.
struct TextureImage {
    std::string file;
    Wrap wrap = Wrap::repeat;
    bool decode_srgb = false;  ///< its values are sRGB-encoded
    float scale = 1;           ///< factor of its values, after decoding
};

template <class T>
struct ImageTexture {
    Mapping mapping;
    std::uint32_t image = 0;  ///< number among the look's images
};

template <class T>
struct Checkerboard2 {
    Mapping mapping;
    Slot<T> even, odd;
};

template <class T>
struct Checkerboard3 {
    Affine to_texture;
    Slot<T> even, odd;
};

/// Dots that cover about a third of the texture's area, like pbrt-v3's.
template <class T>
struct DotsTexture {
    Mapping mapping;
    Slot<T> dot, ground;
};

/// A sum of octaves of noise, each of about twice the frequency of the one before.
struct FractalNoise {
    int octaves = 8;
    float roughness = 0.5F;  ///< ratio of an octave's amplitude to that of the one before
};

/// Fractional Brownian motion: noise about 0.
struct FbmTexture {
    Affine to_texture;
    FractalNoise noise;
};

/// Turbulence: sharp valleys between round hills, above 0.
struct WrinkledTexture {
    Affine to_texture;
    FractalNoise noise;
};

/// Waves of water under a wind that varies from place to place.
struct WindyTexture {
    Affine to_texture;
};

/// Veins across the y axis. A texture of numbers has the colours' luminance.
struct MarbleTexture {
    Affine to_texture;
    FractalNoise noise;
    float scale = 1;         ///< factor of the point's coordinates
    float variation = 0.2F;  ///< factor of the noise, which displaces the veins
};

/// Shows u as red and v as green, both modulo 1.
struct UvTexture {
    Mapping mapping;
};

template <class T>
using Texture = std::variant<ConstantTexture<T>, ScaleTexture<T>, MixTexture<T>, BilinearTexture<T>,
                             ImageTexture<T>, Checkerboard2<T>, Checkerboard3<T>, DotsTexture<T>,
                             FbmTexture, WrinkledTexture, WindyTexture, MarbleTexture, UvTexture>;

/// All textures of a scene. A texture may refer only to earlier ones.
struct Textures {
    std::vector<Texture<float>> numbers;
    std::vector<Texture<Color>> colors;
    std::vector<TextureImage> images;
};

}  // namespace etalon
