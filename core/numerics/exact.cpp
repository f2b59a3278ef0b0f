#include "core/numerics/exact.h"

namespace etalon {
namespace {

Expansion difference(double a, double b) { return Expansion(two_difference(a, b)); }

/// x * y - z * w, exactly.
Expansion minor(const Expansion& x, const Expansion& y, const Expansion& z, const Expansion& w) {
    Expansion result = x * y;
    result += -(z * w);
    return result;
}

}  // namespace

Expansion::Expansion(TwoTerm t) {
    if (t.error != 0) terms_.push_back(t.error);
    if (t.value != 0) terms_.push_back(t.value);
}

void Expansion::add(double x) {
    // Grow-expansion with zero elimination (Shewchuk 1997, fig. 6).
    std::size_t kept = 0;
    for (const double term : terms_) {
        const TwoTerm s = two_sum(x, term);
        if (s.error != 0) terms_[kept++] = s.error;
        x = s.value;
    }
    terms_.resize(kept);
    if (x != 0) terms_.push_back(x);
}

Expansion& Expansion::operator+=(const Expansion& other) {
    for (const double term : other.terms_) add(term);
    return *this;
}

Expansion Expansion::operator*(const Expansion& other) const {
    Expansion result;
    for (const double a : terms_) {
        for (const double b : other.terms_) {
            const TwoTerm p = two_product(a, b);
            result.add(p.error);
            result.add(p.value);
        }
    }
    return result;
}

Expansion Expansion::operator-() const {
    Expansion result = *this;
    for (double& term : result.terms_) term = -term;
    return result;
}

double Expansion::estimate() const {
    double sum = 0;
    for (const double term : terms_) sum += term;
    return sum;
}

double exact_edge_volume(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b) {
    const Expansion px = difference(a.x, o.x), py = difference(a.y, o.y), pz = difference(a.z, o.z);
    const Expansion qx = difference(b.x, o.x), qy = difference(b.y, o.y), qz = difference(b.z, o.z);
    Expansion sum = Expansion({d.x, 0}) * minor(py, qz, pz, qy);
    sum += Expansion({d.y, 0}) * minor(pz, qx, px, qz);
    sum += Expansion({d.z, 0}) * minor(px, qy, py, qx);
    return sum.estimate();
}

}  // namespace etalon
