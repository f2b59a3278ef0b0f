#pragma once

#include <array>
#include <map>

#include "core/formats/camera_block.h"
#include "core/formats/scene_loader.h"

namespace etalon::prt {

/// An instance's contents for one surface in front of its statements.
struct DefinedObject {
    std::optional<std::uint32_t> object;    ///< among Geometry::objects; nothing if it is empty
    std::optional<std::uint32_t> material;  ///< material after the statements, if they set one
};

/// The statements of an instance.
struct Definition {
    std::string_view statements;
    bool inherits_surface;  ///< they have an object before any surface
    bool sets_surface;      ///< they have a surface
    /// Contents by the inherited material; no_index if none is inherited.
    std::map<std::uint32_t, DefinedObject> objects{};
};

/// Numbers of the materials of surfaces, by the text of the statement.
using KnownSurfaces = std::map<std::string_view, std::uint32_t>;

/// An instance that has not ended yet.
struct OpenDefinition {
    std::string_view name;
    std::size_t keyword;          ///< offset of the statement
    std::size_t first;            ///< offset of the statements
    int nested = 0;               ///< number of instances inside it, which are errors
    Geometry outer_geometry;      ///< the scene's, replaced by that of the definition
    std::size_t outer_materials;  ///< number of the scene's materials before it
    std::optional<std::uint32_t> outer_material;
    KnownSurfaces outer_surfaces;
};

/// State of reading a PRT file.
struct Loader : SceneLoader {
    std::string_view text;
    CameraBlock camera{};
    bool has_camera_lines = false;
    std::array<bool, 5> camera_lines{};  ///< which of from, at, up, angle, resolution were read
    std::map<std::string_view, Definition> definitions{};
    std::optional<OpenDefinition> open{};
    KnownSurfaces surfaces{};  ///< so that equal surfaces share a material
    std::size_t replayed = 0;  ///< bytes of statements that were read again
};

// One function for each kind of statement. It reads the values after the keyword and adds them to
// the scene.
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

/// Reads only the objects and surfaces of a text.
void read_objects(Loader&);
std::span<const std::string_view> object_names();

/// Handles the end of the file inside a definition.
void drop_open_definition(Loader&);

/// Handles the end of the file: makes the scene's camera.
void finalize_view(Loader&);

}  // namespace etalon::prt
