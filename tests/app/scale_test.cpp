// Memory that large scenes take, as reported by the program.
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/scene/instance.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

constexpr const char* backends[] = {"bvh", "grid", "embree"};

/// Returns the memory used for an image of a few pixels, from --stats.
nlohmann::json memory_of(const Folder& f, const std::string& scene, const std::string& backend) {
    const auto r = f.etalon("render " + scene + " -b " + backend +
                            " --resolution 8x8 --spp 1 -q -o a.png --stats a.json");
    INFO(r.err);
    REQUIRE(r.status == 0);
    return nlohmann::json::parse(f.read("a.json"))["memory_bytes"];
}

template <class T>
void append(std::string& bytes, const T& value) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    bytes.append(raw.data(), raw.size());
}

/// A wavy sheet of 2 n^2 triangles as a binary PLY file.
std::string sheet(std::int32_t n) {
    const std::int32_t side = n + 1;
    std::string text =
        "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(side * side) +
        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
        std::to_string(2 * n * n) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::int32_t i = 0; i < side * side; ++i) {
        const float x = static_cast<float>(i % side) / static_cast<float>(n) - 0.5F,
                    y = static_cast<float>(i / side) / static_cast<float>(n) - 0.5F;
        append(text, std::array{x, y, 0.1F * std::sin(20 * x) * std::cos(17 * y)});
    }
    for (std::int32_t i = 0; i < n * n; ++i) {
        const std::int32_t a = i / n * side + i % n, b = a + side;
        for (const auto& face : {std::array{a, a + 1, b}, std::array{a + 1, b + 1, b}}) {
            text += '\3';
            append(text, face);
        }
    }
    return text;
}

}  // namespace

TEST_CASE("an instance takes at most 190 bytes in all", "[app]") {
    constexpr std::size_t count = 100'000;
    const Folder f;
    const std::string forest = "'" ETALON_BINARY_DIR "/bin/etalon-scenes' forest --size ";
    REQUIRE(f.shell(forest + "1 -o one.pbrt").status == 0);
    REQUIRE(f.shell(forest + "100000 -o many.pbrt").status == 0);
    for (const char* backend : {"bvh", "grid"}) {  // Embree takes its memory in large blocks
        CAPTURE(backend);
        const auto one = memory_of(f, "one.pbrt", backend),
                   many = memory_of(f, "many.pbrt", backend);
        const auto more = [&](const char* what) {
            return many[what].get<double>() - one[what].get<double>();
        };
        CHECK(more("scene") + more("accelerator") <= 190.0 * count);
        CHECK(more("scene") >= sizeof(etalon::Instance) * count);
        CHECK(more("accelerator") >= 6 * sizeof(float) * count);  // a box at least
    }
}

TEST_CASE("a mesh takes at most twice its data and 66 bytes a triangle", "[app][long]") {
    constexpr std::int32_t n = 1000;
    const Folder f;
    f.write("large.ply", sheet(n));
    f.write("small.ply", sheet(1));
    const double data = static_cast<double>(f.read("large.ply").size());
    for (const char* size : {"large", "small"}) {
        f.write(std::string(size) + ".pbrt",
                "LookAt 0 -1 1  0 0 0  0 0 1 Camera \"perspective\" WorldBegin Shape \"plymesh\" "
                "\"string filename\" \"" +
                    std::string(size) + ".ply\" WorldEnd\n");
    }
    for (const char* backend : backends) {
        CAPTURE(backend);
        const double small = memory_of(f, "small.pbrt", backend)["peak_rss"],
                     large = memory_of(f, "large.pbrt", backend)["peak_rss"];
        CHECK(large - small <= 2 * data + 66.0 * 2 * n * n);
    }
}

#ifndef ETALON_SANITIZED  // whose own memory counts

TEST_CASE("samples of all lights at many vertices take little memory at a time", "[app]") {
    const Folder f;
    f.write("lights.pbrt",
            "LookAt 0 0 -5  0 0 0  0 1 0 Camera \"perspective\" Integrator \"directlighting\" "
            "WorldBegin AttributeBegin AreaLightSource \"diffuse\" Shape \"loopsubdiv\" \"integer "
            "nlevels\" 8 \"point P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2] AttributeEnd "
            "Translate 0 0 2 Shape \"disk\" \"float radius\" 100 WorldEnd\n");
    const auto r = f.etalon("render lights.pbrt --resolution 32x32 --spp 1 -t 1 -q -o a.png");
    CHECK(r.status == 0);
    CHECK(r.peak_bytes < 200'000'000);
}

TEST_CASE("a material of a PBRT scene takes at most 2000 bytes, its statements included", "[app]") {
    constexpr int count = 50'000;
    const Folder f;
    const auto scene = [&](const std::string& name, int materials) {
        std::string text = "LookAt 0 0 -5  0 0 0  0 1 0 Camera \"perspective\" WorldBegin\n";
        for (int i = 0; i < materials; ++i) {
            text +=
                "Material \"matte\" \"float sigma\" " + std::to_string(i) + " Shape \"sphere\"\n";
        }
        f.write(name, text + "WorldEnd\n");
    };
    scene("one.pbrt", 1);
    scene("many.pbrt", count);
    const double one = memory_of(f, "one.pbrt", "bvh")["peak_rss"],
                 many = memory_of(f, "many.pbrt", "bvh")["peak_rss"];
    CHECK(many - one <= 2000.0 * count);
}

#endif
