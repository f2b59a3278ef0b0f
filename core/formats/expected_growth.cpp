#include "core/formats/expected_growth.h"

namespace etalon {
namespace {

constexpr std::size_t much = 1000;  ///< items; fewer say little of what is to come

std::size_t grown(std::size_t size, double factor) {
    return static_cast<std::size_t>(static_cast<double>(size) * factor);
}

template <class T>
void make_room(LargeVector<T>& v, double factor) {
    if (v.size() >= much) v.reserve(grown(v.size(), factor));
}

void make_room(TriangleList& v, double factor) {
    if (v.size() >= much) v.reserve(grown(v.size(), factor) - v.size());
}

void make_room(PolygonList& v, double factor) {
    if (v.size() >= much) v.make_room(factor);
}

/// Does nothing: the number of parts of a curve is not known in advance.
void make_room(CurveList&, double) {}

}  // namespace

void make_room_for_growth(Geometry& g, double factor) {
    std::apply([&](auto&... list) { (make_room(list, factor), ...); }, g.shapes);
    make_room(g.vertices, factor);
    make_room(g.normals, factor);
}

}  // namespace etalon
