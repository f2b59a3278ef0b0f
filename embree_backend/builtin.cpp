#include "embree_backend/builtin.h"

#include <algorithm>
#include <array>

#include "core/numerics/median.h"
#include "core/numerics/rounding.h"
#include "embree_backend/float_geometry.h"
#include "embree_backend/query.h"

namespace etalon {
namespace {

/// Returns the median of the longest edges of instances' boxes, in normalized space; the largest
/// edge there is, 2, if there are no instances.
float typical_instance(const Geometry& geometry, const std::vector<BoundedPrimitive>& list) {
    std::vector<float> sizes;
    for (const BoundedPrimitive& p : list) {
        if (!geometry.is_instance(p.id)) continue;
        const Vec3f edges = p.max - p.min;
        sizes.push_back(std::max({edges.x, edges.y, edges.z}));
    }
    if (sizes.empty()) return 2;
    return median_of(std::move(sizes));
}

/// Returns by how much a ray whose origin is o is shortened at each end, as a fraction of 1 + |o|.
/// Rounded to floats, a surface is off by about u (1 + |o|) in normalized space (0.6 of that was
/// seen), so a ray that leaves it at an angle meets it again before t = u (1 + |o|) / cosine, and
/// one that ends before it may meet it, as shadow rays do at a light. 128 u clears all rays except
/// those within 1/128 of tangent, and loses contacts nearer than 1e-5 to 2e-4 of the half size.
/// Slivers are off by more. Among instances so small that most would be lost it is less, but so
/// that contacts nearer than a sixteenth of their size are: with less, walls around them, which are
/// off by u (1 + |o|) as ever, are met again.
float margin_among(float instances) {
    constexpr float u = unit_roundoff_f;
    return std::clamp(instances / 16, u, 128 * u);
}

/// The ends of a ray in normalized space.
struct Ends {
    float first, last;
};

Ends shortened(const Ray& ray, const NormalizedRay& local, float margin) {
    const Vec3f& o = local.origin;
    const float by = margin * (1 + std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}));
    return {local.tmin(ray.tmin) + by, local.tmax(ray.tmax) - by};
}

constexpr unsigned first_shape = UserPrimitives::geometries;

/// Returns whether Embree's floats can invert a map.
bool is_invertible(const Affine& map) {
    constexpr double largest = 0x1p100;
    const double volume = std::abs(map.determinant());
    return is_finite(map) && volume > 1 / largest && volume < largest &&
           max_abs(map.origin) < largest;
}

/// Returns the bounds of a scene whose shapes Embree intersects, without padding: outliers are only
/// those that leave others no room.
SceneBounds unpadded_bounds(const Geometry& geometry) {
    return SceneBounds::of(geometry, full_padding, OutlierRule::no_room);
}

std::array<float, 12> columns_of(const Affine& map) {
    std::array<float, 12> columns;
    float* to = columns.data();
    for (const Vec3& column : {map.x, map.y, map.z, map.origin}) {
        for (int k = 0; k < 3; ++k) *to++ = static_cast<float>(column[k]);
    }
    return columns;
}

}  // namespace

EmbreeBuiltin::EmbreeBuiltin(const Geometry& geometry, Traversal traversal,
                             const SceneDevice* of_scene)
    : Intersector(geometry, unpadded_bounds(geometry)),
      device_(of_scene),
      others_(geometry, *this),
      embree_scene_(rtcNewScene(device_->handle())) {
    device_->check();
    build_objects<EmbreeBuiltin>(traversal, &device_);
    if (traversal == Traversal::robust) {
        rtcSetSceneFlags(embree_scene_.get(), RTC_SCENE_FLAG_ROBUST);
    }
    std::map<RTCGeometryType, std::vector<std::uint32_t>> by_type;
    std::vector<std::pair<std::uint32_t, Affine>> instances;
    std::vector<BoundedPrimitive> others;
    const std::vector<BoundedPrimitive> bounded = take_bounded();
    margin_ = margin_among(typical_instance(geometry, bounded));
    for (const BoundedPrimitive& p : bounded) {
        if (geometry.is_instance(p.id)) {
            const auto map = embree_map(geometry.instances[p.id - geometry.primitives.size()]);
            if (map) {
                instances.emplace_back(p.id, *map);
                continue;
            }
        }
        if (const auto type = embree_type_of(geometry, scene_bounds().space, p.id)) {
            by_type[*type].push_back(p.id);
        } else {
            others.push_back(p);
        }
    }
    attach_shapes(std::move(by_type));
    for (const auto& [item, map] : instances) attach_instance(item, map);
    others_.build(*device_, embree_scene_.get(), scene_bounds().space, std::move(others));
}

