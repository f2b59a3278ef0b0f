// `etalon render --aov`: further channels of an image.
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/image_pixels.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/exr_channels.h"

using namespace etalon::test;

namespace {

ProgramResult render(const Folder& f, const std::string& options) {
    f.write("s.p3f", small_scene);
    return f.etalon("render s.p3f -q " + options);
}

}  // namespace

TEST_CASE("--aov writes the requested channels to the EXR", "[app]") {
    const Folder f;
    REQUIRE(render(f,
                   "--spp 4 --aov albedo,N,P,Z,uv,dpdu,dpdv,primitiveId,instanceId -o a.exr "
                   "--aov variance,sampleCount,cost.boxTests,cost.primitiveTests -b bvh")
                .status == 0);
    std::map<std::string, Imf::PixelType> expected = {
        {"primitiveId", Imf::UINT}, {"instanceId", Imf::UINT}, {"sampleCount", Imf::FLOAT}};
    std::istringstream floats(
        "R G B albedo.R albedo.G albedo.B N.X N.Y N.Z P.X P.Y P.Z Z uv.U uv.V dpdu.X dpdu.Y dpdu.Z "
        "dpdv.X dpdv.Y dpdv.Z variance.R variance.G variance.B cost.boxTests cost.primitiveTests");
    for (std::string name; floats >> name;) expected[name] = Imf::FLOAT;
    const std::string path = f.path("a.exr");
    CHECK(channel_types(path) == expected);
    CHECK(channel<float>(path, "sampleCount") == std::vector<float>(32 * 24, 4));
    const auto ids = channel<unsigned>(path, "primitiveId");
    const auto depths = channel<float>(path, "Z");
    const auto albedo = channel<float>(path, "albedo.G");
    const std::size_t middle = 12 * 32 + 16;
    CHECK(ids[middle] == 1);
    CHECK(channel<unsigned>(path, "instanceId")[middle] == 4294967295U);
    CHECK(depths[middle] == Approx(std::sqrt(26) - 1).margin(0.02));
    const auto at = [&](const char* name) { return channel<float>(path, name)[middle]; };
    const double x = at("P.X"), y = at("P.Y"), z = at("P.Z");  // of the unit sphere
    CHECK(at("uv.U") == Approx(std::atan2(y, x) / (2 * 3.14159265)).margin(1e-5));
    CHECK(at("uv.V") == Approx(1 - std::acos(z) / 3.14159265).margin(1e-4));
    CHECK(at("dpdu.X") == Approx(-2 * 3.14159265 * y).margin(1e-4));
    CHECK(at("dpdu.Y") == Approx(2 * 3.14159265 * x).margin(1e-4));
    CHECK(at("dpdv.X") == Approx(-3.14159265 * z * x / std::hypot(x, y)).margin(1e-4));
    CHECK(at("dpdv.Z") == Approx(3.14159265 * std::hypot(x, y)).margin(1e-4));
    CHECK(albedo[middle] == Approx(0.7 * 0.2 + 0.3));
    CHECK(ids[0] == 4294967295U);
    CHECK(depths[0] == std::numeric_limits<float>::infinity());
    CHECK(channel<float>(path, "cost.primitiveTests")[middle] == 2);
}

TEST_CASE("--aov changes neither the image nor the counts of its rays", "[app]") {
    const Folder f;
    REQUIRE(render(f, "--spp 4 -o a.exr --stats a.json").status == 0);
    REQUIRE(render(f, "--spp 4 -o b.exr --stats b.json --aov N,P,variance").status == 0);
    CHECK(pixels(f.path("a.exr")) == pixels(f.path("b.exr")));
    const auto rays = [&](const char* name) { return nlohmann::json::parse(f.read(name))["rays"]; };
    CHECK(rays("a.json") == rays("b.json"));
}

TEST_CASE("--aov follows a crop and the corners of --spd", "[app]") {
    const Folder f;
    REQUIRE(render(f, "--spd --crop 4,6,20,18 -o a.exr --aov N,Z,sampleCount").status == 0);
    const std::string path = f.path("a.exr");
    CHECK(channel<float>(path, "sampleCount") == std::vector<float>(16 * 12, 4));
    CHECK(channel<float>(path, "N.Y").size() == 16 * 12);
    REQUIRE(render(f, "--spd -o b.exr --aov Z").status == 0);
    const auto part = channel<float>(path, "Z"), whole = channel<float>(f.path("b.exr"), "Z");
    CHECK(part[0] == whole[6 * 32 + 4]);
    CHECK(part.back() == whole[17 * 32 + 19]);
}

TEST_CASE("An unavailable --aov is wrong usage, and the available ones are listed", "[app]") {
    const Folder f;
    const ProgramResult unknown = render(f, "--aov Z,albdo -o a.exr");
    CHECK(unknown.status == 2);
    CHECK_THAT(unknown.err + unknown.out, ContainsSubstring("did you mean 'albedo'?"));
    const ProgramResult no_place = render(f, "--aov Z -o a.png");
    CHECK(no_place.status == 2);
    CHECK_THAT(no_place.err, ContainsSubstring("FILE.exr"));
    for (const char* aov : {"cost.boxTests", "cost.primitiveTests"}) {
        const ProgramResult uncounted =
            render(f, std::string("-b embree-builtin -o a.exr --aov ") + aov);
        CHECK(uncounted.status == 2);
        CHECK_THAT(uncounted.err,
                   ContainsSubstring(aov) && ContainsSubstring("none") && ContainsSubstring("bvh"));
    }
    CHECK_FALSE(f.has("a.exr"));
    CHECK_FALSE(f.has("a.png"));
}

TEST_CASE("--aov albedo uses the image's own textures, and says which cannot be read", "[app]") {
    const Folder f;
    constexpr int side = 2048;
    constexpr std::size_t texture_bytes = std::size_t{3} * side * side;
    const etalon::RenderedImage colors{
        side,  side, {{0, 0}, {side - 1, side - 1}}, std::vector(side * side, etalon::Color(0.5F)),
        false, {}};
    REQUIRE(write_image(f.path("t.png"), colors) == "");
    f.write(
        "s.pbrt",
        "LookAt 0 0 5 0 0 0 0 1 0 Camera \"perspective\" Film \"image\" \"integer xresolution\" 8 "
        "\"integer yresolution\" 8 WorldBegin LightSource \"infinite\" Texture \"t\" \"spectrum\" "
        "\"imagemap\" \"string filename\" \"t.png\" Material \"matte\" \"texture Kd\" \"t\" Shape "
        "\"sphere\" WorldEnd\n");
    const std::string command = "render s.pbrt -q -t 1 --spp 1 -o a.exr --integrator ";
    const auto without = f.etalon(command + "path"), with = f.etalon(command + "path --aov albedo");
    REQUIRE(without.status + with.status == 0);
    CHECK(with.peak_bytes < without.peak_bytes + texture_bytes / 2);

    f.write("t.png", "This is no picture.\n");
    const auto unread = f.etalon(command + "ao --aov albedo --strict");
    CHECK(unread.status == 3);
    CHECK_THAT(unread.err, ContainsSubstring("t.png: cannot be read"));
    CHECK(f.etalon(command + "ao --strict").status == 0);
}
