#include "core/light/skybox_light.h"

namespace etalon {

SkyboxLight::SkyboxLight(const Environment& skybox, std::vector<std::string>& problems)
    : map_(skybox, Encoding::linear, problems) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        map_.radiance(axis);  // reads the face
        map_.radiance(-axis);
    }
    for (std::string& problem : map_.late_problems()) problems.push_back(std::move(problem));
}

SphericalImage SkyboxLight::overview(int width, int height) const {
    constexpr int parts = 2;
    std::vector<Color> texels;
    texels.reserve(static_cast<std::size_t>(width) * height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Color sum(0.0F);
            for (int k = 0; k < parts * parts; ++k) {
                const int column = k % parts, row = k / parts;
                const Vec2 place((x + (column + 0.5) / parts) / width,
                                 (y + (row + 0.5) / parts) / height);
                sum += radiance(SphericalImage::direction_at(place));
            }
            texels.push_back(sum / (parts * parts));
        }
    }
    return {width, height, std::move(texels)};
}

}  // namespace etalon
