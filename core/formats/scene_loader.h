#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/load.h"
#include "core/formats/reader.h"
#include "core/formats/smooth_vertices.h"

namespace etalon {

struct UnusableCamera {
    std::size_t offset;
    std::string why;
};

/// Returns the material of objects that precede all materials, unless the format specifies one.
Material default_diffuse();

/// Corners of the polygon being read, and their normals if it has some.
struct Corners {
    std::vector<Vec3> positions, normals;
};

/// State of loading a scene file: what the formats that derive from NFF share.
struct SceneLoader {
    Reader in;
    const LoadOptions& options;
    std::filesystem::path directory;  ///< directory of the scene file
    Material default_material = default_diffuse();
    Scene scene{};
    RenderSettings settings{};
    bool has_camera = false;
    std::optional<UnusableCamera> unusable_camera{};  ///< the first; an error without a good one
    std::optional<std::uint32_t> material{};          ///< material of subsequent objects
    std::vector<std::size_t> uncolored_lights{};      ///< lights without a colour in the file
    Corners corners{};  ///< kept between polygons to reuse their memory
    SmoothVertices smooth_vertices{};
    std::size_t looks_ahead_at = 1 << 18;  ///< bytes of text before look_ahead()

    /// Sets the material of subsequent objects if it is valid; if not, reports why. Returns whether
    /// it is valid.
    bool set_material(const Material& material);

    /// Adds a white point light without further data. So that an image does not grow brighter with
    /// every one, n such lights have an intensity of 1 / sqrt(n), as in PRT's program.
    void add_light(const Vec3& position);

    /// Returns the number of the current material, making the default one if there is none.
    std::uint32_t current_material();

    /// Returns the visible sides of a shape of the current material. The formats' documents show
    /// only the front of opaque surfaces; their programs show both sides.
    Sides sides();

    /// The same, but a negative radius shows only the inside of a shape.
    Sides sides_for(double radius) { return radius < 0 ? Sides::back : sides(); }

    template <class Shape>
    void add(const Shape& shape, Sides which) {
        scene.geometry.add(shape, current_material(), which);
        if (in.tokens().offset() >= looks_ahead_at) look_ahead();
    }

    /// Reserves space for the rest of the text, assuming that it continues as it began.
    void look_ahead();

    /// Reports that the current statement's shape cannot be seen.
    void skip_degenerate(std::string_view why) {
        in.warn("degenerate", "'{}' left out: {}", in.keyword(), why);
    }

    /// Finishes loading. Without any camera nothing can be rendered; an unusable camera beside a
    /// good one does no harm.
    LoadResult finish(DiagnosticLog& log);
};

// Statements that several formats share, under different keywords.
void read_background(SceneLoader&);  ///< colour
void read_sphere(SceneLoader&);      ///< centre, radius
void read_cone(SceneLoader&);        ///< base, base radius, apex, apex radius
void read_polygon(SceneLoader&);     ///< number of corners, corners
void read_patch(SceneLoader&);       ///< the same, a normal after each corner

}  // namespace etalon
