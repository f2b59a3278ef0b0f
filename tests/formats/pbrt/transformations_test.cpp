#include "core/formats/pbrt/transformations.h"

#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

/// Returns the image of the point (1, 2, 3) under the statements.
Vec3 carried(const std::string& statements) {
    const Frame frame = good_world(statements + " Shape \"sphere\"");
    return image(start(frame, frame.shapes.at(0)), {1, 2, 3});
}

void check_near(const Vec3& a, const Vec3& b) {
    CAPTURE(a, b);
    CHECK(max_abs(a - b) < 1e-12);
}

/// Returns its images at both times, and requires one message.
std::array<Vec3, 2> carried_with(const std::string& statements, const std::string& message) {
    const Frame frame = world_with(statements + " Shape \"sphere\"", message);
    const Shape& shape = frame.shapes.at(0);
    return {image(start(frame, shape), {1, 2, 3}), image(end(frame, shape), {1, 2, 3})};
}

}  // namespace

TEST_CASE("the current transformation is the identity at first") {
    const Frame frame = good_world("Shape \"sphere\"");
    CHECK(frame.transforms.size() == 1);
    CHECK(frame.transforms[0] == Matrix4{});
    CHECK(frame.shapes.at(0).to_world == TransformPair{0, 0});
}

TEST_CASE("transformations are those of pbrt-v3") {
    check_near(carried("Translate 10 20 30"), {11, 22, 33});
    check_near(carried("Scale 2 3 -4"), {2, 6, -12});
    check_near(carried("Rotate 90 0 0 1"), {-2, 1, 3});
    check_near(carried("Rotate 90 5 0 0"), {1, -3, 2});
    check_near(carried("LookAt 0 0 5  0 0 0  0 1 0"), {-1, 2, 2});
    check_near(carried("Identity"), {1, 2, 3});
}

TEST_CASE("transforms are kept whole, whether affine or not") {
    const Matrix4 affine{{{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {0, 0, 0, 1}}}};
    const Matrix4 projection{{{{2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 4, 5}, {0, 6, -1, 0}}}};
    TransformList list;
    CHECK(list.add(projection) == 1);
    CHECK(list.add(Matrix4{}) == 0);
    CHECK(list.add(affine) == 2);
    CHECK(list.add(projection) == 3);
    REQUIRE(list.size() == 4);
    const Matrix4 expected[] = {Matrix4{}, projection, affine, projection};
    for (std::uint32_t i = 0; i < 4; ++i) CHECK(list[i] == expected[i]);
}

TEST_CASE("a matrix is given column by column") {
    check_near(carried("Transform [1 0 0 0  0 2 0 0  0 0 3 0  7 8 9 1]"), {8, 12, 18});
    check_near(carried("ConcatTransform [0 1 0 0  -1 0 0 0  0 0 1 0  0 0 0 1]"), {-2, 1, 3});
}

TEST_CASE("a matrix whose last row is 0 0 0 w divides by w") {
    check_near(carried("Transform [2 0 0 0  0 4 0 0  0 0 6 0  14 16 18 2]"), {8, 12, 18});
    check_near(carried("Scale 2 2 2 ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 .5]"),
               {4, 8, 12});
    const Matrix4 negative =
        from_columns(std::array<double, 16>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1});
    CHECK_FALSE(is_affine(negative));
}

TEST_CASE("a transformation acts before those that were stated earlier") {
    check_near(carried("Translate 10 0 0 Scale 2 2 2"), {12, 4, 6});
    check_near(carried("Scale 2 2 2 ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 5 0 0 1]"),
               {12, 4, 6});
}

TEST_CASE("Transform and Identity replace the current transformation") {
    check_near(carried("Scale 9 9 9 Transform [1 0 0 0 0 1 0 0 0 0 1 0 5 0 0 1]"), {6, 2, 3});
    check_near(carried("Scale 9 9 9 Identity"), {1, 2, 3});
}

TEST_CASE("brackets are read where pbrt-v3 refuses them and missed where it wants them") {
    const std::string with =
        "a.pbrt:1:22: warning: pbrt-v3 stops here: it wants 'Translate' "
        "without brackets";
    check_near(carried_with("Translate [1 1 1]", with)[0], {2, 3, 4});
    const std::string without =
        "a.pbrt:1:22: warning: pbrt-v3 stops here: it wants 'Transform' "
        "with brackets";
    check_near(carried_with("Transform 1 0 0 0 0 1 0 0 0 0 1 0 5 0 0 1", without)[0], {6, 2, 3});
}

TEST_CASE("a degenerate transformation is left out") {
    CHECK(carried_with("Rotate 30 0 0 0",
                       "a.pbrt:1:12: error: 'Rotate' is left out: its axis has no length")[0] ==
          Vec3(1, 2, 3));
    for (const char* at :
         {"LookAt 1 1 1 1 1 1 0 1 0", "LookAt 0 0 0 0 0 1 0 0 2", "LookAt 0 0 0 0 0 1 0 0 0"}) {
        CHECK(carried_with(at,
                           "a.pbrt:1:12: error: 'LookAt' is left out: it looks nowhere, or "
                           "along its vector up")[0] == Vec3(1, 2, 3));
    }
    for (const char* translate : {"Translate nan 0 0", "Translate 0 inf 0", "Translate 0 0 1e400",
                                  "Scale 1 1 1e300 Scale 1 1 1e300"}) {
        CAPTURE(translate);
        const ParsedFile file = parse_world(translate);
        REQUIRE(file.diagnostics.size() == 1);
        CHECK(file.diagnostics[0].kind == "range");
    }
}