const EmbreeBuiltin& EmbreeBuiltin::object_of(const Instance& instance) const {
    return static_cast<const EmbreeBuiltin&>(object(instance.object));
}

std::optional<Affine> EmbreeBuiltin::embree_map(const Instance& instance) const {
    const EmbreeBuiltin& shown = object_of(instance);
    if (instance.moves()) return std::nullopt;
    if (!shown.others_.empty() || shown.scene_bounds().has_more()) return std::nullopt;
    const NormalizedSpace &from = shown.scene_bounds().space, &to = scene_bounds().space;
    const Affine map = instance.to_world();
    const double scale = to.scale() / from.scale();
    const Affine between{scale * map.x, scale * map.y, scale * map.z,
                         to.point(map.point(from.centre()))};
    return is_invertible(between) ? std::optional(between) : std::nullopt;
}

void EmbreeBuiltin::attach_shapes(std::map<RTCGeometryType, std::vector<std::uint32_t>>&& by_type) {
    const FloatGeometry floats(*device_, geometry(), scene_bounds().space);
    for (auto& [type, ids] : by_type) {
        const auto number = first_shape + static_cast<unsigned>(ids_.size());
        rtcAttachGeometryByID(embree_scene_.get(), floats.make(type, ids).get(), number);
        ids_.emplace_back(std::move(ids));
    }
}

void EmbreeBuiltin::attach_instance(std::uint32_t item, const Affine& map) {
    const EmbreeOwned<RTCGeometry> shown(
        rtcNewGeometry(device_->handle(), RTC_GEOMETRY_TYPE_INSTANCE));
    device_->check();
    const Instance& instance = geometry().instances[item - geometry().primitives.size()];
    rtcSetGeometryInstancedScene(shown.get(), object_of(instance).embree_scene_.get());
    rtcSetGeometryTransform(shown.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                            columns_of(map).data());
    rtcCommitGeometry(shown.get());
    const std::size_t number = first_shape + ids_.size() + instances_.size();
    rtcAttachGeometryByID(embree_scene_.get(), shown.get(), static_cast<unsigned>(number));
    instances_.push_back(item);
}

bool EmbreeBuiltin::has_own_kernels(const Geometry& geometry) {
    const SceneBounds bounds = unpadded_bounds(geometry);
    return std::ranges::any_of(bounds.bounded,
                               [&](const BoundedPrimitive& p) {
                                   return embree_type_of(geometry, bounds.space, p.id).has_value();
                               }) ||
           std::ranges::any_of(geometry.objects, has_own_kernels);
}

std::size_t EmbreeBuiltin::own_bytes() const {
    std::size_t tables = others_.memory_bytes() + instances_.size() * sizeof(std::uint32_t);
    for (const PrimitiveIds& ids : ids_) tables += ids.memory_bytes();
    return tables + device_.bytes();
}

void EmbreeBuiltin::closest_bounded(const RayQuery& query, const NormalizedRay& local,
                                    NearestHit& nearest) const {
    RTCRayHit ray;
    const Ends ends = shortened(query.ray, local, margin_);
    set_ray(ray.ray, local, ends.first, std::min(ends.last, local.tmax(nearest.t)));
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    if (others_.empty()) {
        embree_intersect(embree_scene_.get(), ray);
    } else {
        others_.intersect(query, local, nearest, ray);
    }
    const RTCHit& hit = ray.hit;
    if (hit.geomID == RTC_INVALID_GEOMETRY_ID || hit.geomID < first_shape) return;
    const double t = std::min(ray.ray.tfar / local.scale + local.shift, nearest.t);
    if (hit.instID[0] == RTC_INVALID_GEOMETRY_ID) {
        return nearest.offer(t, ids_[hit.geomID - first_shape][hit.primID]);
    }
    const std::uint32_t item = instances_[hit.instID[0] - first_shape - ids_.size()];
    const EmbreeBuiltin& shown =
        object_of(geometry().instances[item - geometry().primitives.size()]);
    nearest.offer(t, item, shown.ids_[hit.geomID - first_shape][hit.primID]);
}

bool EmbreeBuiltin::occluded_bounded(const RayQuery& query, const NormalizedRay& local) const {
    RTCRay ray;
    const Ends ends = shortened(query.ray, local, margin_);
    if (!set_occlusion_ray(ray, local, ends.first, ends.last)) return false;
    if (others_.empty()) {
        embree_occluded(embree_scene_.get(), ray);
    } else {
        others_.occluded(query, local, ray);
    }
    return ray.tfar < 0;
}

}  // namespace etalon
