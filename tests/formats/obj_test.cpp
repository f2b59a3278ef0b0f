#include "core/formats/obj.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

struct Read {
    ObjMesh mesh;
    std::vector<std::string> messages;
};

Read read(const std::string& text) {
    DiagnosticLog log("a.obj", text, false);
    Read r{read_obj(text, log), {}};
    for (const Diagnostic& d : log.take()) r.messages.push_back(to_string(d));
    return r;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<std::uint32_t> vertices_of(const ObjMesh& mesh) {
    std::vector<std::uint32_t> list;
    for (const auto& triangle : mesh.triangles) {
        for (const ObjMesh::Corner& c : triangle) list.push_back(c.vertex);
    }
    return list;
}

std::vector<std::uint32_t> normals_of(const ObjMesh& mesh) {
    std::vector<std::uint32_t> list;
    for (const auto& triangle : mesh.triangles) {
        for (const ObjMesh::Corner& c : triangle) list.push_back(c.normal);
    }
    return list;
}

using Indices = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("vertices, normals and faces are read, anything else is passed over") {
    const Read r = read("# a mesh\r\nmtllib a.mtl\r\no thing\r\n" + square +
                        "vt 0 0\nvn 0 0 1 # up\nusemtl red\ns off\nf 1 2 3\nl 1 2\n");
    CHECK(r.messages.empty());
    CHECK(r.mesh.vertices.size() == 4);
    CHECK(r.mesh.vertices[2] == Vec3(1, 1, 0));
    CHECK(r.mesh.normals == std::vector<Vec3>{Vec3(0, 0, 1)});
    CHECK(vertices_of(r.mesh) == Indices{0, 1, 2});
}

TEST_CASE("a corner may name a texture and a normal beside its vertex") {
    const std::string normals = "vn 0 0 1\nvn 0 0 2\nvn 0 0 3\nvt 0 0\n";
    for (const char* face : {"f 1//1 2//2 3//3", "f 1/1/1 2/1/2 3/1/3", "f 1//-3 2//-2 3//-1"}) {
        const Read r = read(square + normals + face);
        CAPTURE(face);
        CHECK(r.messages.empty());
        CHECK(vertices_of(r.mesh) == Indices{0, 1, 2});
        CHECK(normals_of(r.mesh) == Indices{0, 1, 2});
    }
    CHECK(normals_of(read(square + normals + "f 1/1 2/1 3/1").mesh) ==
          Indices{no_index, no_index, no_index});
}

TEST_CASE("a backslash continues a line on the next, but not a comment") {
    const std::string text =
        "# C:\\meshes\\\nv 0 0 0\nv \\\r\n1 0 0\nv 1 1 \\\r0\nf 1 2 \\\n\\\n 3\nf 1 x\n";
    const Read r = read(text);
    CHECK(r.messages ==
          std::vector<std::string>{
              "a.obj:9:5: warning: face left out: expected v, v/t, v//n or v/t/n, found 'x'"});
    CHECK(r.mesh.vertices == std::vector<Vec3>{Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0)});
    CHECK(vertices_of(r.mesh) == Indices{0, 1, 2});
}

TEST_CASE("a negative number counts from the last vertex so far") {
    const Read r = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
    CHECK(r.messages.empty());
    CHECK(vertices_of(r.mesh) == Indices{0, 1, 2, 0, 2, 3});
}

TEST_CASE("a face may name vertices that follow it") {
    CHECK(vertices_of(read("f 1 2 3\n" + square).mesh) == Indices{0, 1, 2});
}

TEST_CASE("a polygon is cut into triangles, less what is only a line") {
    CHECK(vertices_of(read(square + "f 1 2 3 4").mesh) == Indices{0, 1, 2, 0, 2, 3});
    CHECK(vertices_of(read(square + "f 1 2 3 3").mesh) == Indices{0, 1, 2});
    CHECK(vertices_of(read(square + "v 2 2 0\nf 1 2 3 4 5").mesh).size() == 9);
    const std::string dent = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n";
    CHECK(vertices_of(read(dent + "f 2 3 4 1").mesh) == Indices{0, 1, 2, 0, 2, 3});
}

