// The lights of a physical look: which to ask at a point, and what reaches it from there.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/intersect/surface.h"
#include "core/light/area_shape.h"
#include "core/light/infinite_light.h"
#include "core/light/light_sample.h"
#include "core/light/light_tree.h"
#include "core/light/lit_range.h"
#include "core/scene/scene.h"

namespace etalon {

class Lights {
  public:
    /// `scene` must outlive the lights. `problems`: see InfiniteLight; primitives of kinds that
    /// cannot be sampled are lit up by no more than the rays that meet them.
    Lights(const Scene& scene, std::vector<std::string>& problems,
           SkySampling sky_sampling = SkySampling::above_mean);

    bool empty() const { return sources_.empty(); }

    /// Returns whether rays meet any of them.
    bool can_be_seen() const { return !area_lights_.empty() || !infinite_.empty(); }

    /// Radius of a sphere around the scene's bounds.
    double scene_radius() const { return scene_radius_; }

    /// How many there are to pick from: the halves of a quadrilateral are one.
    std::size_t size() const { return sources_.size(); }

    /// The number among those of a light of the look.
    std::uint32_t number_of(std::uint32_t light) const { return numbers_[light]; }

    /// Chooses a light by what it would give the point if nothing were in the way: where they are
    /// many, from a tree of bounds, beside which there are those at infinity. Nothing where none
    /// can shine there.
    std::optional<LightPick> pick(Receiver& at, double choice) const;

    /// The probability with which pick() chose the light for the same receiver.
    double pick_probability(const Receiver& at, std::uint32_t light) const;

    /// Returns whether any light has a place but no extent.
    bool has_point_lights() const { return !point_lights_.empty(); }

    /// The part of all lights' power that spots have.
    double power_share_of_spots() const;

    /// Chooses one of them by its power.
    LightPick pick_point_light(double choice) const;

    /// The probability of that: 0 of other lights.
    double point_light_probability(std::uint32_t light) const;

    /// The part of a ray that one of them shines on: see lit_range().
    std::optional<Equiangular> lit_range(std::uint32_t light, const Vec3& origin,
                                         const Vec3& direction, double length) const {
        return etalon::lit_range(*sources_[light].light, origin, direction, length);
    }

    /// How many samples a vertex takes of the light where it asks every one.
    int samples(std::uint32_t light) const { return sources_[light].samples; }

    /// The same of all lights together.
    std::size_t samples() const { return samples_; }

    /// What the light may send to the point.
    LightSample sample(std::uint32_t light, const Vec3& from, const Vec2& uv) const;

    /// Density per steradian with which sample() gives a point of an area light, seen from `from`.
    double pdf(std::uint32_t light, const Vec3& from, const SurfacePoint& at) const;

    /// What an area light sends back along a ray that met it.
    Color emitted(std::uint32_t light, const SurfacePoint& at, const Vec3& ray) const;

    /// Numbers of the lights at infinity that rays meet.
    const std::vector<std::uint32_t>& infinite() const { return infinite_; }
    const InfiniteLight& infinite_light(std::uint32_t light) const {
        return infinite_lights_[sources_[light].index];
    }

  private:
    struct AreaLight {
        AreaShape shape;
        Color radiance;
        BoundingSphere bounds;
        std::optional<Vec3> flat_front;  ///< normal of the side that shines, of a flat one
        bool flipped, two_sided;
        double exitance;  ///< area times luminance
        Box3 box{};       ///< of the shape

        bool turns_from(const Vec3& point) const;
        bool shines(const Vec3& normal, const Vec3& ray) const;
        double facing(const Vec3& back) const;
    };
    struct Source {
        const PhysicalLight* light;
        std::uint32_t index;  ///< among the area or the infinite lights, or the images of others
        double power;
        int samples = 1;
    };

    static constexpr std::size_t most_by_importance = 16;

    void add(const PhysicalLight& light, std::vector<std::string>& problems,
             SkySampling sky_sampling);
    bool add_half(const PhysicalLight& light);
    void add_area(const AreaSource& source, double& power);
    LightSample sample_delta(const Source& source, const Vec3& from) const;
    double importance(const Source& source, const Receiver& at) const;
    LightBounds bounds_of(const Source& source) const;
    void make_tree();
    std::optional<LightPick> pick_from_tree(Receiver& at, double choice) const;

    const Scene& scene_;
    double scene_radius_;
    std::size_t samples_ = 0;
    std::vector<Source> sources_;
    std::vector<std::uint32_t> numbers_;
    std::vector<AreaLight> area_lights_;
    std::vector<InfiniteLight> infinite_lights_;
    std::vector<SphericalImage> images_;
    std::vector<std::uint32_t> infinite_;
    std::optional<LightTree> tree_;            ///< where there are too many to compare all
    std::vector<std::uint32_t> far_;           ///< those at infinity then
    std::vector<std::uint32_t> point_lights_;  ///< those of a place but no extent
    std::vector<double> point_power_sums_;
};

}  // namespace etalon
