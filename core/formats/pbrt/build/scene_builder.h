// State of building a scene from a frame of a PBRT file: what the parts of the builder share.
#pragma once

#include <fmt/core.h>

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/formats/diagnostic_list.h"
#include "core/formats/load.h"
#include "core/formats/pbrt/build/bsdf_file.h"
#include "core/formats/pbrt/build/ply_files.h"
#include "core/formats/pbrt/frame.h"
#include "core/formats/pbrt/parse.h"
#include "core/numerics/affine.h"

namespace etalon::pbrt {

/// Position of something during the shutter interval.
struct PlaceInTime {
    Affine at_open;                           ///< when the shutter opens
    std::optional<AnimatedTransform> motion;  ///< its motion, if that is visible
};

struct SceneBuilder {
    const ParsedFile& file;
    const Frame& frame;
    bool strict;
    LoadResult& result;           ///< with a scene of a physical look
    std::string_view integrator;  ///< see LoadOptions

    PlyFiles ply_files{frame, strict};
    BsdfFiles bsdf_files{};
    DiagnosticList log{};                          ///< diagnostics of building
    std::vector<std::uint32_t> texture_numbers{};  ///< of the frame's textures, within their kind
    /// Numbers of the images of textures, by file, wrapping, decoding and scale.
    std::map<std::tuple<std::string, Wrap, bool, float>, std::uint32_t> image_numbers{};

    Scene& scene() { return *result.scene; }
    PhysicalLook& look() { return result.scene->physical(); }
    Geometry& geometry() { return result.scene->geometry; }

    /// Warns about a statement: what is left out, or what stands in for it.
    template <class... T>
    void warn(const FileLoc& loc, std::string_view kind, fmt::format_string<T...> text,
              T&&... arguments) {
        Diagnostic* const d = log.admit(strict ? Severity::error : Severity::warning, kind);
        if (!d) return;
        d->file = file.files[loc.file];
        d->line = loc.line;
        d->column = loc.column;
        d->message = fmt::format(text, std::forward<T>(arguments)...);
    }

    /// Records where an image is named, and what is shown if it cannot be read.
    void name_image(const std::string& image, const FileLoc& loc, std::string_view stand_in) {
        look().named_images.push_back(
            {image, fmt::format("{}:{}:{}", file.files[loc.file], loc.line, loc.column), stand_in});
    }

    /// Returns the value of a parameter, or the texture that is bound to it.
    ColorSlot color(const Parameters& p, std::string_view name);
    NumberSlot number(const Parameters& p, std::string_view name);

    /// Returns the map of a transform. Nothing, and a warning, if it is not affine.
    std::optional<Affine> affine(std::uint32_t transform, const FileLoc& loc);

    /// Returns the position of something that a pair of maps takes to the world.
    PlaceInTime place_in_time(const Affine& start, const Affine& end) const;
    std::optional<PlaceInTime> place_in_time(TransformPair pair, const FileLoc& loc);
};

/// Returns the affine part of a matrix.
Affine affine_part(const Matrix4& m);

/// Returns the inverse of a map, which must not be singular.
Affine inverse(const Affine& map);

/// Warns which other plugin stands in for one that is not rendered yet.
void warn_of_stand_in(SceneBuilder& b, const Plugin& plugin);

/// Returns how many samples a vertex takes of a light: the number that the light requests, if the
/// integrator honours it.
int light_samples(const SceneBuilder& b, const Parameters& light);

void build_settings(SceneBuilder& b);  ///< film, filter, sampler, integrator
void build_camera(SceneBuilder& b);    ///< needs the settings' resolution
void build_textures(SceneBuilder& b);
void build_materials(SceneBuilder& b);  ///< needs textures
void build_media(SceneBuilder& b);
void build_lights(SceneBuilder& b);
void build_shapes(SceneBuilder& b);  ///< needs materials

}  // namespace etalon::pbrt
