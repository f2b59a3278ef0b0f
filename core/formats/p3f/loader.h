#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/formats/load.h"
#include "core/formats/reader.h"

namespace etalon::p3f {

struct UnusableCamera {
    std::size_t offset;
    std::string why;
};

/// A P3F file being read.
struct Loader {
    Reader in;
    const LoadOptions& options;
    std::filesystem::path directory;  ///< of the scene file
    Scene scene{};
    bool has_camera = false;
    std::optional<UnusableCamera> unusable_camera{};  ///< the first; an error if no other is good
    std::optional<std::uint32_t> material{};          ///< of the objects to come

    /// Of a shape that says nothing about it. Every picture made by the course's own programs
    /// shows both sides; its document has only the front visible.
    Sides sides() const { return options.one_sided ? Sides::front : Sides::both; }

    /// The number of the current material. The first object may find none: then it is a default.
    std::uint32_t current_material();
};

using Handler = void (*)(Loader&);

// One per kind of statement: reads what follows the keyword and adds it to the scene.
void read_accel(Loader&);
void read_samples(Loader&);
void read_background(Loader&);
void read_environment(Loader&);
void read_camera(Loader&);
void read_light(Loader&);
void read_point_light(Loader&);
void read_mat(Loader&);
void read_f(Loader&);
void read_sphere(Loader&);
void read_box(Loader&);
void read_plane(Loader&);
void read_hessian_plane(Loader&);
void read_cone(Loader&);
void read_polygon(Loader&);
void read_patch(Loader&);
void read_mesh(Loader&);
void skip_private_extension(Loader&);

}  // namespace etalon::p3f
