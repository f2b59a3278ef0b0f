#include "core/scene/transformed.h"

#include "core/scene/quadric_form.h"

namespace etalon {
namespace {

class Similarity {
  public:
    Similarity(double factor, const Vec3& offset) : factor_(factor), offset_(offset) {}

    void operator()(Sphere& s) const { move(s.centre), scale(s.radius); }
    void operator()(Triangle&) const {}  // its corners are the scene's
    void operator()(Polygon&) const {}
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

    void operator()(Vec3& point) const { move(point); }
    void operator()(PointLight& l) const { move(l.position); }
    void operator()(QuadLight& l) const { move(l.corner), l.edge1 *= factor_, l.edge2 *= factor_; }
    void operator()(Camera& c) const { move(c.eye), move(c.at); }

    template <class T>
    void operator()(std::vector<T>& list) const {
        for (T& item : list) (*this)(item);
    }

    /// Whether all points so far are within the range of doubles.
    bool stayed_finite() const { return finite_; }

  private:
    void move(Vec3& p) const {
        p = factor_ * p + offset_;
        finite_ = is_finite(p) && finite_;
    }
    void scale(double& length) const { length *= factor_; }
    Affine after(const Affine& map) const {
        return {factor_ * map.x, factor_ * map.y, factor_ * map.z, factor_ * map.origin + offset_};
    }

    double factor_;
    Vec3 offset_;
    mutable bool finite_ = true;
};

}  // namespace

bool move_since(Scene& scene, std::size_t first_primitive, std::size_t first_vertex,
                const Vec3& offset) {
    const Similarity place(1, offset);
    for (std::size_t i = first_vertex; i < scene.vertices.size(); ++i) place(scene.vertices[i]);
    for (std::size_t i = first_primitive; i < scene.primitives.size(); ++i) {
        const Primitive& p = scene.primitives[i];
        with_shape(p.kind, [&]<class Shape>() { place(scene.all<Shape>()[p.index]); });
    }
    return place.stayed_finite();
}

Scene transformed(Scene scene, double factor, const Vec3& offset) {
    const Similarity place(factor, offset);
    std::apply([&](auto&... shapes) { (place(shapes), ...); }, scene.shapes);
    place(scene.vertices);
    place(scene.camera);
    for (Light& light : scene.lights) std::visit(place, light);
    return scene;
}

}  // namespace etalon
