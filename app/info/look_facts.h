#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

/// Facts about a scene's materials and lights, and about what its rendering needs.
struct LookFacts {
    std::size_t materials = 0;
    nlohmann::ordered_json lights = nlohmann::ordered_json::object();  ///< number of each kind
    nlohmann::ordered_json background{}, skybox{};  ///< null if the look has none
    std::vector<std::string> needs{};               ///< "reflected rays", "lens samples", ...

    void count_lights(std::string_view kind, std::uint32_t more);
    void need(bool condition, const char* what) {
        if (condition) needs.emplace_back(what);
    }
};

/// Returns the facts of the scene as rendered with these settings.
LookFacts facts_of(const Scene& scene, const RenderSettings& settings);

}  // namespace etalon
