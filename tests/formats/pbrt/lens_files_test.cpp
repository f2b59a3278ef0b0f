// Lens files of realistic cameras, and messages about unusable ones.
#include "core/formats/load.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;

namespace {

using Said = std::vector<std::string>;

/// Loads scenes with a realistic camera in a separate folder.
class Lenses {
  public:
    void write(const std::string& text) const { test::put(folder_ / "a.dat", text); }

    LoadResult load(const std::string& parameters) const {
        const std::string camera = "Camera \"realistic\" " + parameters;
        return load_scene_text(camera + "\nWorldBegin\nShape \"sphere\"\nWorldEnd\n",
                               folder_ / "a.pbrt");
    }

    /// Returns the messages about a scene, without the folder.
    Said said(const LoadResult& loaded) const {
        Said list;
        for (const Diagnostic& d : loaded.diagnostics) {
            std::string text = to_string(d);
            const std::string path = folder_ / "";
            for (std::size_t i; (i = text.find(path)) != text.npos;) text.erase(i, path.size());
            list.push_back(text);
        }
        return list;
    }

    const ProjectiveCamera& camera(const LoadResult& loaded) const {
        REQUIRE(loaded.scene);
        return *loaded.scene->camera.projective;
    }

  private:
    test::TemporaryFolder folder_;
};

const std::string file = "\"string lensfile\" \"a.dat\" ";
const std::string biconvex = "50 4 1.5 20 # the front\n0 1 0 10\n-50 45 1 20\n";
const std::string stands_in = "; a perspective camera stands in for the realistic one";

}  // namespace

TEST_CASE("a lens file's surfaces are those of the camera") {
    const Lenses lenses;
    lenses.write(biconvex);
    const LoadResult loaded =
        lenses.load(file + "\"float aperturediameter\" 6 \"float focusdistance\" 2");
    CHECK(lenses.said(loaded) == Said{});
    const ProjectiveCamera& camera = lenses.camera(loaded);
    REQUIRE(camera.projection == Projection::lens_system);
    const std::vector<LensSurface>& surfaces = camera.lens->surfaces;
    REQUIRE(surfaces.size() == 3);
    CHECK(surfaces[0].curvature_radius == 0.05);
    CHECK(surfaces[0].thickness == 0.004);
    CHECK(surfaces[0].eta == 1.5);
    CHECK(surfaces[0].aperture_radius == 0.01);
    CHECK(surfaces[1].aperture_radius == 0.003);
    CHECK(surfaces[2].thickness != 0.045);  // focused
    CHECK(camera.lens->film_diagonal == 0.035);
}

TEST_CASE("the diameter of a stop is at most that of the lens file") {
    const Lenses lenses;
    lenses.write(biconvex);
    const LoadResult loaded = lenses.load(file + "\"float aperturediameter\" 12");
    CHECK(lenses.said(loaded) ==
          Said{"a.pbrt:1:1: warning: aperturediameter 12: taken as 10, the lens file's"});
    CHECK(lenses.camera(loaded).lens->surfaces[1].aperture_radius == 0.005);
}

TEST_CASE("Lens stop: given the diameter of the lens file, then there is nothing to warn of") {
    const Lenses lenses;
    lenses.write("50 4 1.5 20\n0 1 0 17.1\n-50 45 1 20\n");
    CHECK(lenses.said(lenses.load(file + "\"float aperturediameter\" 17.1")) == Said{});
}

TEST_CASE("words in a lens file are skipped") {
    const Lenses lenses;
    lenses.write("50 4 1.5 20 mm\n0 1 0 10\n-50 45 1 20");
    const LoadResult loaded = lenses.load(file);
    CHECK(lenses.said(loaded) ==
          Said{"a.dat:1:13: warning: passed over what is not a number in 'mm'"});
    CHECK(lenses.camera(loaded).lens);
}

TEST_CASE("without a usable lens file a perspective camera stands in") {
    const Lenses lenses;
    const auto check = [&](const std::string& parameters, const std::string& why) {
        const LoadResult loaded = lenses.load(parameters);
        CHECK(lenses.said(loaded) == Said{"a.pbrt:1:1: warning: " + why + stands_in});
        CHECK(lenses.camera(loaded).projection == Projection::perspective);
    };
    check("", "no lensfile is given");
    lenses.write("50 4 1.5 20 7");
    check(file, "'a.dat' has 5 numbers: expected four for each of up to 1000 surfaces");
    lenses.write("# nothing");
    check(file, "'a.dat' has 0 numbers: expected four for each of up to 1000 surfaces");
    lenses.write("50 4 -1.5 20");
    check(file, "'a.dat': an index of refraction is negative");
    lenses.write("50 4 1.5 1e99");
    check(file, "'a.dat': a number of it is too large");
    lenses.write(biconvex);
    check(file + "\"float focusdistance\" .1",
          "its lens cannot be focused: it cannot be focused so near");
    check(file + "\"float aperturediameter\" 0",
          "its lens cannot be focused: no light passes along its axis");
}
