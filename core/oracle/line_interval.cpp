#include "core/oracle/line_interval.h"

namespace etalon::definition {

std::optional<LineInterval> within_box(const Vec3& min, const Vec3& max, const Ray& ray) {
    // A plane of the box is crossed at (plane - o) / d; quotients are compared by their products.
    struct PlaneCrossing {
        Tracked distance, speed;
    };
    if (Box3(min, max).isEmpty()) return std::nullopt;
    const auto is_later = [](const PlaneCrossing& a, const PlaneCrossing& b) {
        return is_positive(a.distance * b.speed - b.distance * a.speed);
    };
    std::array<PlaneCrossing, 3> in, out;
    std::size_t count = 0;
    for (int k = 0; k < 3; ++k) {
        const double o = ray.origin[k], d = ray.direction[k];
        if (d == 0) {
            if (!(o >= min[k] && o <= max[k])) return std::nullopt;
            continue;
        }
        const Tracked to_min = Tracked(min[k]) - o, to_max = Tracked(max[k]) - o;
        in[count] = d > 0 ? PlaneCrossing{to_min, d} : PlaneCrossing{-to_max, -d};
        out[count++] = d > 0 ? PlaneCrossing{to_max, d} : PlaneCrossing{-to_min, -d};
    }
    std::size_t last_in = 0, first_out = 0;
    Certainty exists = Certainty::yes;
    for (std::size_t i = 0; i < count; ++i) {
        if (is_later(in[i], in[last_in]) == Certainty::yes) last_in = i;
        if (is_later(out[first_out], out[i]) == Certainty::yes) first_out = i;
        for (std::size_t j = 0; j < count; ++j) {
            if (i != j) exists = exists & !is_later(in[i], out[j]);
        }
    }
    if (exists == Certainty::no) return std::nullopt;
    return LineInterval{in[last_in].distance / in[last_in].speed,
                        out[first_out].distance / out[first_out].speed, exists};
}

Crossings ends(const std::optional<LineInterval>& interval) {
    Crossings found;
    if (!interval || interval->exists == Certainty::no) return found;
    found.add({interval->entry, interval->exists, Certainty::yes});
    found.add({interval->exit, interval->exists, Certainty::no});
    return found;
}

}  // namespace etalon::definition
