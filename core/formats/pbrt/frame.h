// A frame of a PBRT v3 file: the part between two WorldEnd statements, with all names resolved. It
// has the statements of the file, not yet geometry or a scene.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "core/formats/pbrt/matrix4.h"
#include "core/formats/pbrt/parameters.h"
#include "core/formats/pbrt/transform_list.h"

namespace etalon::pbrt {

inline constexpr std::uint32_t none = 0xFFFFFFFFU;  ///< number that refers to nothing

/// Numbers, in Frame::transforms, of a transform at the two times of TransformTimes.
struct TransformPair {
    std::uint32_t start = 0, end = 0;

    bool is_animated() const { return start != end; }
    bool operator==(const TransformPair&) const = default;
};

/// A texture; its category tells float from spectrum.
struct Texture {
    Plugin plugin;
    std::uint32_t to_world;  ///< number in Frame::transforms, for 3-D mappings
};

/// A material, with the values by which a shape may have replaced its own.
struct Material {
    Plugin plugin;
    std::array<std::uint32_t, 2> mixed = {none, none};  ///< materials of a "mix"
};

struct MediumInterface {
    std::uint32_t inside = none, outside = none;  ///< numbers in Frame::media

    bool operator==(const MediumInterface&) const = default;
};

struct Light {
    Plugin plugin;
    std::uint32_t to_world;       ///< number in Frame::transforms
    std::uint32_t medium = none;  ///< number of the medium around it
};

struct Medium {
    std::string name;
    Plugin plugin;
    std::uint32_t to_world;  ///< number in Frame::transforms
};

struct Shape {
    Plugin plugin;
    TransformPair to_world;
    std::uint32_t material;           ///< "none" is a material too
    std::uint32_t area_light = none;  ///< number in Frame::area_lights
    MediumInterface media;
    bool reverse_orientation = false;
};

/// Shapes that are seen only as instances. Their transforms are applied before the instance's.
struct Object {
    std::string name;  ///< not unique: a later object may have the same name
    std::vector<Shape> shapes;
};

struct Instance {
    std::uint32_t object;
    TransformPair to_world;
    FileLoc where;
};

struct CameraTransform {
    Matrix4 to_world, from_world;  ///< inverse of each other
};

struct Frame {
    Plugin camera, sampler, film, filter, integrator, accelerator;  ///< defaults if absent
    std::array<CameraTransform, 2> camera_transforms{};             ///< at the start and end time
    std::uint32_t camera_medium = none;
    std::array<double, 2> transform_times = {0, 1};

    /// Transforms of the world block, each finite but not always invertible; 0 is the identity.
    TransformList transforms{};
    std::vector<Texture> textures{};
    std::vector<Material> materials{};  ///< no two are equal
    std::vector<Light> lights{};
    std::vector<Plugin> area_lights{};
    std::vector<Medium> media{};
    std::vector<Shape> shapes{};
    std::vector<Object> objects{};
    std::deque<Instance> instances{};  ///< may be millions: see TransformList
    bool has_media = false;            ///< whether a MediumInterface statement was read

    /// Makes a frame of default options and an empty world.
    Frame();
};

}  // namespace etalon::pbrt
