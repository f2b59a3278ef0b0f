#pragma once

#include <string>
#include <vector>

#include "core/material/material.h"

namespace etalon::test {

inline Roughness rough(float u, float v, bool remap = false) {
    return {{u}, {v}, remap};
}

/// Returns a point of a flat surface with the normal z, whose surface coordinates are x and y.
inline MaterialPoint flat_point(const Vec2& uv = {0.25, 0.5}) {
    return {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, uv, {uv.x, uv.y, 0}};
}

/// Returns the scattering of a material at the flat point; textures are constants.
inline Bsdf flat_scattering(const std::vector<PhysicalMaterial>& all,
                            const Vec2& uv = {0.25, 0.5}) {
    static const Textures none;
    std::vector<std::string> problems;
    return scattering(all.back(), all, TextureValues(none, problems), flat_point(uv));
}

template <class Kind>
Bsdf flat_scattering_of(const Kind& kind) {
    return flat_scattering({PhysicalMaterial{kind, {}}});
}

}  // namespace etalon::test
