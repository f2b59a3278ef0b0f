// Shapes of revolution as meshes: parts of a turn, and curves that no primitive has.
#include <numbers>

#include "core/formats/pbrt/build/shape_builder.h"

namespace etalon::pbrt {
namespace {

/// Points of the curve that turns about z, and how they move along it, at v in [0, 1]; in the plane
/// of x and z unless the shape is twisted.
struct ProfilePoint {
    Vec3 position, dpdv;
};

/// Rows and columns of a mesh of a whole turn: the middle of an edge is off by 1.3e-4 of the
/// radius.
constexpr int columns = 192, rows = 96;

Vec3 turned(const Vec3& p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/// The arrays of a mesh in the making.
struct SweptMesh {
    std::vector<float> points, normals, uvs;
    std::vector<std::uint32_t> corners;

    static void add(std::vector<float>& to, const Vec3& v) {
        for (const double x : {v.x, v.y, v.z}) to.push_back(static_cast<float>(x));
    }
};

/// Vertices of one row: `v` is the surface's coordinate there. The normal is that of dpdu x dpdv;
/// where the row is a point, that of the row's neighbourhood.
void add_row(const ProfilePoint& at, double v, double turn, SweptMesh& mesh) {
    for (int i = 0; i <= columns; ++i) {
        const double u = static_cast<double>(i) / columns, angle = u * turn;
        const Vec3 position = turned(at.position, angle), along = turned(at.dpdv, angle);
        Vec3 around(-position.y, position.x, 0);
        if (around == Vec3(0)) around = turned(Vec3(0, 1, 0), angle);
        SweptMesh::add(mesh.points, position);
        SweptMesh::add(mesh.normals, normalized(around.cross(along)));
        mesh.uvs.push_back(static_cast<float>(u));
        mesh.uvs.push_back(static_cast<float>(v));
    }
}

void add_corners(SweptMesh& mesh) {
    constexpr std::uint32_t stride = columns + 1;
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = j * stride + i, b = a + 1, c = a + stride, d = c + 1;
            const auto& p = mesh.points;
            const auto same = [&](std::uint32_t k, std::uint32_t l) {
                return std::equal(&p[3 * k], &p[3 * k + 3], &p[3 * l]);
            };
            if (!same(a, b)) mesh.corners.insert(mesh.corners.end(), {a, b, d});
            if (!same(c, d)) mesh.corners.insert(mesh.corners.end(), {a, d, c});
        }
    }
}

/// Builds the surface that profile(v) sweeps, its rows at the v that row_of gives for even steps.
template <class Profile, class Row>
void sweep(ShapeBuilder& s, const Profile& profile, const Row& row_of) {
    const double turn =
        std::clamp<double>(s.parameters().number("phimax"), 0, 360) * std::numbers::pi / 180;
    if (!(turn > 0)) return s.skip("it has no area");
    SweptMesh mesh;
    for (int j = 0; j <= rows; ++j) {
        const double v = row_of(static_cast<double>(j) / rows);
        add_row(profile(v), v, turn, mesh);
    }
    add_corners(mesh);
    build_mesh(s, {mesh.points, mesh.normals, mesh.uvs, mesh.corners, s.flips_normals()});
}

/// x^2 + y^2 = radius2 + widening z^2.
struct Waist {
    double radius2, widening;
};

/// The hyperboloid about z = 0 that pbrt-v3 draws for a line: it meets the line in p2 and where p1
/// is moved to by twice the way to p2, and is the surface that the line sweeps only where that is
/// narrowest at z = 0.
std::optional<Waist> waist_through(const Vec3& p1, const Vec3& p2) {
    Vec3 p = p1;
    for (int i = 0; i < 8; ++i) {
        p += 2.0 * (p2 - p1);
        const double squares = p.z * p.z - p2.z * p2.z, near2 = p2.x * p2.x + p2.y * p2.y;
        const double widening = (p.x * p.x + p.y * p.y - near2) / squares;
        if (std::isfinite(widening)) return Waist{near2 - widening * p2.z * p2.z, widening};
    }
    return std::nullopt;
}

double even(double x) {
    return x;
}

}  // namespace

void sweep_sphere(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double radius = std::abs(p.number("radius"));
    const auto angle = [&](std::string_view name) {
        return std::acos(std::clamp(p.number(name) / radius, -1.0, 1.0));
    };
    const double first = std::max(angle("zmin"), angle("zmax")),
                 last = std::min(angle("zmin"), angle("zmax"));
    sweep(
        s,
        [&](double v) {
            const double theta = first + v * (last - first);
            const Vec3 up(std::sin(theta), 0, std::cos(theta));
            const Vec3 along(std::cos(theta), 0, -std::sin(theta));
            return ProfilePoint{radius * up, (last - first) * radius * along};
        },
        even);
}

void sweep_disk(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double outer = p.number("radius"), inner = p.number("innerradius");
    sweep(
        s,
        [&](double v) {
            const double radius = outer + v * (inner - outer);
            return ProfilePoint{{radius, 0, p.number("height")}, {inner - outer, 0, 0}};
        },
        even);
}

void sweep_side(ShapeBuilder& s, const Circle& from, const Circle& to) {
    sweep(
        s,
        [&](double v) {
            const double z = from.z + v * (to.z - from.z);
            const double radius = from.radius + v * (to.radius - from.radius);
            return ProfilePoint{{radius, 0, z}, {to.radius - from.radius, 0, to.z - from.z}};
        },
        even);
}

void build_paraboloid(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double radius = p.number("radius"), z0 = std::min(p.number("zmin"), p.number("zmax")),
                 z1 = std::max(p.number("zmin"), p.number("zmax"));
    if (!(z1 > z0) || !(z0 >= 0) || !(radius > 0)) return s.skip("it has no area");
    const double narrow = std::sqrt(z0 / z1);
    sweep(
        s,
        [&](double v) {
            const double z = z0 + v * (z1 - z0), part = std::sqrt(z / z1);
            const Vec3 along(radius / (2 * z1 * std::max(part, 1e-6)), 0, 1);
            return ProfilePoint{{radius * part, 0, z}, (z1 - z0) * along};
        },
        [&](double x) {  // even steps of the radius
            const double part = narrow + x * (1 - narrow);
            return std::clamp((part * part * z1 - z0) / (z1 - z0), 0.0, 1.0);
        });
}

void build_hyperboloid(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    Vec3 p1(p.vector("p1")), p2(p.vector("p2"));
    if (p2.z == 0) std::swap(p1, p2);
    const std::optional<Waist> waist = waist_through(p1, p2);
    if (p1 == p2 || !waist) return s.skip("it has no area");
    sweep(
        s,
        [&](double v) {
            const Vec3 line = p1 + v * (p2 - p1);
            const double radius2 = waist->radius2 + waist->widening * line.z * line.z;
            const double part = std::sqrt(std::max(0.0, radius2)) / std::hypot(line.x, line.y);
            return ProfilePoint{{part * line.x, part * line.y, line.z}, p2 - p1};
        },
        even);
}

}  // namespace etalon::pbrt
