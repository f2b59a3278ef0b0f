// Interface between the renderer and the backends that find hits.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/intersect/batch_intersector.h"
#include "core/intersect/bounded.h"
#include "core/intersect/far_tree.h"
#include "core/intersect/normalized_ray.h"
#include "core/intersect/ray.h"
#include "core/intersect/traversal_cost.h"
#include "core/scene/geometry.h"

namespace etalon {

class LocalRays;
class RayPacket;
struct ObjectSpace;

/// Finds hits in a scene. A backend derives from it and decides only *which* kernels are called;
/// ties, unbounded primitives and instances are handled here, in the same way for all backends.
/// Thread-safe. The scene must outlive the intersector.
class Intersector : public BatchIntersector {
  public:
    explicit Intersector(const Geometry& geometry)
        : Intersector(geometry, SceneBounds::of(geometry)) {}
    Intersector(const Geometry& geometry, SceneBounds bounds);
    /// Returns the nearest hit with tmin < t <= tmax; at equal t that of the lower HitKey. A ray
    /// with a zero or non-finite direction, or a non-finite origin, hits nothing.
    std::optional<Hit> closest(const Ray& ray) const;

    /// Returns the same hit and adds the number of tests to `cost`, if Backend counts them.
    std::optional<Hit> closest(const Ray& ray, TraversalCost& cost) const;

    /// Returns whether closest(ray) finds something.
    bool occluded(const Ray& ray) const;

    using BatchIntersector::closest, BatchIntersector::occluded;
    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override;
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override;

    /// Offers `nearest` the nearest hit on an instance, given by its item number. The intersector
    /// of its object finds that hit for the ray in object space. Adds the number of tests to
    /// `cost`, if not null.
    void offer_instance(std::uint32_t item, const RayQuery& query, NearestHit& nearest,
                        TraversalCost* cost = nullptr) const;

    /// Returns whether an instance is hit with t <= query.ray.tmax.
    bool instance_occludes(std::uint32_t item, const RayQuery& query) const;

    /// The same two for callers that have already transformed the ray to object space (ObjectRay).
    void offer_entered(std::uint32_t item, const RayQuery& in_object, const NormalizedRay& local,
                       NearestHit& nearest) const;
    bool entered_occludes(std::uint32_t item, const RayQuery& in_object,
                          const NormalizedRay& local) const;

    /// Returns the spaces of the intersectors of all objects.
    std::vector<ObjectSpace> object_spaces() const;

    /// Returns the bytes of the backend's structures, including those of objects.
    std::size_t memory_bytes() const;

    /// Returns the instruction set that the traversal uses, e.g. "avx2".
    virtual std::string isa() const { return "baseline"; }

  protected:
    /// Returns the bytes of the backend's own structure, without those of objects.
    virtual std::size_t own_bytes() const = 0;

    /// Builds an intersector of the backend's own class for each object of the geometry. Every
    /// backend's constructor calls it.
    template <class Self, class... Arguments>
    void build_objects(const Arguments&... arguments) {
        for (const Geometry& object : geometry_.objects) {
            objects_.push_back(std::make_unique<Self>(object, arguments...));
        }
    }

    /// Returns the intersector that build_objects() made for an object.
    const Intersector& object(std::uint32_t number) const { return *objects_[number]; }

    /// Returns the hit that `nearest` holds; its primitive is no_index if there is none.
    Hit hit_of(const NearestHit& nearest) const {
        if (!nearest.found() || !geometry_.is_instance(nearest.item)) {
            return {nearest.t, nearest.item};
        }
        const auto first = static_cast<std::uint32_t>(geometry_.primitives.size());
        return {nearest.t, nearest.part, nearest.item - first};
    }

    /// Offers `nearest` every bounded primitive that might be hit at or before nearest.t, and
    /// possibly others.
    virtual void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                                 NearestHit& nearest) const = 0;

