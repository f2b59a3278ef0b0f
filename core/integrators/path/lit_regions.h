#pragma once

#include <array>
#include <vector>

#include "core/intersect/batch_intersector.h"
#include "core/light/lights.h"

namespace etalon {

/// Regions of a medium about the camera that a spotlight illuminates: a disk about the largest flat
/// patch at the end of its beam, and spheres around the beam, each half as large as the one before
/// on the way to the light, where the beam is narrow and bright. Much of the light that is
/// scattered twice comes from there, and few of the directions that a phase function or a BSDF
/// samples hit it.
class LitRegions {
  public:
    /// Makes those of the spotlight of most power; none if no narrow spotlight shines in such a
    /// medium, or if there is also light from the sky.
    LitRegions(const Scene& scene, const Lights& lights, const BatchIntersector& intersector);

    bool empty() const { return part_ == 0; }

    /// Returns the fraction of a vertex's directions that should go to them.
    float part() const { return part_; }

  private:
    friend class LitRegionsFrom;

    struct Sphere {
        Vec3 centre;
        float radius, power;
    };
    struct Disk {
        Vec3 centre, normal;  ///< normal: unit, on the side of the light
        double radius2 = 0;
        float power = 0;
    };
    /// A ray of the beam with its length.
    struct BeamRay {
        double intensity, length;
        Vec3 end, normal;  ///< of the surface that it hits, on its side; 0 if it misses
    };
    struct Beam {
        const SpotSource& spot;
        double extinction, scattering;  ///< coefficients of the medium
        std::vector<BeamRay> rays;
    };
    static std::vector<BeamRay> trace(const SpotSource& spot, double range, const Scene& scene,
                                      const BatchIntersector& intersector);
    static Sphere sphere_around(const Beam& beam, double end);
    static Disk disk_about(const Beam& beam, const BeamRay& first);

    static constexpr std::size_t count = 8;
    struct Spheres {
        std::array<double, count> x{}, y{}, z{};  ///< centres
        std::array<float, count> radius{}, power{};
    };

    float part_ = 0;
    Spheres spheres_;
    Disk disk_;
};

/// The regions as seen from a point.
class LitRegionsFrom {
  public:
    LitRegionsFrom(const LitRegions& regions, const Receiver& at);

    bool empty() const { return !(sum_ > 0); }
    float part() const { return part_; }

    /// Samples a direction to one of them, with numbers in [0, 1).
    Vec3 sample(double choice, const Vec2& uv) const;

    /// Returns the density of sample() per steradian.
    float density(const Vec3& direction) const;

  private:
    void see_spheres(const LitRegions::Spheres& spheres, const Receiver& at);
    void see(const LitRegions::Disk& disk, const Receiver& at);
    Vec3 sample_disk(const Vec2& uv) const;
    Vec3 sample_sphere(float wanted, const Vec2& uv) const;
    float disk_density(const Vec3& direction) const;

    // The spheres in SoA layout. A cone is given by 1 - cos of its half angle, which is half the
    // largest squared distance between the ends of its unit vectors and of its axis.
    std::array<float, LitRegions::count> x_, y_, z_;  ///< axes
    std::array<float, LitRegions::count> sagitta_;    ///< 1 - cos; 2 for all directions
    std::array<float, LitRegions::count> weights_, densities_;

    const LitRegions::Disk& disk_;
    Vec3 to_disk_;
    float disk_weight_ = 0;
    float sum_ = 0;  ///< sum of all weights
    float part_;
};

}  // namespace etalon