TEST_CASE("a coordinate system is known until WorldEnd and brings both times back") {
    const Frame frame = good_world(
        "AttributeBegin ActiveTransform StartTime Translate 1 0 0 CoordinateSystem \"a\" "
        "AttributeEnd Scale 5 5 5 CoordSysTransform \"a\" Shape \"sphere\"");
    const Shape& shape = frame.shapes.at(0);
    check_near(image(start(frame, shape), {0, 0, 0}), {1, 0, 0});
    CHECK(end(frame, shape) == Matrix4{});
}

TEST_CASE("a coordinate system may be defined again") {
    check_near(carried("CoordinateSystem \"a\" Translate 1 0 0 CoordinateSystem \"a\" Identity "
                       "CoordSysTransform \"a\""),
               {2, 2, 3});
}

TEST_CASE("an unknown coordinate system leaves the transformation") {
    check_near(carried_with("Translate 1 0 0 CoordSysTransform \"b\"",
                            "a.pbrt:1:28: warning: no coordinate system 'b' is defined")[0],
               {2, 2, 3});
}

TEST_CASE("the camera and the world define coordinate systems") {
    const Frame frame = good_frame(
        "LookAt 3 0 5  3 0 0  0 1 0 Camera \"perspective\" WorldBegin Scale 2 2 2 "
        "CoordSysTransform \"camera\" Shape \"sphere\" CoordSysTransform \"world\" Shape "
        "\"sphere\" WorldEnd");
    check_near(image(start(frame, frame.shapes.at(0)), {0, 0, 0}), {3, 0, 5});
    check_near(image(start(frame, frame.shapes.at(1)), {1, 2, 3}), {1, 2, 3});
}

TEST_CASE("the camera's transformation is the inverse of the current one") {
    const Frame frame = good_frame("Translate 1 2 3 Camera \"perspective\" WorldBegin WorldEnd");
    for (const CameraTransform& camera : frame.camera_transforms) {
        check_near(image(camera.to_world, {1, 2, 3}), {0, 0, 0});
        check_near(image(camera.from_world, {0, 0, 0}), {1, 2, 3});
    }
}

TEST_CASE("a camera whose transformation has no inverse is where it would be without") {
    const ParsedFile file = parse_text("Scale 1 0 1 Camera \"perspective\" WorldBegin WorldEnd");
    REQUIRE(file.diagnostics.size() == 2);  // at each time
    CHECK(messages(file)[0] ==
          "a.pbrt:1:13: error: the current transformation has no inverse; the "
          "camera is where it would be without");
    CHECK(file.frames.at(0).camera_transforms[0].to_world == Matrix4{});
}

TEST_CASE("only the active times are transformed") {
    const Frame frame = good_world(
        "ActiveTransform EndTime Translate 1 0 0 ActiveTransform StartTime Translate 0 1 0 "
        "ActiveTransform All Translate 0 0 1 Shape \"sphere\"");
    const Shape& shape = frame.shapes.at(0);
    CHECK(shape.to_world.is_animated());
    check_near(image(start(frame, shape), {0, 0, 0}), {0, 1, 1});
    check_near(image(end(frame, shape), {0, 0, 0}), {1, 0, 1});
}

TEST_CASE("all times are active again when the world begins") {
    const Frame frame =
        good_frame("ActiveTransform EndTime WorldBegin Translate 1 0 0 Shape \"sphere\" WorldEnd");
    CHECK_FALSE(frame.shapes.at(0).to_world.is_animated());
    check_near(image(start(frame, frame.shapes.at(0)), {0, 0, 0}), {1, 0, 0});
}

TEST_CASE("a camera may move") {
    const Frame frame = good_frame(
        "ActiveTransform EndTime Translate 1 0 0 ActiveTransform All "
        "TransformTimes 2 3 Camera \"perspective\" WorldBegin WorldEnd");
    CHECK(frame.camera_transforms[0].from_world == Matrix4{});
    check_near(image(frame.camera_transforms[1].to_world, {1, 0, 0}), {0, 0, 0});
    CHECK(frame.transform_times == std::array{2.0, 3.0});
}

TEST_CASE("TransformBegin saves the transformation and its active times, and nothing else") {
    const Frame frame = good_world(
        "TransformBegin Translate 1 0 0 ActiveTransform EndTime ReverseOrientation TransformEnd "
        "Scale 2 2 2 Shape \"sphere\"");
    check_near(image(start(frame, frame.shapes.at(0)), {1, 2, 3}), {2, 4, 6});
    CHECK(frame.shapes.at(0).reverse_orientation);
}

TEST_CASE("the options' transformation does not reach into the world") {
    const Frame frame = good_frame("Translate 5 5 5 WorldBegin Shape \"sphere\" WorldEnd");
    CHECK(frame.shapes.at(0).to_world == TransformPair{0, 0});
}

TEST_CASE("a matrix times its inverse is the identity") {
    const Matrix4 m = *rotation(33, {1, 2, 3}) * scaling({0.5, 2, -50}) * translation({1, 2, 3});
    const auto back = inverse(m);
    REQUIRE(back);
    const Matrix4 product = *back * m;
    for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t c = 0; c < 4; ++c) {
            CHECK(product[r][c] == Approx(r == c ? 1 : 0).margin(1e-13));
        }
    }
    CHECK_FALSE(inverse(scaling({1, 0, 1})));
    CHECK(is_affine(m));
    CHECK_FALSE(is_affine(Matrix4{{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 1}}}}));
}