TEST_CASE("a face that cannot be made is left out, with its own line and column") {
    const std::string start = "a.obj:5:", left_out = ": warning: face left out: ";
    const auto message = [&](const std::string& face) {
        const Read r = read(square + face + "\nf 1 2 3\n");
        CHECK(vertices_of(r.mesh) == Indices{0, 1, 2});
        REQUIRE(r.messages.size() == 1);
        return r.messages[0];
    };
    CHECK(message("f 1 2") == start + "1" + left_out + "2 corners, expected at least 3");
    CHECK(message("f") == start + "1" + left_out + "0 corners, expected at least 3");
    CHECK(message("f 1 2 5") == start + "7" + left_out + "no vertex 5 in a mesh of 4 vertices");
    CHECK(message("f 1 0 2") == start + "5" + left_out + "no vertex 0 in a mesh of 4 vertices");
    CHECK(message("f -5 1 2") == start + "3" + left_out + "no vertex -5 in a mesh of 4 vertices");
    CHECK(message("f 1//1 2 3") == start + "3" + left_out + "no normal 1 in a mesh of 0 normals");
    const std::string forms = "expected v, v/t, v//n or v/t/n, found ";
    CHECK(message("f 1 2 x") == start + "7" + left_out + forms + "'x'");
    CHECK(message("f 1 2 3.5") == start + "7" + left_out + forms + "'3.5'");
    CHECK(message("f 1 2 3/1/1/1") == start + "7" + left_out + forms + "'3/1/1/1'");
    CHECK(message("f 1 2 /1") == start + "7" + left_out + forms + "'/1'");
}

TEST_CASE("a vertex that cannot be read keeps its number and costs its faces") {
    const Read r = read("v 0 0 0\nv 1 zero 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    CHECK(r.messages ==
          std::vector<std::string>{
              "a.obj:2:5: warning: expected a number for the position of 'v', found 'zero'",
              "a.obj:5:5: warning: face left out: its vertex 2 could not be read"});
    CHECK(vertices_of(r.mesh) == Indices{0, 2, 3});
    CHECK(read("v 0 0\n").messages ==
          std::vector<std::string>{"a.obj:1:6: warning: expected a number for the position of "
                                   "'v', found the end of the line"});
}

TEST_CASE("the i-th normal belongs to the i-th vertex where no face says otherwise") {
    ObjMesh mesh = read(square + "vn 1 0 0\nvn 0 1 0\nvn 0 0 5\nvn 1 1 1\nf 2 3 4\n").mesh;
    complete_normals(mesh);
    CHECK(normals_of(mesh) == Indices{1, 2, 3});
    CHECK(mesh.normals[2] == Vec3(0, 0, 5));
}

TEST_CASE("normals that a file gives to some corners only are not dealt out by order") {
    ObjMesh mesh = read(square + "vn 1 0 0\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1 3 4\n").mesh;
    complete_normals(mesh);
    CHECK(mesh.triangles[0][0].normal == 0);
    CHECK(mesh.normals[mesh.triangles[1][0].normal] == Vec3(0, 0, 1));
}

TEST_CASE("missing and zero normals are the mean of the faces, weighted by area") {
    // At the origin a face of area 2 towards z meets one of area 1/2 towards x.
    const std::string corner = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 5\n";
    for (const std::string normals : {"", "vn 0 0 0\n"}) {
        ObjMesh mesh = read(corner + normals).mesh;
        complete_normals(mesh);
        const Vec3 n = mesh.normals[mesh.triangles[0][0].normal];
        CHECK(n.x / n.z == Approx(0.25).epsilon(1e-15));
        CHECK(n.dot(n) == Approx(1).epsilon(1e-15));
        CHECK(mesh.normals[mesh.triangles[0][1].normal] == Vec3(0, 0, 1));
    }
}

TEST_CASE("computed normals do not depend on the size of a mesh") {
    for (const std::string unit : {"e-200", "e200"}) {
        ObjMesh mesh = read("v 0 0 0\nv 3" + unit + " 0 0\nv 0 5" + unit + " 0\nf 1 2 3\n").mesh;
        complete_normals(mesh);
        CHECK(mesh.normals[mesh.triangles[0][2].normal] == Vec3(0, 0, 1));
    }
}

TEST_CASE("a mesh of damaged bytes gives indices that exist") {
    std::string text = square + "vn 0 0 1\nvn 0 1 0\n";
    for (int i = 0; i < 20; ++i) text += "v 1 2 3.5\nf -1 2//2 3/1/1 -4//-1\n";
    Random random(11);
    for (int i = 0; i < 1000; ++i) {
        std::string damaged =
            text.substr(0, i % 4 == 0 ? random.index(text.size()) + 1 : text.size());
        for (unsigned k = 0; k <= random.index(8); ++k) {
            damaged[random.index(damaged.size())] ^= static_cast<char>(1U << random.index(8));
        }
        ObjMesh mesh = read(damaged).mesh;
        complete_normals(mesh);
        for (const std::uint32_t v : vertices_of(mesh)) REQUIRE(v < mesh.vertices.size());
        for (const std::uint32_t n : normals_of(mesh)) REQUIRE(n < mesh.normals.size());
    }
}