    /// The same, but counts its tests in `cost`. Separate code, so that other queries do not pay
    /// for the counting.
    virtual void closest_counted(const RayQuery& query, const NormalizedRay& local,
                                 NearestHit& nearest, TraversalCost&) const {
        closest_bounded(query, local, nearest);
    }

    /// Returns whether any bounded primitive is hit with t <= query.ray.tmax.
    virtual bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const = 0;

    const Geometry& geometry() const { return geometry_; }
    const SceneBounds& scene_bounds() const { return bounds_; }

    /// Returns the bounded primitives, for building. The intersector does not keep them.
    std::vector<BoundedPrimitive> take_bounded() { return std::move(bounds_.bounded); }

  private:
    /// Returns the nearest hit of a ray for which the normalized space is too coarse. Tests every
    /// primitive, or only the unbounded ones if the ray surely misses the rest.
    NearestHit nearest_unresolved(const Ray& ray, TraversalCost* cost) const;
    bool is_occluded_unresolved(const Ray& ray) const;

    const Intersector& object_of(std::uint32_t instance_item) const;

    /// `misses` is the result of misses_bounds().
    NearestHit nearest_hit(const Ray& ray, bool misses, TraversalCost* cost) const;
    NearestHit nearest_hit(const Ray& ray, TraversalCost* cost = nullptr) const {
        return nearest_hit(ray, misses_bounds(bounds_.space, ray), cost);
    }
    bool is_occluded(const Ray& ray, bool misses) const;
    bool is_occluded(const Ray& ray) const {
        return is_occluded(ray, misses_bounds(bounds_.space, ray));
    }
    void offer(std::uint32_t item, const RayQuery& query, NearestHit& nearest,
               TraversalCost* cost) const;
    bool occludes(std::uint32_t item, const RayQuery& query) const;

    /// Offers `nearest` the hits on all that is not bounded; returns whether any of that occludes.
    void offer_unbounded(const RayQuery& query, NearestHit& nearest, TraversalCost* cost) const;
    bool unbounded_occludes(const RayQuery& query) const;

    /// A chunk of a batch, with the nearest hits on planes if these are already known.
    struct Chunk {
        const LocalRays& rays;
        const RayPacket* planes;
    };

    /// Answers a batch of rays in chunks of LocalRays. Rays of LocalRays::Kind::slow_path are
    /// answered one by one, the others with the data that their chunk has for them.
    template <class Answer, class AnswerAlone, class AnswerLocal>
    void answer_all(std::span<const Ray> rays, std::span<Answer> answers, const AnswerAlone& alone,
                    const AnswerLocal& local) const;
    NearestHit nearest_unbounded(const RayQuery& query, const Chunk& chunk, std::size_t i) const;
    Hit closest_local(const Ray& ray, const Chunk& chunk, std::size_t i) const;
    bool is_occluded_local(const Ray& ray, const Chunk& chunk, std::size_t i) const;

    const Geometry& geometry_;
    SceneBounds bounds_;
    std::optional<FarTree> far_;
    bool has_only_planes_;  ///< of what is not bounded, of which there is some
    std::vector<std::unique_ptr<Intersector>> objects_;
};

/// A way to build an intersector. Backends publish lists of these; programs pick by name.
struct Backend {
    std::string_view name;
    std::string_view summary;
    bool exact;  ///< hits are decided by the kernels, so bit-identical to every other exact backend
    /// Builds the backend; never null. Throws std::bad_alloc, and std::runtime_error with the
    /// reason where a library that the backend needs does not work on this machine.
    std::unique_ptr<Intersector> (*build)(const Geometry& geometry);
    bool counts_box_tests = false;  ///< in a TraversalCost
    bool counts_primitive_tests = false;
    int colour = 7;  ///< colour in reports, of bench/plot/style.h, from 1; 7 is grey
    /// Returns whether a backend that is not exact has kernels of its own for any of the
    /// primitives. If it has none, its hits are those of the exact backends. Null is taken
    /// as true.
    bool (*has_own_kernels)(const Geometry& geometry) = nullptr;
};

}  // namespace etalon
