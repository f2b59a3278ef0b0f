#pragma once

#include <string>
#include <vector>

#include "core/diffusion/subsurface.h"

namespace etalon::test {

struct ProfileCase {
    std::string name;
    SpreadProfile profile;
    Color albedo;  ///< fraction of the light that leaves
};

/// Returns a profile whose numbers in pbrt-v3 are known.
inline TabulatedProfile tabulated() {
    static const DiffusionTable table(0.3F, 1.4F);
    return {table, {0.1F, 0.5F, 2}, {5, 4, 3}};
}

inline std::vector<ProfileCase> profiles() {
    const Color albedo(0.9F, 0.5F, 0.2F);
    return {{"tabulated",
             tabulated(),
             {0.2045176F / 0.4570518F, 0.1003663F / 0.5676047F, 0.02241803F / 0.4858985F}},
            {"normalized", NormalizedProfile(albedo, {3, 1, 0.2F}), albedo}};
}

}  // namespace etalon::test
