#include "core/formats/ply/ply.h"

#include <cmath>
#include <limits>

#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/formats/ply_text.h"

using namespace etalon;

namespace {

struct Read {
    std::optional<PlyMesh> mesh;
    std::vector<std::string> messages;
};

Read read(const std::string& bytes) {
    DiagnosticLog log("a.ply", bytes, false);
    Read r{read_ply(bytes, log), {}};
    for (const Diagnostic& d : log.take()) r.messages.push_back(to_string(d));
    return r;
}

template <class T>
std::vector<T> list(const FilledLater<T>& values) {
    return {values.begin(), values.end()};
}

using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;
using Messages = std::vector<std::string>;

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string corners = "property list uchar int vertex_indices\n";

/// A square, as a quadrilateral or as two triangles.
std::string square(const std::string& encoding, bool quadrilateral = false) {
    PlyText out(encoding, "element vertex 4\n" + xyz + "element face " +
                              (quadrilateral ? "1\n" : "2\n") + corners);
    out << 0.0F << 0.0F << 0.5F << 1.0F << 0.0F << 0.5F;
    out << 1.0F << 1.0F << 0.5F << 0.0F << 1.0F << 0.5F;
    using Byte = std::uint8_t;
    if (quadrilateral) {
        out << Byte(4) << 0 << 1 << 2 << 3;
    } else {
        out << Byte(3) << 0 << 1 << 2 << Byte(3) << 0 << 2 << 3;
    }
    return out.text();
}

const Floats square_positions{0, 0, 0.5F, 1, 0, 0.5F, 1, 1, 0.5F, 0, 1, 0.5F};

/// Returns an ASCII file with one triangle and the given header and vertices.
std::string ascii(const std::string& properties, const std::string& vertices,
                  const std::string& face = "3 0 1 2") {
    return "ply\nformat ascii 1.0\nelement vertex 3\n" + properties + "element face 1\n" + corners +
           "end_header\n" + vertices + face + "\n";
}

/// A mesh with all properties that are read, among many that are not.
struct Sample {
    Floats positions, normals, uvs;
    Indices indices;
    std::vector<std::int32_t> face_numbers;
};

std::string everything(const std::string& encoding, Sample& sample) {
    PlyText out(encoding,
                "comment made for a test\nobj_info of no interest\n"
                "element before 2\nproperty list ushort double a\nproperty short b\n"
                "element vertex 50\nproperty double z\nproperty float nx\nproperty uchar red\n"
                "property float x\nproperty float ny\nproperty list int8 int16 skipped\n"
                "property float y\nproperty float nz\nproperty float t\nproperty float s\n"
                "element empty 1000000000000\n"
                "element face 40\nproperty uchar flags\nproperty list uint int more\n"
                "property list int ushort vertex_index\nproperty int face_indices\n"
                "element after 3\nproperty list uchar char c\n");
    Random random(5);
    const auto number = [&] {
        return static_cast<float>(static_cast<int>(random.index(2000)) - 1000) / 8;
    };
    out << std::uint16_t(2) << 1.5 << 2.5 << std::int16_t(-3) << std::uint16_t(0)
        << std::int16_t(4);
    for (int i = 0; i < 50; ++i) {
        const float x = number(), y = number(), z = number(), nx = number(), ny = number(),
                    nz = number(), s = number(), t = number();
        out << double{z} << nx << std::uint8_t(i) << x << ny << std::int8_t(i % 3);
        for (int k = 0; k < i % 3; ++k) out << std::int16_t(-k);
        out << y << nz << t << s;
        sample.positions.insert(sample.positions.end(), {x, y, z});
        sample.normals.insert(sample.normals.end(), {nx, ny, nz});
        sample.uvs.insert(sample.uvs.end(), {s, t});
    }
    for (int i = 0; i < 40; ++i) {
        out << std::uint8_t(7) << std::uint32_t(i % 2);
        if (i % 2 == 1) out << i;
        const int count = 3 + i % 2;
        out << count;
        std::uint32_t c[4];
        for (int k = 0; k < count; ++k) out << static_cast<std::uint16_t>(c[k] = random.index(50));
        out << i - 10;
        sample.indices.insert(sample.indices.end(), {c[0], c[1], c[2]});
        if (count == 4) sample.indices.insert(sample.indices.end(), {c[3], c[0], c[2]});
        sample.face_numbers.insert(sample.face_numbers.end(), static_cast<std::size_t>(count - 2),
                                   i - 10);
    }
    for (int i = 0; i < 3; ++i) out << std::uint8_t(1) << std::int8_t(i);
    return out.text();
}

}  // namespace

