// The lights of a physical look: which one to sample at a point, and what it sends there.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/intersect/surface.h"
#include "core/light/area_light.h"
#include "core/light/infinite_light.h"
#include "core/light/light_sample.h"
#include "core/light/light_tree.h"
#include "core/light/lit_range.h"
#include "core/scene/scene.h"

namespace etalon {

class Lights {
  public:
    /// `scene` must outlive the lights. For `problems` see InfiniteLight. Primitives of kinds that
    /// cannot be sampled contribute only to the rays that hit them.
    Lights(const Scene& scene, std::vector<std::string>& problems,
           SkySampling sky_sampling = SkySampling::above_mean);

    bool empty() const { return sources_.empty(); }

    /// Returns whether rays can hit any of them.
    bool can_be_seen() const { return !area_lights_.empty() || !infinite_.empty(); }

    /// Returns the radius of a sphere around the scene's bounds.
    double scene_radius() const { return scene_radius_; }

    /// Returns the number of lights to pick from; the halves of a quadrilateral are one.
    std::size_t size() const { return sources_.size(); }

    /// Returns the number, among those, of a primitive that is part of an area light of the look.
    std::uint32_t number_of(std::uint32_t light, std::uint32_t primitive) const {
        return numbers_[primitive - number_offsets_[light]];
    }

    /// Picks a light by its unoccluded contribution to the point: if there are many, from a tree of
    /// bounds, beside which there are the lights at infinity. Nothing if none can shine there.
    std::optional<LightPick> pick(Receiver& at, double choice) const;

    /// Returns the probability with which pick() picked the light for the same receiver.
    double pick_probability(const Receiver& at, std::uint32_t light) const;

    /// Returns whether any light has a position but no extent.
    bool has_point_lights() const { return !point_lights_.empty(); }

    /// Returns the share of spotlights in the power of all lights.
    double power_share_of_spots() const;

    /// Picks a light without extent by its power.
    LightPick pick_point_light(double choice) const;

    /// Returns the probability with which pick_point_light() picks the light: 0 for other lights.
    double point_light_probability(std::uint32_t light) const;

    /// Returns the interval of a ray on which a light without extent shines: see lit_range().
    std::optional<Equiangular> lit_range(std::uint32_t light, const Vec3& origin,
                                         const Vec3& direction, double length) const {
        return etalon::lit_range(*sources_[light].light, origin, direction, length);
    }

    /// Returns how many samples a vertex takes of the light if all lights are sampled.
    int samples(std::uint32_t light) const { return sources_[light].samples; }

    /// Returns the sum of samples over all lights.
    std::size_t samples() const { return samples_; }

    /// Samples what the light may send to the point.
    LightSample sample(std::uint32_t light, const Vec3& from, const Vec2& uv) const;

    /// Returns the density per steradian with which sample() gives a point of an area light, seen
    /// from `from`.
    double pdf(std::uint32_t light, const Vec3& from, const SurfacePoint& at) const;

    /// Returns what an area light emits back along a ray that hit it.
    Color emitted(std::uint32_t light, const SurfacePoint& at, const Vec3& ray) const;

    /// Returns the numbers of the lights at infinity that rays can hit.
    const std::vector<std::uint32_t>& infinite() const { return infinite_; }
    const InfiniteLight& infinite_light(std::uint32_t light) const {
        return infinite_lights_[sources_[light].index];
    }

  private:
    struct Source {
        const PhysicalLight* light;
        std::uint32_t index;  ///< among the area or the infinite lights, or the images of others
        double power;
        int samples = 1;
    };

    static constexpr std::size_t most_by_importance = 16;

    void reserve_areas();
    void add(const PhysicalLight& light, std::vector<std::string>& problems,
             SkySampling sky_sampling);
    void add_areas(const PhysicalLight& light);
    Source area_source(const PhysicalLight& light, std::uint32_t primitive);
    Source infinite_source(const PhysicalLight& light, std::vector<std::string>& problems,
                           SkySampling sky_sampling);
    Source delta_source(const PhysicalLight& light, std::vector<std::string>& problems);
    std::uint32_t image_number(const std::string& file, std::vector<std::string>& problems);
    bool join_half(std::uint32_t primitive);
    LightSample sample_delta(const Source& source, const Vec3& from) const;
    double importance(const Source& source, const Receiver& at) const;
    LightBounds bounds_of(const Source& source) const;
    void make_tree();
    std::optional<LightPick> pick_from_tree(Receiver& at, double choice) const;

    const Scene& scene_;
    double scene_radius_;
    std::size_t samples_ = 0;
    std::vector<Source> sources_;
    std::vector<std::uint32_t> numbers_;  ///< of the primitives that are area lights
    std::vector<std::uint32_t>
        number_offsets_;  ///< by light; a primitive p has numbers_[p - offset]
    std::vector<AreaLight> area_lights_;
    std::vector<InfiniteLight> infinite_lights_;
    std::vector<SphericalImage> images_;                  ///< of goniometric lights and projectors
    std::map<std::string, std::uint32_t> image_numbers_;  ///< by file
    std::vector<std::uint32_t> infinite_;
    std::optional<LightTree> tree_;            ///< if there are too many lights to compare all
    std::vector<std::uint32_t> far_;           ///< lights at infinity, if there is a tree
    std::vector<std::uint32_t> point_lights_;  ///< lights with a position but no extent
    std::vector<double> point_power_sums_;
};

}  // namespace etalon
