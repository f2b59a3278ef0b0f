#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/part/film_appendix.h"
#include "core/render/image_film.h"

namespace etalon {

/// The sum of all films of one window.
struct MergedFilm {
    StoredFilm stored;
    std::unique_ptr<ImageFilm> film;
};

/// A file whose rendering was stopped, and why.
struct StoppedFile {
    std::string path, reason;
};

struct MergedFilms {
    nlohmann::ordered_json identity, metadata;  ///< of the first file in order
    std::vector<MergedFilm> films;              ///< of windows that do not overlap
    std::vector<StoppedFile> stopped;
};

/// Adds the films of these files one after the other, in an order that does not depend on that of
/// `paths`. An error names two files that do not fit.
Result<MergedFilms> merge_films(const std::vector<std::string>& paths);

}  // namespace etalon
