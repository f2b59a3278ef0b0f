// Blocks, and what they save and restore: the matrix and the surface.
#include <cmath>

#include "core/formats/sce/sce_loader.h"
#include "core/numerics/transforms.h"

namespace etalon::sce {
namespace {

const char* name_of(bool braces) {
    return braces ? "{" : "push_matrix";
}

void open_block(Loader& loader, const Reader& in, bool braces) {
    loader.blocks.push_back({braces, in.start(), loader.state});
}

/// Closes a block. Both kinds save the same matrix, so they must not overlap. Ends without a block
/// have no effect.
std::optional<State> close_block(Loader& loader, Reader& in, bool braces) {
    if (loader.blocks.empty()) {
        in.warn("block", "'{}' without a '{}' before it; left out", in.keyword(), name_of(braces));
        return std::nullopt;
    }
    if (loader.blocks.back().braces != braces) {
        in.warn("block", "'{}' inside a '{}' that is still open; left out", in.keyword(),
                name_of(!braces));
        return std::nullopt;
    }
    State outside = loader.blocks.back().outside;
    loader.blocks.pop_back();
    return outside;
}

void apply(Loader& loader, const Affine& map) {
    loader.state.matrix = loader.state.matrix * map;
}

}  // namespace

void open_braces(Loader& loader, Reader& in) {
    open_block(loader, in, true);
}

void close_braces(Loader& loader, Reader& in) {
    if (const auto outside = close_block(loader, in, true)) loader.state = *outside;
}

void push_matrix(Loader& loader, Reader& in) {
    open_block(loader, in, false);
}

void pop_matrix(Loader& loader, Reader& in) {
    if (const auto outside = close_block(loader, in, false)) loader.state.matrix = outside->matrix;
}

/// Reproduces the course's own program, which had the sign of one sine wrong.
void rotate(Loader& loader, Reader& in) {
    const double degrees = in.number("angle");
    const Vec3 axis = in.vector("axis");
    if (!in.ok()) return;
    if (axis == Vec3(0)) return in.warn("range", "'rotate' left out: its axis is zero");
    Affine turn = rotation(degrees, axis);
    if (loader.options.legacy) turn.z.y = turn.y.z;
    apply(loader, turn);
}

void translate(Loader& loader, Reader& in) {
    const Vec3 offset = in.vector("offset");
    if (in.ok()) apply(loader, translation(offset));
}

void scale(Loader& loader, Reader& in) {
    const Vec3 factors = in.vector("factors");
    if (in.ok()) apply(loader, scaling(factors));
}

bool Loader::has_usable_matrix(Reader& in) const {
    if (!is_finite(state.matrix)) {
        in.warn("matrix", "'{}' left out: its matrix is not finite", in.keyword());
        return false;
    }
    if (is_singular(state.matrix)) {
        in.warn("matrix", "'{}' left out: its matrix is singular", in.keyword());
        return false;
    }
    return true;
}

}  // namespace etalon::sce
