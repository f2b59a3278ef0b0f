#pragma once

#include <array>
#include <map>

#include "core/formats/camera_block.h"
#include "core/formats/scene_loader.h"

namespace etalon::prt {

/// What the statements of an instance come to for one surface in front of them.
struct DefinedObject {
    std::optional<std::uint32_t> object;    ///< among Geometry::objects, unless nothing is in it
    std::optional<std::uint32_t> material;  ///< that they leave behind, if they have one
};

/// The statements of an instance.
struct Definition {
    std::string_view statements;
    bool inherits_surface;  ///< whether they have an object before any surface
    bool sets_surface;      ///< whether they have a surface
    /// By the material that is inherited; no_index if none is.
    std::map<std::uint32_t, DefinedObject> objects{};
};

/// The numbers of the materials that surfaces have made, by the text of the statement.
using KnownSurfaces = std::map<std::string_view, std::uint32_t>;

/// An instance whose end has not come yet.
struct OpenDefinition {
    std::string_view name;
    std::size_t keyword;          ///< offset of the statement
    std::size_t first;            ///< offset of the statements
    int nested = 0;               ///< instances inside it, which are errors
    Geometry outer_geometry;      ///< the scene's, whose place that of the definition takes
    std::size_t outer_materials;  ///< how many the scene had
    std::optional<std::uint32_t> outer_material;
    KnownSurfaces outer_surfaces;
};

/// A PRT file being read.
struct Loader : SceneLoader {
    std::string_view text;
    CameraBlock camera{};
    bool has_camera_lines = false;
    std::array<bool, 5> camera_lines{};  ///< those of from, at, up, angle, resolution so far
    std::map<std::string_view, Definition> definitions{};
    std::optional<OpenDefinition> open{};
    KnownSurfaces surfaces{};  ///< so that the same surface makes the same material
    std::size_t replayed = 0;  ///< bytes of statements
};

// One per kind of statement: reads what follows the keyword and adds it to the scene.
void read_from(Loader&);
void read_at(Loader&);
void read_up(Loader&);
void read_angle(Loader&);
void read_resolution(Loader&);
void read_light(Loader&);
void read_background(Loader&);
void read_surface(Loader&);
void read_hollow_sphere(Loader&);
void read_ring(Loader&);
void read_quadric(Loader&);
void read_instance(Loader&);
void read_end_instance(Loader&);
void read_instance_of(Loader&);

/// Reads the objects and surfaces of a text, and nothing else; and their keywords.
void read_objects(Loader&);
std::span<const std::string_view> object_names();

/// The end of the file inside a definition.
void drop_open_definition(Loader&);

/// The end of the file: what was read of the camera becomes the scene's.
void finalize_view(Loader&);

}  // namespace etalon::prt
