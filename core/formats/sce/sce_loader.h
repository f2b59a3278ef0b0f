#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/file_scope.h"
#include "core/formats/load.h"
#include "core/formats/obj.h"
#include "core/formats/reader.h"
#include "core/formats/smooth_vertices.h"
#include "core/numerics/affine.h"

namespace etalon::sce {

/// Surface that the material commands set, at the course's own defaults.
struct Surface {
    Color ambient{0.1F}, diffuse{1.0F}, specular{0.0F};  ///< ca, cr, cp
    double shininess = 1;
};

/// State that a block restores: pop_matrix only the matrix, '}' all of it.
struct State {
    Affine matrix;
    Surface surface;
    std::optional<std::uint32_t> material;  ///< number of the surface, once a shape uses it
};

struct Block {
    bool braces;         ///< opened by '{', not by push_matrix
    std::size_t offset;  ///< place of its opening
    State outside;
};

/// Line of sight and upward direction, as given last.
struct View {
    Vec3 direction{0, 0, -1};
    std::size_t offset = 0;
};

struct MeshFile {
    ObjMesh mesh;
    std::string why;  ///< reason why there is no mesh; empty if there is one
};

/// State of reading an SCE file.
struct Loader {
    const LoadOptions& options;
    DiagnosticLog& log;
    std::filesystem::path directory;  ///< directory of the scene file
    FileScope scope{options.root};
    Scene scene{};
    SmoothVertices smooth_vertices{};
    RenderSettings settings{};
    State state{};
    std::vector<Block> blocks{};
    View view{};
    std::map<std::string, MeshFile> meshes{};  ///< mesh files by path

    Sides sides() const { return options.one_sided ? Sides::front : Sides::both; }

    /// Returns the number of the current surface in the scene's materials.
    std::uint32_t current_material();

    /// Returns whether a shape is possible under the current matrix; if not, reports why.
    bool has_usable_matrix(Reader& in) const;

    template <class Shape>
    void add(const Shape& shape) {
        scene.geometry.add(shape, current_material(), sides());
    }
};

using Handler = void (*)(Loader&, Reader&);

// One function for each command. It reads the arguments, whose number has been checked, and
// executes it.
void open_braces(Loader&, Reader&);
void close_braces(Loader&, Reader&);
void push_matrix(Loader&, Reader&);
void pop_matrix(Loader&, Reader&);
void rotate(Loader&, Reader&);
void translate(Loader&, Reader&);
void scale(Loader&, Reader&);

void read_ambient(Loader&, Reader&);
void read_diffuse(Loader&, Reader&);
void read_specular(Loader&, Reader&);
void read_shininess(Loader&, Reader&);

void read_ball(Loader&, Reader&);
void read_cylinder(Loader&, Reader&);
void read_triangle(Loader&, Reader&);
void read_flat_object(Loader&, Reader&);
void read_smooth_object(Loader&, Reader&);

void read_point_light(Loader&, Reader&);
void read_area_light(Loader&, Reader&);

void read_eye(Loader&, Reader&);
void read_direction(Loader&, Reader&);
void read_up(Loader&, Reader&);
void read_view_distance(Loader&, Reader&);
void read_field_of_view(Loader&, Reader&);
void read_width(Loader&, Reader&);
void read_height(Loader&, Reader&);
void read_recursion(Loader&, Reader&);
void read_samples(Loader&, Reader&);
void read_background(Loader&, Reader&);

/// Makes the scene's camera, or reports why nothing can be seen.
void finalize_camera(Loader&);

}  // namespace etalon::sce
