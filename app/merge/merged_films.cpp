#include "app/merge/merged_films.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/part/image_identity.h"
#include "app/part/image_metadata.h"
#include "core/render/sample_rates.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

/// Parts of the identity that may differ among the parts of an image; their shares record them.
constexpr const char* free_names[] = {"crop", "spp", "seed", "part"};

/// A film of one of the files.
struct Input {
    const std::string* path;
    AppendixReader* file;
    const FilmAppendix* appendix;
    std::size_t number;

    const StoredFilm& stored() const { return appendix->films[number]; }

    /// Order in which films are added, independent of that of the files.
    auto key() const {
        const StoredFilm& film = stored();
        return std::tuple(film.window.min.y, film.window.min.x, film.window.max.y,
                          film.window.max.x, film.shares);
    }
};

Json fixed(Json identity) {
    for (const char* name : free_names) identity.erase(name);
    return identity;
}

std::string pixels_text(const Imath::Box2i& w) {
    return fmt::format("{},{},{},{}", w.min.x, w.min.y, w.max.x + 1, w.max.y + 1);
}

/// Returns why two films cannot both be in an image, or an empty string.
std::string conflict(const Input& a, const Input& b) {
    const Imath::Box2i &wa = a.stored().window, &wb = b.stored().window;
    if (!wa.intersects(wb)) return {};
    if (wa != wb) {
        return fmt::format("{} and {} overlap without being the same window: pixels {} and {}",
                           *a.path, *b.path, pixels_text(wa), pixels_text(wb));
    }
    const std::vector<SampleShare>&s = a.stored().shares, &t = b.stored().shares;
    for (auto i = s.begin(), k = t.begin(); i != s.end() && k != t.end();) {
        const std::uint32_t first = std::max(i->first, k->first), end = std::min(i->end, k->end);
        if (i->seed == k->seed && first < end) {
            return fmt::format("{} and {} hold the same samples: numbers {} to {} of seed {}",
                               *a.path, *b.path, first, end - 1, i->seed);
        }
        if (i->seed == k->seed && i->may_have_rates != k->may_have_rates) {
            return fmt::format(
                "{} and {} may hold the same samples of seed {}: one is of an image of fewer than "
                "{} samples per pixel, which has no more of them at the outlines of lights",
                *a.path, *b.path, i->seed, fewest_samples_with_rates);
        }
        std::pair(i->seed, i->end) < std::pair(k->seed, k->end) ? ++i : ++k;
    }
    return {};
}

std::string check(const std::vector<Input>& inputs) {
    const Json identity = fixed(inputs.front().appendix->identity);
    for (std::size_t i = 1; i < inputs.size(); ++i) {
        const std::string difference =
            identity_difference(fixed(inputs[i].appendix->identity), identity, "there");
        if (!difference.empty()) {
            return fmt::format("{}: is not of the same image as {}: {}", *inputs[i].path,
                               *inputs.front().path, difference);
        }
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        for (std::size_t k = i + 1; k < inputs.size(); ++k) {
            if (std::string error = conflict(inputs[i], inputs[k]); !error.empty()) return error;
        }
    }
    return {};
}

std::unique_ptr<ImageFilm> empty_film(const Json& identity, const Imath::Box2i& window) {
    return std::make_unique<ImageFilm>(window, film_settings(identity));
}

/// Adds the film of an input to that of its window. Returns whether it could be read.
bool add(const Input& input, MergedFilms& result) {
    const StoredFilm& stored = input.stored();
    if (result.films.empty() || result.films.back().stored.window != stored.window) {
        result.films.push_back(
            {{stored.window, {}, 0}, empty_film(result.identity, stored.window)});
    }
    const auto film = empty_film(result.identity, stored.window);
    StateReader bytes = input.file->film(*input.appendix, input.number);
    film->transfer(bytes);
    input.file->close();
    if (bytes.failed()) return false;
    MergedFilm& merged = result.films.back();
    merged.film->add(*film);
    merged.stored.shares.insert(merged.stored.shares.end(), stored.shares.begin(),
                                stored.shares.end());
    return true;
}

/// Returns what ended the rendering of a part early, or an empty string.
std::string stop_reason(const FilmAppendix& part) {
    const auto metadata = metadata_of(part.metadata);
    const auto found = metadata.find("stopped");
    const auto* reason =
        found == metadata.end() ? nullptr : std::get_if<std::string>(&found->second);
    return reason == nullptr ? "" : *reason;
}

}  // namespace

Result<MergedFilms> merge_films(const std::vector<std::string>& paths) {
    std::vector<FilmAppendix> appendices;
    std::vector<AppendixReader> files(paths.size());
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Result<FilmAppendix> appendix = files[i].open(paths[i]);
        if (!appendix) return {{}, appendix.error};
        appendices.push_back(std::move(appendix.value));
    }
    std::vector<Input> inputs;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (std::size_t k = 0; k < appendices[i].films.size(); ++k) {
            inputs.push_back({&paths[i], &files[i], &appendices[i], k});
        }
    }
    if (std::string error = check(inputs); !error.empty()) return {{}, std::move(error)};
    std::ranges::sort(inputs, {}, &Input::key);
    const FilmAppendix& first = *inputs.front().appendix;
    MergedFilms result{first.identity, first.metadata, {}, {}};
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const std::string reason = stop_reason(appendices[i]);
        if (!reason.empty()) result.stopped.push_back({paths[i], reason});
    }
    for (const Input& input : inputs) {
        if (!add(input, result))
            return {{}, *input.path + ": the sums behind the image are damaged"};
    }
    for (MergedFilm& merged : result.films) join_shares(merged.stored.shares);
    return {std::move(result), {}};
}

}  // namespace etalon
