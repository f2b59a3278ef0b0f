// memory_bytes() of scenes against what the allocator hands out for them.
#include "core/scene/scene.h"
#include "tests/backends/scenes.h"
#include "tests/catch.h"
#include "tests/heap_bytes.h"
#include "tests/sanitized.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Bytes of small blocks, which the allocator may hand out again without counting them anew.
constexpr std::size_t small = 4096;

/// Requires that a scene is told to take what a copy of it, which has no room to spare, allocates.
void check_told(const Scene& scene) {
    const std::size_t before = heap_bytes();
    const Scene copy = scene;
    const std::size_t taken = heap_bytes() - before, told = memory_bytes(copy) - sizeof(Scene);
    CAPTURE(taken, told);
    if (is_sanitized) return;  // which has a heap of its own
    CHECK(taken > 2 * small);
    CHECK(told + told / 20 + small > taken);
    CHECK(taken + taken / 20 + small > told);
}

struct Part {
    const char* name;
    void (*fill)(Scene&);
};

constexpr std::size_t count = 1000;

const Part parts[] = {
    {"vertices", [](Scene& s) { s.geometry.vertices.resize(count); }},
    {"normals", [](Scene& s) { s.geometry.normals.resize(count); }},
    {"decimal vertices",
     [](Scene& s) {
         for (std::size_t i = 0; i < count; ++i) s.geometry.add_compact_vertex(Vec3(0.5));
     }},
    {"texture coordinates", [](Scene& s) { s.geometry.uvs.resize(count * 2); }},
    {"instances", [](Scene& s) { s.geometry.instances.resize(count, Instance(Affine(), 0)); }},
    {"motions",
     [](Scene& s) { s.geometry.motions.resize(count, AnimatedTransform(Affine(), Affine(), {})); }},
    {"objects",
     [](Scene& s) {
         s.geometry.objects.resize(10);
         for (Geometry& object : s.geometry.objects) object.vertices.resize(count);
     }},
    {"materials of Whitted's look", [](Scene& s) { s.whitted().materials.resize(count); }},
    {"lights of Whitted's look",
     [](Scene& s) {
         s.whitted().lights.resize(count, PointLight{Vec3(0), Color(0.0F)});
     }},
    {"bindings", [](Scene& s) { s.look.emplace<PhysicalLook>().bindings.resize(count); }},
    {"materials", [](Scene& s) { s.look.emplace<PhysicalLook>().materials.resize(count); }},
    {"lights", [](Scene& s) { s.look.emplace<PhysicalLook>().lights.resize(count); }},
    {"media", [](Scene& s) { s.look.emplace<PhysicalLook>().media.resize(count); }},
    {"textures",
     [](Scene& s) {
         Textures& textures = s.look.emplace<PhysicalLook>().textures;
         textures.numbers.resize(count);
         textures.colors.resize(count);
         textures.images.resize(count);
     }},
    {"names of images",
     [](Scene& s) { s.look.emplace<PhysicalLook>().named_images.resize(count); }},
};

}  // namespace

TEST_CASE("Memory: the shapes of a scene are told to take what they take", "[backends]") {
    for (const SceneFamily& family : scene_families()) {
        CAPTURE(family.name);
        check_told(family.make(count));
    }
}

TEST_CASE("Memory: every list of a scene is told to take what it takes", "[backends]") {
    for (const Part& part : parts) {
        CAPTURE(part.name);
        Scene scene;
        part.fill(scene);
        check_told(scene);
    }
}
