#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/merge/film_appendix.h"
#include "core/render/image_film.h"

namespace etalon {

/// The films of all samples of one window.
struct MergedFilm {
    StoredFilm stored;
    std::unique_ptr<ImageFilm> film;
};

struct MergedFilms {
    nlohmann::ordered_json identity, metadata;  ///< those of the first in order
    std::vector<MergedFilm> films;              ///< of windows that do not overlap
};

/// Adds up the films of these files, one after the other, in an order of their own. An error says
/// which file does not fit which.
Result<MergedFilms> merge_films(const std::vector<std::string>& paths);

}  // namespace etalon
