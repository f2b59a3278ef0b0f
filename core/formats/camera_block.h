// The cameras of NFF and its descendants.
#pragma once

#include <cstdint>
#include <string>

#include "core/formats/scene_loader.h"

namespace etalon {

/// Range of the distance of a camera's eye from the point it looks at, in which squares of a
/// scene's lengths keep all their digits.
inline constexpr double least_camera_distance = 1e-150, largest_camera_distance = 1e150;

/// A camera block that is being read.
struct CameraBlock {
    std::size_t start = 0;  ///< start of the statement, for diagnostics
    Camera camera{};
    std::int64_t width = 0, height = 0;
};

void read_resolution(Reader& in, CameraBlock& block);

/// Makes the block the scene's camera, or reports why nothing can be seen with it. `missing` names
/// the parts that it lacks.
void finalize_camera(SceneLoader& loader, CameraBlock block, const std::string& missing);

/// Dialects of the camera: NFF's is a block of lines that each start with a word of their own;
/// P3F's has a lens, and a new word for `from`.
enum class CameraDialect : std::uint8_t { nff, p3f };

void read_camera_block(SceneLoader& loader, CameraDialect dialect);

}  // namespace etalon
