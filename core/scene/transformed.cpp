#include "core/scene/transformed.h"

#include "core/scene/quadric_form.h"

namespace etalon {
namespace {

/// Converts decimal vertices to doubles: coordinates that were moved or scaled have all digits.
void decode_vertices(Geometry& g) {
    const auto first = static_cast<std::uint32_t>(g.vertices.size());
    for (std::uint32_t i = 0; i < g.decimal_vertices.size(); ++i) {
        g.vertices.push_back(g.vertex(i | decimal_vertex));
    }
    g.decimal_vertices.clear();
    TriangleList triangles;
    for (TriangleIndices t : g.all<Triangle>()) {
        for (std::uint32_t& v : t) {
            if ((v & decimal_vertex) != 0) v = first + (v & ~decimal_vertex);
        }
        triangles.push_back(t);
    }
    g.all<Triangle>() = std::move(triangles);
}

class Similarity {
  public:
    Similarity(double factor, const Vec3& offset) : factor_(factor), offset_(offset) {}

    void operator()(Sphere& s) const { move(s.centre), scale(s.radius); }
    void operator()(TriangleList&) const {}  // its vertices are moved elsewhere
    void operator()(PolygonList& polygons) const {
        polygons.change_corners([this](Vec3& corner) { move(corner); });
    }
    void operator()(Box& b) const { move(b.min), move(b.max); }
    void operator()(Plane& p) const { move(p.point); }
    void operator()(Cone& c) const {
        move(c.base), move(c.top);
        scale(c.base_radius), scale(c.top_radius);
    }
    void operator()(Ring& r) const { move(r.centre), scale(r.inner), scale(r.outer); }
    void operator()(Quadric& q) const {
        move(q.centre), move(q.clip.min), move(q.clip.max);
        q.coefficients = scaled(q.coefficients, factor_);
    }
    void operator()(Ellipsoid& e) const { e = Ellipsoid(after(e.to_world)); }
    void operator()(ClosedCylinder& c) const { c = ClosedCylinder(after(c.to_world)); }
    void operator()(Revolved& s) const { s = s.under(after(s.to_world)); }

    void operator()(CurveList& curves) const {
        curves.change_maps([this](const Affine& map) { return after(map); });
    }

    void operator()(Geometry& g) const {
        decode_vertices(g);
        std::apply([&](auto&... shapes) { ((*this)(shapes), ...); }, g.shapes);
        (*this)(g.vertices);
        (*this)(g.instances);
        for (AnimatedTransform& motion : g.motions) motion = motion.after(factor_, offset_);
    }
    void operator()(Instance& i) const {
        move(i.origin);
        for (Vec3& row : i.rows) row /= factor_;
    }
    void operator()(Vec3& point) const { move(point); }
    void operator()(PointLight& l) const { move(l.position); }
    void operator()(QuadLight& l) const { move(l.corner), l.edge1 *= factor_, l.edge2 *= factor_; }
    void operator()(Camera& c) const {
        move(c.eye), move(c.at);
        if (c.projective) (*this)(*c.projective);
    }
    void operator()(ProjectiveCamera& c) const {
        c.to_world = after(c.to_world);
        if (c.motion) c.motion = c.motion->after(factor_, offset_);
    }
    void operator()(PointSource& s) const { move(s.position), brighten(s.intensity); }
    void operator()(SpotSource& s) const { move(s.position), brighten(s.intensity); }
    void operator()(GoniometricSource& s) const { move(s.position), brighten(s.intensity); }
    void operator()(ProjectionSource& s) const { move(s.position), brighten(s.intensity); }
    void operator()(DistantSource&) const {}
    void operator()(InfiniteSource&) const {}
    void operator()(AreaSource&) const {}
    void operator()(UvMapping&) const {}
    void operator()(SphericalMapping& m) const { m.to_texture = before(m.to_texture); }
    void operator()(CylindricalMapping& m) const { m.to_texture = before(m.to_texture); }
    void operator()(PlanarMapping& m) const {
        m.u_offset -= static_cast<float>(m.u_axis.dot(offset_) / factor_);
        m.v_offset -= static_cast<float>(m.v_axis.dot(offset_) / factor_);
        m.u_axis /= factor_, m.v_axis /= factor_;
    }
    template <class Texture>
    void place_texture(Texture& texture) const {
        if constexpr (requires { texture.mapping; }) std::visit(*this, texture.mapping);
        if constexpr (requires { texture.to_texture; }) {
            texture.to_texture = before(texture.to_texture);
        }
    }
    void operator()(Textures& textures) const {
        const auto place = [this](auto& texture) { place_texture(texture); };
        for (auto& texture : textures.numbers) std::visit(place, texture);
        for (auto& texture : textures.colors) std::visit(place, texture);
    }
    void operator()(WhittedLook& look) const {
        for (Light& light : look.lights) std::visit(*this, light);
    }
    void operator()(PhysicalLook& look) const {
        for (PhysicalLight& light : look.lights) std::visit(*this, light);
        for (PhysicalMedium& medium : look.media) (*this)(medium);
        for (PhysicalMaterial& material : look.materials) std::visit(*this, material.kind);
        (*this)(look.textures);
    }
    void operator()(DisneyMaterial& m) const { m.unit *= static_cast<float>(factor_); }
    void operator()(SubsurfaceMaterial& m) const { m.factor /= static_cast<float>(factor_); }
    void operator()(KdSubsurfaceMaterial& m) const { m.unit *= static_cast<float>(factor_); }
    template <class Material>
    void operator()(Material&) const {}  // nothing in it is a length

    /// Keeps the optical thickness over a distance that is `factor` times as long.
    void operator()(PhysicalMedium& medium) const {
        medium.absorption /= static_cast<float>(factor_);
        medium.scattering /= static_cast<float>(factor_);
        if (medium.grid) medium.grid->to_box = before(medium.grid->to_box);
    }

    template <class T>
    void operator()(LargeVector<T>& list) const {
        for (T& item : list) (*this)(item);
    }

    /// Returns whether all points so far are within the range of double.
    bool stayed_finite() const { return finite_; }

  private:
    void move(Vec3& p) const {
        p = factor_ * p + offset_;
        finite_ = is_finite(p) && finite_;
    }
    void scale(double& length) const { length *= factor_; }
    /// Keeps the brightness at places that are `factor` times as far away.
    void brighten(Color& intensity) const { intensity *= static_cast<float>(factor_ * factor_); }
    Affine after(const Affine& map) const {
        return {factor_ * map.x, factor_ * map.y, factor_ * map.z, factor_ * map.origin + offset_};
    }

    /// Returns the map of a point as it was before the transformation.
    Affine before(const Affine& map) const {
        const double f = 1 / factor_;
        return map * Affine{{f, 0, 0}, {0, f, 0}, {0, 0, f}, -f * offset_};
    }

    double factor_;
    Vec3 offset_;
    mutable bool finite_ = true;
};

}  // namespace

std::optional<Geometry> moved(Geometry geometry, const Vec3& offset) {
    const Similarity place(1, offset);
    place(geometry);
    if (!place.stayed_finite()) return std::nullopt;
    return geometry;
}

Scene transformed(Scene scene, double factor, const Vec3& offset) {
    const Similarity place(factor, offset);
    place(scene.geometry);
    place(scene.camera);
    std::visit(place, scene.look);
    return scene;
}

}  // namespace etalon
