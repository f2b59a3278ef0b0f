#include "core/shading/textured_cut_outs.h"

#include <memory>

#include "tests/catch.h"

using namespace etalon;

namespace {

/// A texture that is 0 in every other square of the unit square's four.
const Texture<float> board = Checkerboard2<float>{UvMapping{2, 2}, {1}, {0}};
const NumberSlot of_board{0, 0}, of_other{0, 1}, zero{0}, one{1};

bool is_odd(const Vec2& uv) {
    return (uv.x > 0.5) != (uv.y > 0.5);
}

/// Two triangles whose own coordinates (u, v) are x and y, of two surfaces.
Geometry two_triangles() {
    Geometry g;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}) g.add_vertex(p);
    g.add(Triangle{{0, 1, 2}}, 0);
    g.add(Triangle{{0, 1, 2}}, 1);
    return g;
}

/// Checks which of 8 x 8 points of a primitive are in a hole, by x and y.
template <class IsHole>
void check_holes(const CutOuts& cut_outs, const Geometry& geometry, std::uint32_t primitive,
                 bool for_shadow, const IsHole& is_hole) {
    for (int i = 0; i < 64; ++i) {
        SurfacePoint point{};
        point.position = Vec3((i % 8 + 0.5) / 8, (i / 8 + 0.5) / 8, 0);
        point.primitive = primitive;
        point.material = geometry.primitives[primitive].material;
        CAPTURE(primitive, point.position, for_shadow);
        CHECK(cut_outs.is_hole(geometry, point, for_shadow) ==
              is_hole(Vec2(point.position.x, point.position.y)));
    }
}

std::unique_ptr<const CutOuts> cut_outs_of(const PhysicalLook& look) {
    std::vector<std::string> problems;
    auto cut_outs = std::make_unique<const TexturedCutOuts>(look, problems);
    REQUIRE(problems.empty());
    return cut_outs;
}

}  // namespace

TEST_CASE("Holes: given a texture that refers to others, then all of these are evaluated",
          "[cut_outs]") {
    const UvMapping even{0.1F, 0.1F}, odd{0.1F, 0.1F, 1, 0};
    const Affine upwards{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
    const Texture<float> alphas[] = {board,
                                     ScaleTexture<float>{of_board, one},
                                     ScaleTexture<float>{one, of_board},
                                     MixTexture<float>{of_board, zero, zero},
                                     MixTexture<float>{zero, of_board, one},
                                     MixTexture<float>{zero, one, of_board},
                                     Checkerboard2<float>{even, of_board, one},
                                     Checkerboard2<float>{odd, one, of_board},
                                     Checkerboard3<float>{{}, of_board, one},
                                     Checkerboard3<float>{upwards, one, of_board},
                                     DotsTexture<float>{UvMapping{3, 3}, of_board, of_other}};
    for (const Texture<float>& alpha : alphas) {
        PhysicalLook look;
        look.textures.numbers = {board, board, alpha, ScaleTexture<float>{{0, 2}, one}};
        look.bindings.resize(2);
        look.bindings[0].alpha.texture = 2;
        look.bindings[1].alpha.texture = 3;
        const auto cut_outs = cut_outs_of(look);
        CAPTURE(alpha.index());
        for (const std::uint32_t primitive : {0, 1}) {
            check_holes(*cut_outs, two_triangles(), primitive, false, is_odd);
        }
    }
}

TEST_CASE("Holes: given one for shadows, then no other ray passes it", "[cut_outs]") {
    PhysicalLook look;
    look.textures.numbers = {board};
    look.bindings.resize(2);
    look.bindings[0].shadow_alpha = of_board;
    look.bindings[1].shadow_alpha = zero;
    const auto cut_outs = cut_outs_of(look);
    const Geometry g = two_triangles();
    check_holes(*cut_outs, g, 0, true, is_odd);
    check_holes(*cut_outs, g, 1, true, [](const Vec2&) { return true; });
    for (const std::uint32_t primitive : {0, 1}) {
        check_holes(*cut_outs, g, primitive, false, [](const Vec2&) { return false; });
    }
}

TEST_CASE("Holes: given coordinates of a mesh, then they are where these say", "[cut_outs]") {
    PhysicalLook look;
    look.textures.numbers = {board};
    look.bindings.resize(2);
    for (SurfaceBinding& binding : look.bindings) binding.alpha = of_board;
    look.bindings[1].uv_offset = 0;
    Geometry g = two_triangles();
    g.uvs = {{0, 0}, {2, 0}, {2, 0.25F}};
    const auto cut_outs = cut_outs_of(look);
    check_holes(*cut_outs, g, 0, false, is_odd);
    check_holes(*cut_outs, g, 1, false,
                [](const Vec2& p) { return (p.x > 0.25 && p.x < 0.5) || p.x > 0.75; });
}

TEST_CASE("Holes: given a scene with some, then its objects have them too", "[cut_outs]") {
    Scene scene;
    scene.look = PhysicalLook();
    scene.geometry = two_triangles();
    scene.geometry.objects.push_back(two_triangles());
    std::get<PhysicalLook>(scene.look).bindings.resize(2);
    std::vector<std::string> problems;
    make_cut_outs(scene, problems);
    CHECK(scene.geometry.cut_outs == nullptr);
    std::get<PhysicalLook>(scene.look).bindings[1].shadow_alpha = zero;
    make_cut_outs(scene, problems);
    REQUIRE(scene.geometry.cut_outs != nullptr);
    CHECK(scene.geometry.objects[0].cut_outs == scene.geometry.cut_outs);
}
