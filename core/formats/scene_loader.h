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

/// Material of objects before any material, where the format does not say.
Material default_diffuse();

/// Corners of the polygon being read, and their normals if it has some.
struct Corners {
    std::vector<Vec3> positions, normals;
};

/// A scene file being read: what the formats that grew from NFF have in common.
struct SceneLoader {
    Reader in;
    const LoadOptions& options;
    std::filesystem::path directory;  ///< directory of the scene file
    Material default_material = default_diffuse();
    Scene scene{};
    RenderSettings settings{};
    bool has_camera = false;
    std::optional<UnusableCamera> unusable_camera{};  ///< the first; an error if no other is good
    std::optional<std::uint32_t> material{};          ///< material of the objects to come
    std::vector<std::size_t> uncolored_lights{};      ///< lights that the file gives no colour
    Corners corners{};  ///< kept from one polygon to the next for their room
    SmoothVertices smooth_vertices{};
    std::size_t looks_ahead_at = 1 << 18;  ///< bytes of text before look_ahead()

    /// Sets the material of the objects to come, if such a surface can be; if not, says why.
    /// Returns whether it can.
    bool set_material(const Material& material);

    /// A white point light that the file says no more about. So that an image does not grow
    /// brighter with every one, n lights have an intensity of 1 / sqrt(n) (as PRT's program did).
    void add_light(const Vec3& position);

    /// The number of the current material. The first object may find none.
    std::uint32_t current_material();

    /// Returns the visible sides of a shape of the current material. The documents show only the
    /// front of opaque things; the formats' own programs show both sides.
    Sides sides();

    /// The same, but a negative radius shows only the inside of a shape.
    Sides sides_for(double radius) { return radius < 0 ? Sides::back : sides(); }

    template <class Shape>
    void add(const Shape& shape, Sides which) {
        scene.geometry.add(shape, current_material(), which);
        if (in.tokens().offset() >= looks_ahead_at) look_ahead();
    }

    /// Makes room for what the rest of the text holds if it goes on as it began.
    void look_ahead();

    /// The current statement's shape cannot be seen.
    void skip_degenerate(std::string_view why) {
        in.warn("degenerate", "'{}' left out: {}", in.keyword(), why);
    }

    /// The end of reading. Without any camera nothing can be rendered; beside a good one a bad one
    /// does no harm.
    LoadResult finish(DiagnosticLog& log);
};

// Statements that several formats have, by whichever keyword.
void read_background(SceneLoader&);  ///< colour
void read_sphere(SceneLoader&);      ///< centre, radius
void read_cone(SceneLoader&);        ///< base, base radius, apex, apex radius
void read_polygon(SceneLoader&);     ///< number of corners, corners
void read_patch(SceneLoader&);       ///< the same, a normal after each corner

}  // namespace etalon