TEST_CASE("a byte order mark at the start of a PLY file is skipped") {
    for (const char* encoding : {"ascii", "binary_little_endian"}) {
        CAPTURE(encoding);
        const Read marked = read("\xEF\xBB\xBF" + square(encoding));
        CHECK(marked.messages == Messages{});
        REQUIRE(marked.mesh);
        CHECK(list(marked.mesh->indices) == list(read(square(encoding)).mesh->indices));
    }
}

TEST_CASE("lines of a PLY header may end with CR alone, also before bytes that are line feeds") {
    for (const std::string& encoding : ply_encodings) {
        CAPTURE(encoding);
        std::string text = square(encoding);
        const std::size_t header = text.find("end_header\n") + 11;
        std::replace(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(header), '\n', '\r');
        const Read r = read(text);
        CHECK(r.messages.empty());
        REQUIRE(r.mesh);
        CHECK(list(r.mesh->positions) == square_positions);
    }
    PlyText out("binary_little_endian", "element vertex 3\n" + xyz + "element face 1\n" + corners);
    const float line_feeds = std::bit_cast<float>(0x0A0A0A0AU);
    out << line_feeds << 0.0F << 0.0F << 1.0F << 0.0F << 0.0F << 0.0F << 1.0F << 0.0F;
    out << std::uint8_t{3} << 0 << 1 << 2;
    std::string text = out.text();
    const std::size_t header = text.find("end_header\n") + 11;
    std::replace(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(header), '\n', '\r');
    const Read r = read(text);
    REQUIRE(r.mesh);
    CHECK(list(r.mesh->positions)[0] == line_feeds);
}

TEST_CASE("vertices and triangles of a PLY file are read in every encoding") {
    for (const std::string& encoding : ply_encodings) {
        CAPTURE(encoding);
        const Read r = read(square(encoding));
        CHECK(r.messages.empty());
        REQUIRE(r.mesh);
        CHECK(list(r.mesh->positions) == square_positions);
        CHECK(list(r.mesh->indices) == Indices{0, 1, 2, 0, 2, 3});
        CHECK(r.mesh->normals.empty());
        CHECK(r.mesh->uvs.empty());
        CHECK(r.mesh->face_numbers.empty());
    }
}

TEST_CASE("a quadrilateral of a PLY file is cut as PBRT v3 cuts it") {
    for (const std::string& encoding : ply_encodings) {
        CAPTURE(encoding);
        const Read r = read(square(encoding, true));
        REQUIRE(r.mesh);
        CHECK(list(r.mesh->indices) == Indices{0, 1, 2, 3, 0, 2});
    }
}

TEST_CASE("unused properties of a mesh are skipped in every encoding") {
    for (const std::string& encoding : ply_encodings) {
        CAPTURE(encoding);
        Sample sample;
        const Read r = read(everything(encoding, sample));
        CHECK(r.messages.empty());
        REQUIRE(r.mesh);
        CHECK(list(r.mesh->positions) == sample.positions);
        CHECK(list(r.mesh->normals) == sample.normals);
        CHECK(list(r.mesh->uvs) == sample.uvs);
        CHECK(list(r.mesh->indices) == sample.indices);
        CHECK(r.mesh->face_numbers == sample.face_numbers);
    }
}

TEST_CASE("large binary files of triangles and quadrilaterals are read as small ones are") {
    for (const std::string& encoding : ply_encodings) {
        CAPTURE(encoding);
        constexpr int vertices = 20000, faces = 30000;
        PlyText out(encoding, "element vertex 20000\n" + xyz +
                                  "property double u\nproperty uchar v\n" +
                                  "element face 30000\nproperty short before\n" + corners +
                                  "property uchar behind\n");
        Random random(6);
        Floats positions, uvs;
        for (int i = 0; i < vertices; ++i) {
            const auto x = static_cast<float>(random.index(1000)), y = static_cast<float>(i);
            out << x << y << -x << double{x / 4} << std::uint8_t(i);
            positions.insert(positions.end(), {x, y, -x});
            uvs.insert(uvs.end(), {x / 4, static_cast<float>(i % 256)});
        }
        Indices indices;
        for (int i = 0; i < faces; ++i) {
            const auto count = static_cast<std::uint8_t>(3 + random.index(2));
            std::uint32_t c[4];
            out << std::int16_t(i) << count;
            for (int k = 0; k < count; ++k) out << static_cast<int>(c[k] = random.index(vertices));
            out << std::uint8_t(i);
            indices.insert(indices.end(), {c[0], c[1], c[2]});
            if (count == 4) indices.insert(indices.end(), {c[3], c[0], c[2]});
        }
        const Read r = read(out.text());
        REQUIRE(r.mesh);
        CHECK(list(r.mesh->positions) == positions);
        CHECK(list(r.mesh->uvs) == uvs);
        CHECK(list(r.mesh->indices) == indices);
    }
}

