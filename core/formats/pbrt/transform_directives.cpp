// Statements that change the current transformation.
#include "core/formats/diagnostic_log.h"
#include "core/formats/pbrt/parser.h"
#include "core/formats/pbrt/transformations.h"

namespace etalon::pbrt {
namespace {

/// Replaces the current transformation, in place if nothing else refers to it: a scene may have
/// millions.
void replace(Parser& p, const TransformState& next) {
    std::shared_ptr<TransformState>& current = p.now.transform.current;
    if (!is_finite(next.start()) || (next.is_animated() && !is_finite(next.end()))) {
        p.log.error(p.in.where(), "range",
                    "'{}' is left out: it has a number that is not "
                    "finite, or leads to one",
                    p.in.directive());
    } else if (current.use_count() == 1) {
        *current = next;
    } else {
        current = std::make_shared<TransformState>(next);
    }
}

/// Changes the matrices of the active times. Refuses a result that is not finite.
template <class Change>
void change(Parser& p, Change changed) {
    if (!p.in.ok()) return;
    const TransformState& current = *p.now.transform.current;
    const auto [at_start, at_end] = p.now.transform.active;
    if (at_start && at_end && !current.is_animated()) {
        replace(p, TransformState(changed(current.start())));
    } else {
        replace(p, TransformState(at_start ? changed(current.start()) : current.start(),
                                  at_end ? changed(current.end()) : current.end()));
    }
}

void concatenate(Parser& p, const Matrix4& m) {
    change(p, [&](const Matrix4& current) { return current * m; });
}

Vec3 vec3(std::span<const double> numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

void read_identity(Parser& p) {
    change(p, [](const Matrix4&) { return Matrix4{}; });
}

void read_translate(Parser& p) {
    std::array<double, 3> n{};
    p.in.numbers(n, false);
    concatenate(p, translation(vec3(n)));
}

void read_scale(Parser& p) {
    std::array<double, 3> n{};
    p.in.numbers(n, false);
    concatenate(p, scaling(vec3(n)));
}

void read_rotate(Parser& p) {
    std::array<double, 4> n{};
    p.in.numbers(n, false);
    if (!p.in.ok()) return;
    if (const auto m = rotation(n[0], vec3(std::span(n).subspan(1)))) return concatenate(p, *m);
    p.log.error(p.in.where(), "degenerate", "'Rotate' is left out: its axis has no length");
}

void read_look_at(Parser& p) {
    std::array<double, 9> n{};
    p.in.numbers(n, false);
    if (!p.in.ok()) return;
    const std::span<const double> s(n);
    if (const auto m = look_at(vec3(s), vec3(s.subspan(3)), vec3(s.subspan(6)))) {
        return concatenate(p, *m);
    }
    p.log.error(p.in.where(), "degenerate",
                "'LookAt' is left out: it looks nowhere, or along its "
                "vector up");
}

void read_transform(Parser& p) {
    std::array<double, 16> n{};
    p.in.numbers(n, true);
    change(p, [&](const Matrix4&) { return from_columns(n); });
}

void read_concat_transform(Parser& p) {
    std::array<double, 16> n{};
    p.in.numbers(n, true);
    concatenate(p, from_columns(n));
}

void read_coordinate_system(Parser& p) {
    const std::string name = p.in.string("a name");
    if (p.in.ok()) p.now.coordinate_systems[name] = p.now.transform.current;
}

void read_coord_sys_transform(Parser& p) {
    const std::string name = p.in.string("a name");
    if (!p.in.ok()) return;
    const auto found = p.now.coordinate_systems.find(name);
    if (found != p.now.coordinate_systems.end()) {
        p.now.transform.current = found->second;
    } else {
        p.log.warn(p.in.where(), "undefined", "no coordinate system {} is defined",
                   in_quotes(name));
    }
}

struct ActiveTimes {
    std::string_view word;
    std::array<bool, 2> active;
};

constexpr std::array active_times = {ActiveTimes{"All", {true, true}},
                                     ActiveTimes{"StartTime", {true, false}},
                                     ActiveTimes{"EndTime", {false, true}}};

void read_active_transform(Parser& p) {
    constexpr std::string_view expected = "All, StartTime or EndTime";
    for (const ActiveTimes& times : active_times) {
        if (!p.in.at_word(times.word)) continue;
        p.in.word(expected);
        p.now.transform.active = times.active;
        return;
    }
    p.in.reject(expected);
}

void read_transform_times(Parser& p) {
    std::array<double, 2> n{};
    p.in.numbers(n, false);
    if (!p.in.ok()) return;
    if (std::isfinite(n[0]) && std::isfinite(n[1])) {
        p.frame().transform_times = n;
    } else {
        p.log.error(p.in.where(), "range",
                    "'TransformTimes' is left out: its times are not finite");
    }
}

void begin_transform(Parser& p) {
    p.now.saved_transforms.push_back({p.now.transform, false, p.in.where()});
}

void end_transform(Parser& p) {
    if (p.now.saved_transforms.empty()) {
        p.log.error(p.in.where(), "unmatched", "'TransformEnd' ends nothing");
        return;
    }
    if (p.now.saved_transforms.back().is_attribute) {
        p.log.warn(p.in.where(), "unmatched",
                   "'TransformEnd' ends what 'AttributeBegin' or "
                   "'ObjectBegin' began");
    }
    p.now.transform = std::move(p.now.saved_transforms.back().scope);
    p.now.saved_transforms.pop_back();
}

constexpr auto anywhere = Directive::Allowed::anywhere;
constexpr auto in_world = Directive::Allowed::in_world;

constexpr std::array directives = {
    Directive{"Translate", anywhere, read_translate},
    Directive{"Scale", anywhere, read_scale},
    Directive{"Rotate", anywhere, read_rotate},
    Directive{"LookAt", anywhere, read_look_at},
    Directive{"Identity", anywhere, read_identity},
    Directive{"Transform", anywhere, read_transform},
    Directive{"ConcatTransform", anywhere, read_concat_transform},
    Directive{"TransformBegin", in_world, begin_transform},
    Directive{"TransformEnd", in_world, end_transform},
    Directive{"CoordinateSystem", anywhere, read_coordinate_system},
    Directive{"CoordSysTransform", anywhere, read_coord_sys_transform},
    Directive{"ActiveTransform", anywhere, read_active_transform},
    Directive{"TransformTimes", Directive::Allowed::in_options, read_transform_times},
};

}  // namespace

std::span<const Directive> transform_directives() {
    return directives;
}

}  // namespace etalon::pbrt
