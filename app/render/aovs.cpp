#include "app/render/aovs.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/common/backends.h"
#include "core/formats/nearest_name.h"
#include "core/render/image_film.h"

namespace etalon {
namespace {

/// Data from which channels are made. The film is always present.
struct AovInputs {
    const Film& film;
    std::optional<SurfaceMeans> means{};
    std::optional<CentreHits> centres{};
    std::optional<CentreParametrizations> parametrizations{};
};

enum class Source { film, means, centres, parametrizations };

using Values = std::variant<std::vector<float>, std::vector<std::uint32_t>, std::vector<Color>,
                            std::vector<Vec3f>, std::vector<Imath::V2f>>;

struct Aov {
    std::string_view name;
    Source source;
    Values (*values)(const AovInputs&);
    std::string_view axes = {};           ///< suffixes of the channels, if there are several
    bool Backend::*is_counted = nullptr;  ///< what the backend must count
};

Values tests(const CentreHits& hits, std::uint64_t TraversalCost::*count) {
    std::vector<float> values;
    for (const TraversalCost& cost : hits.costs) values.push_back(static_cast<float>(cost.*count));
    return values;
}

/// Table of all AOVs. To add one, add a line.
constexpr Aov aovs[] = {
    {"albedo", Source::means, [](const AovInputs& i) -> Values { return i.means->albedo.pixels(); },
     "RGB"},
    {"N", Source::means, [](const AovInputs& i) -> Values { return i.means->normal.pixels(); },
     "XYZ"},
    {"P", Source::centres, [](const AovInputs& i) -> Values { return i.centres->positions; },
     "XYZ"},
    {"Z", Source::centres, [](const AovInputs& i) -> Values { return i.centres->depths; }},
    {"uv", Source::parametrizations,
     [](const AovInputs& i) -> Values { return i.parametrizations->uv; }, "UV"},
    {"dpdu", Source::parametrizations,
     [](const AovInputs& i) -> Values { return i.parametrizations->dpdu; }, "XYZ"},
    {"dpdv", Source::parametrizations,
     [](const AovInputs& i) -> Values { return i.parametrizations->dpdv; }, "XYZ"},
    {"primitiveId", Source::centres,
     [](const AovInputs& i) -> Values { return i.centres->primitives; }},
    {"instanceId", Source::centres,
     [](const AovInputs& i) -> Values { return i.centres->instances; }},
    {"variance", Source::film, [](const AovInputs& i) -> Values { return i.film.variances(); },
     "RGB"},
    {"sampleCount", Source::film,
     [](const AovInputs& i) -> Values {
         return std::vector<float>(i.film.counts().begin(), i.film.counts().end());
     }},
    {"cost.boxTests",
     Source::centres,
     [](const AovInputs& i) { return tests(*i.centres, &TraversalCost::box_tests); },
     {},
     &Backend::counts_box_tests},
    {"cost.primitiveTests",
     Source::centres,
     [](const AovInputs& i) { return tests(*i.centres, &TraversalCost::primitive_tests); },
     {},
     &Backend::counts_primitive_tests},
};

using Names = std::vector<std::string>;

std::vector<std::string_view> all_names() {
    std::vector<std::string_view> names;
    for (const Aov& aov : aovs) names.push_back(aov.name);
    return names;
}

/// Returns the AOVs of these names, without duplicates.
std::vector<Aov> selected(const Names& names) {
    std::vector<Aov> list;
    std::copy_if(std::begin(aovs), std::end(aovs), std::back_inserter(list), [&](const Aov& aov) {
        return std::find(names.begin(), names.end(), aov.name) != names.end();
    });
    return list;
}

bool any_from(const std::vector<Aov>& list, Source source) {
    return std::any_of(list.begin(), list.end(), [&](auto& aov) { return aov.source == source; });
}

bool is_there(const AovInputs& there, Source source) {
    switch (source) {
        case Source::means:
            return there.means.has_value();
        case Source::centres:
            return there.centres.has_value();
        case Source::parametrizations:
            return there.parametrizations.has_value();
        default:
            return true;
    }
}

/// Returns the bytes of a pixel in what channels are made from, beside the image's own film.
double bytes_of(Source source) {
    switch (source) {
        case Source::means:
            return 2 * ImageFilm::bytes_per_pixel({});
        case Source::centres:
            return sizeof(Vec3f) + sizeof(float) + 2 * sizeof(std::uint32_t) +
                   sizeof(TraversalCost);
        case Source::parametrizations:
            return sizeof(Imath::V2f) + 2 * sizeof(Vec3f);
        default:
            return 0;
    }
}

void add(const Aov& aov, std::vector<float> values, std::vector<Channel>& channels) {
    channels.push_back({std::string(aov.name), std::move(values)});
}
void add(const Aov& aov, std::vector<std::uint32_t> values, std::vector<Channel>& channels) {
    channels.push_back({std::string(aov.name), std::move(values)});
}

template <class Vector>
void add(const Aov& aov, const std::vector<Vector>& vectors, std::vector<Channel>& channels) {
    for (std::size_t k = 0; k < aov.axes.size(); ++k) {
        std::vector<float> values;
        values.reserve(vectors.size());
        for (const Vector& v : vectors) values.push_back(v[static_cast<int>(k)]);
        channels.push_back({fmt::format("{}.{}", aov.name, aov.axes[k]), std::move(values)});
    }
}

}  // namespace

std::string check_aov(const std::string& name) {
    const std::vector<std::string_view> names = all_names();
    if (std::find(names.begin(), names.end(), name) != names.end()) return {};
    return fmt::format("{}: expected one of {}{}", name, fmt::join(names, ", "),
                       did_you_mean(name, names));
}

std::vector<std::string> aov_names() {
    const std::vector<std::string_view> names = all_names();
    return {names.begin(), names.end()};
}

bool need_variance(const Names& names) {
    return std::ranges::find(names, "variance") != names.end();
}

bool need_materials(const Names& names) {
    return std::ranges::find(names, "albedo") != names.end();
}

double aov_bytes_per_pixel(const Names& names) {
    const std::vector<Aov> list = selected(names);
    double bytes = 0;
    for (const Source source : {Source::means, Source::centres, Source::parametrizations}) {
        if (any_from(list, source)) bytes += bytes_of(source);
    }
    for (const Aov& aov : list) {
        bytes += static_cast<double>(sizeof(float) * std::max<std::size_t>(aov.axes.size(), 1));
    }
    return bytes;
}

std::string check_aovs(const Names& names, const Backend& backend) {
    for (const Aov& aov : selected(names)) {
        if (aov.is_counted == nullptr || backend.*aov.is_counted) continue;
        Names able;
        for (const Backend& other : all_backends()) {
            if (other.*aov.is_counted) able.emplace_back(other.name);
        }
        return fmt::format("--aov {}: the backend {} does not count that; expected one of {}",
                           aov.name, backend.name, fmt::join(able, ", "));
    }
    return {};
}

std::vector<Channel> make_aovs(const Names& names, const RenderedScene& rendered,
                               const std::atomic<bool>& stop, Names& missing) {
    const auto& [scene, intersector, shading, settings, film] = rendered;
    const std::vector<Aov> list = selected(names);
    AovInputs made{film};
    if (any_from(list, Source::means)) {
        made.means = surface_means(scene, intersector, settings, shading, &stop);
    }
    if (any_from(list, Source::centres)) {
        made.centres = centre_hits(scene, intersector, settings, &stop);
    }
    if (any_from(list, Source::parametrizations)) {
        made.parametrizations = centre_parametrizations(scene, intersector, settings, &stop);
    }
    std::vector<Channel> channels;
    for (const Aov& aov : list) {
        if (is_there(made, aov.source)) {
            std::visit([&](auto values) { add(aov, std::move(values), channels); },
                       aov.values(made));
        } else {
            missing.emplace_back(aov.name);
        }
    }
    return channels;
}

}  // namespace etalon
