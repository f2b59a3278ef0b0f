// Channels that `etalon render --aov` can write beside the colours.
#pragma once

#include <string>
#include <vector>

#include "core/image/rendered_image.h"
#include "core/render/features.h"

namespace etalon {

/// Returns why `name` is not an AOV; empty if it is one.
std::string check_aov(const std::string& name);

/// Returns the names of all AOVs.
std::vector<std::string> aov_names();

/// Returns whether one of them needs the variances of the film.
bool need_variance(const std::vector<std::string>& names);

/// Returns whether one of them needs the materials.
bool need_materials(const std::vector<std::string>& names);

/// Returns why the backend cannot produce all of them; empty if it can.
std::string check_aovs(const std::vector<std::string>& names, const Backend& backend);

/// Returns the bytes of memory of a pixel that making these takes.
double aov_bytes_per_pixel(const std::vector<std::string>& names);

/// A scene as it was rendered.
struct RenderedScene {
    const Scene& scene;
    const Intersector& intersector;
    const PhysicalShading* shading;  ///< see surface_means()
    const RenderSettings& settings;
    const Film& film;
};

/// Returns the channels of these, without duplicates, with as few rays as possible. The names of
/// those that a stop prevented are added to `missing`.
std::vector<Channel> make_aovs(const std::vector<std::string>& names, const RenderedScene& rendered,
                               const std::atomic<bool>& stop, std::vector<std::string>& missing);

}  // namespace etalon