TEST_CASE("texture coordinates go by four pairs of names") {
    const std::string vertices = "0 0 0 1 2\n0 0 0 3 4\n0 0 0 5 6\n";
    for (const auto& [u, v] : std::vector<std::pair<std::string, std::string>>{
             {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
        const Read r =
            read(ascii(xyz + "property float " + u + "\nproperty float " + v + "\n", vertices));
        CAPTURE(u);
        REQUIRE(r.mesh);
        CHECK(list(r.mesh->uvs) == Floats{1, 2, 3, 4, 5, 6});
    }
    const Read mixed = read(ascii(xyz + "property float u\nproperty float t\n", vertices));
    REQUIRE(mixed.mesh);
    CHECK(mixed.mesh->uvs.empty());
    const Read normal = read(ascii(xyz + "property float nx\nproperty float ny\n", vertices));
    REQUIRE(normal.mesh);
    CHECK(normal.mesh->normals.empty());
}

TEST_CASE("faces of many corners are left out with a warning") {
    for (const std::string face : {"2 0 1", "5 0 1 2 0 1", "0"}) {
        const Read r = read(ascii(xyz, "0 0 0 1 0 0 0 1 0\n", face));
        REQUIRE(r.mesh);
        CHECK(r.mesh->indices.empty());
        CHECK(r.messages == Messages{"a.ply:7:1: warning: 1 faces left out: only those of 3 and 4 "
                                     "corners are supported"});
    }
}

TEST_CASE("a list of a negative number of values is an error") {
    for (const std::string& encoding : ply_encodings) {
        PlyText out(encoding, "element vertex 1\n" + xyz +
                                  "element face 2\nproperty list char int vertex_indices\n");
        out << 0.0F << 0.0F << 0.0F << std::int8_t(-1) << 0 << 0 << 0 << 0 << 0 << 0;
        const Read r = read(out.text());
        CAPTURE(encoding);
        CHECK_FALSE(r.mesh);
        REQUIRE(r.messages.size() == 1);
        CHECK(r.messages[0].ends_with("error: found a list of -1 values amid the elements 'face'"));
    }
}

TEST_CASE("a face of a PLY file that names no vertex is an error") {
    for (const std::string face : {"3 0 1 3", "3 0 1 -1", "3 0 1 1e30"}) {
        const Read r = read(ascii(xyz, "0 0 0 1 0 0 0 1 0\n", face));
        CAPTURE(face);
        CHECK_FALSE(r.mesh);
        CHECK(r.messages ==
              Messages{"a.ply: error: triangle 1 names a vertex that is not among the "
                       "3 of the mesh"});
    }
}

TEST_CASE("triangles at vertices that are not finite are left out") {
    const Read r = read(ascii(xyz, "0 0 nan 1 0 -inf 0 1 1e400\n"));
    REQUIRE(r.mesh);
    CHECK(r.mesh->indices.empty());
    CHECK(r.messages ==
          Messages{"a.ply: warning: 1 triangles left out: a corner of them is not finite"});
    const Read n = read(ascii(xyz + "property float nx\nproperty float ny\nproperty float nz\n",
                              "0 0 0 nan 1 2 0 0 0 3 4 5 0 0 0 6 7 1e39\n"));
    REQUIRE(n.mesh);
    CHECK(list(n.mesh->normals) == Floats{0, 1, 2, 3, 4, 5, 6, 7, 0});
    CHECK(n.messages ==
          Messages{"a.ply: warning: 2 numbers of the normals are not finite: taken as 0"});
}

TEST_CASE("a header that is wrong is an error with its line") {
    const auto message = [](const std::string& text) {
        const Read r = read(text);
        CHECK_FALSE(r.mesh);
        REQUIRE(r.messages.size() == 1);
        return r.messages[0];
    };
    const std::string start = "ply\nformat ascii 1.0\n";
    CHECK(message("") == "a.ply:1:1: error: expected 'ply' at the start of a PLY file");
    CHECK(message("plyx\n") == "a.ply:1:1: error: expected 'ply' at the start of a PLY file");
    CHECK(message("ply\nformat ascii 1.0\n") ==
          "a.ply:3:1: error: the file ends before 'end_header'");
    CHECK(message("ply\nformat text 1.0\nend_header\n") ==
          "a.ply:2:1: error: expected the format ascii, binary_little_endian or binary_big_endian, "
          "found 'text'");
    CHECK(message("ply\nend_header\n") == "a.ply:2:1: error: the header does not say a format");
    CHECK(message(start + "elements vertex 3\n") ==
          "a.ply:3:1: error: expected a statement of the header, found 'elements'");
    CHECK(message(start + "element vertex -3\nend_header\n") ==
          "a.ply:3:1: error: expected the number of elements 'vertex', found '-3'");
    CHECK(message(start + "element a 3\nelement a 3\nend_header\n") ==
          "a.ply:4:1: error: there are elements 'a' already");
    CHECK(message(start + "property float x\nend_header\n") ==
          "a.ply:3:1: error: a property before the first element");
    CHECK(message(start + "element a 3\nproperty half x\nend_header\n") ==
          "a.ply:4:1: error: expected the type of a number, found 'half'");
    CHECK(message(start + "element a 3\nproperty list float int x\nend_header\n") ==
          "a.ply:4:1: error: the number of values of a list must be an integer");
    CHECK(message(start + "element a 3\nproperty int\nend_header\n") ==
          "a.ply:4:1: error: a property without a name");
    CHECK(message(start + "end_header\n") ==
          "a.ply:1:1: error: a mesh needs elements 'vertex' and 'face'");
    CHECK(message(start + "element vertex 0\nelement face 1\nend_header\n") ==
          "a.ply:3:1: error: there are no vertices");
    CHECK(message(start + "element vertex 1\nelement face 0\nend_header\n") ==
          "a.ply:4:1: error: there are no faces");
    CHECK(message(start + "element vertex 1\nproperty float x\nelement face 1\nend_header\n") ==
          "a.ply:3:1: error: the vertices have no x, y and z");
    CHECK(message(start + "element vertex 1\n" + xyz + "element face 1\nend_header\n") ==
          "a.ply:7:1: error: the faces have no list 'vertex_indices'");
}

TEST_CASE("a word among the numbers of a PLY file is an error with its position") {
    const Read r = read(ascii(xyz, "0 0 0 1 0 x\n0 1 0\n"));
    CHECK_FALSE(r.mesh);
    CHECK(r.messages ==
          Messages{"a.ply:10:11: error: expected a number, found 'x' amid the elements 'vertex'"});
}

TEST_CASE("counts that the file cannot hold are an error before any memory is taken") {
    for (const std::string& encoding : ply_encodings) {
        for (const std::string count : {"9", "4000000000", "18446744073709551615"}) {
            std::string text = square(encoding);
            text.replace(text.find("vertex 4") + 7, 1, count);
            const Read r = read(text);
            CAPTURE(encoding, count);
            CHECK_FALSE(r.mesh);
            CHECK(r.messages.size() == 1);
        }
        std::string text = square(encoding);
        text.replace(text.find("face 2") + 5, 1, "2000000000");
        CHECK_FALSE(read(text).mesh);
    }
}

TEST_CASE("a PLY file cut anywhere is an error") {
    for (const std::string& encoding : ply_encodings) {
        Sample sample;
        for (const std::string& whole : {square(encoding), everything(encoding, sample)}) {
            const std::size_t last = whole.find_last_not_of(" \r\n");
            for (std::size_t size = 0; size < last; ++size) {
                const Read r = read(whole.substr(0, size));
                CAPTURE(encoding, size);
                REQUIRE_FALSE(r.mesh);
                REQUIRE(r.messages.size() == 1);
            }
        }
    }
}

TEST_CASE("a PLY file with any bytes flipped is a mesh of vertices that there are, or an error") {
    Random random(8);
    for (const std::string& encoding : ply_encodings) {
        Sample sample;
        for (const std::string& whole : {square(encoding), everything(encoding, sample)}) {
            for (int i = 0; i < 4000; ++i) {
                std::string damaged = whole;
                for (unsigned k = 0; k <= random.index(4); ++k) {
                    damaged[random.index(damaged.size())] ^=
                        static_cast<char>(1U << random.index(8));
                }
                const Read r = read(damaged);
                if (!r.mesh) {
                    REQUIRE(r.messages.size() >= 1);
                    continue;
                }
                const PlyMesh& m = *r.mesh;
                REQUIRE(m.indices.size() % 3 == 0);
                REQUIRE((m.normals.empty() || m.normals.size() == m.positions.size()));
                REQUIRE((m.face_numbers.empty() || m.face_numbers.size() == m.indices.size() / 3));
                REQUIRE(m.positions.capacity() + m.indices.capacity() < 96 + 8 * damaged.size());
                for (const std::uint32_t v : m.indices) {
                    REQUIRE(3 * v < m.positions.size());
                    REQUIRE(std::isfinite(m.positions[3 * v]));
                }
            }
        }
    }
}
