// Tables of images that other programs rendered, with the time of each: docs/convergence.md.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/numerics/vec.h"

namespace etalon::convergence {

/// An image of another program, or its errors. Paths are relative to this process's folder.
struct ForeignImage {
    std::string where;    ///< "TABLE:LINE", for messages
    std::string program;  ///< program that rendered it
    std::string scene;    ///< empty: any measured scene
    std::string reference;
    std::string image;       ///< empty if the errors are known
    double samples = 0;      ///< per pixel; 0 if unknown
    double cpu_seconds = 0;  ///< of the whole process
    Imath::V2i size{0, 0};   ///< in pixels; 0 if unknown
    double mse = unknown, relmse = unknown;

    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
};

/// Reads a table. A failure's reason begins with file, line and column.
Result<std::vector<ForeignImage>> read_foreign_table(const std::string& path);

/// Returns the images of a scene, whose file may be named differently in the table.
std::vector<ForeignImage> images_of(const std::vector<ForeignImage>& all, const std::string& scene);

/// Returns the files of all scenes that a table names, in its order.
std::vector<std::string> scenes_of(const std::vector<ForeignImage>& all);

/// Returns the reference image of a scene: that of its images in a table, else of the files beside
/// the scene with the scene's name and a number of samples, "scene-1024.exr", the one with the
/// largest number. Empty if there is neither.
std::string reference_for(const std::vector<ForeignImage>& images, const std::string& scene);

}  // namespace etalon::convergence
