#include "tests/formats/pbrt/same_frame.h"

#include <algorithm>

namespace etalon::pbrt {
namespace {

bool same(const Plugin& a, const Plugin& b) {
    return a.parameters == b.parameters;
}

struct Comparison {
    const Frame &a, &b;

    bool transform(std::uint32_t i, std::uint32_t j) const {
        return a.transforms[i] == b.transforms[j];
    }
    bool transforms(TransformPair i, TransformPair j) const {
        return transform(i.start, j.start) && transform(i.end, j.end) &&
               i.is_animated() == j.is_animated();
    }
    bool area_lights(std::uint32_t i, std::uint32_t j) const {
        if (i == none || j == none) return i == j;
        return same(a.area_lights.at(i), b.area_lights.at(j));
    }
    bool operator()(const Texture& s, const Texture& t) const {
        return same(s.plugin, t.plugin) && transform(s.to_world, t.to_world);
    }
    bool operator()(const Material& s, const Material& t) const {
        return same(s.plugin, t.plugin) && s.mixed == t.mixed;
    }
    bool operator()(const Light& s, const Light& t) const {
        return same(s.plugin, t.plugin) && transform(s.to_world, t.to_world) &&
               s.medium == t.medium;
    }
    bool operator()(const Medium& s, const Medium& t) const {
        return same(s.plugin, t.plugin) && transform(s.to_world, t.to_world);
    }
    bool operator()(const Shape& s, const Shape& t) const {
        return same(s.plugin, t.plugin) && transforms(s.to_world, t.to_world) &&
               s.material == t.material && area_lights(s.area_light, t.area_light) &&
               s.media == t.media && s.reverse_orientation == t.reverse_orientation;
    }
    bool operator()(const Object& s, const Object& t) const {
        return std::ranges::equal(s.shapes, t.shapes, *this);
    }
    bool operator()(const Instance& s, const Instance& t) const {
        return s.object == t.object && transforms(s.to_world, t.to_world);
    }

    bool options() const {
        return same(a.camera, b.camera) && same(a.sampler, b.sampler) && same(a.film, b.film) &&
               same(a.filter, b.filter) && same(a.integrator, b.integrator) &&
               same(a.accelerator, b.accelerator) && a.transform_times == b.transform_times;
    }
    bool cameras() const {
        for (std::size_t i = 0; i < 2; ++i) {
            if (a.camera_transforms[i].from_world != b.camera_transforms[i].from_world)
                return false;
            if (a.camera_transforms[i].to_world != b.camera_transforms[i].to_world) return false;
        }
        return a.camera_medium == b.camera_medium && a.has_media == b.has_media;
    }
};

}  // namespace

std::string difference(const Frame& a, const Frame& b) {
    const Comparison compare{a, b};
    if (!compare.options()) return "options";
    if (!compare.cameras()) return "camera";
    if (!std::ranges::equal(a.textures, b.textures, compare)) return "textures";
    if (!std::ranges::equal(a.materials, b.materials, compare)) return "materials";
    if (!std::ranges::equal(a.lights, b.lights, compare)) return "lights";
    if (!std::ranges::equal(a.media, b.media, compare)) return "media";
    if (!std::ranges::equal(a.shapes, b.shapes, compare)) return "shapes";
    if (!std::ranges::equal(a.objects, b.objects, compare)) return "objects";
    if (!std::ranges::equal(a.instances, b.instances, compare)) return "instances";
    return {};
}

}  // namespace etalon::pbrt
