#pragma once

#include "core/render/image_film.h"

namespace etalon::frames {

/// Adds to a film, which must be empty, as many grey samples of each pixel as an image has there,
/// in batches as rendering does; beyond the image's window as many as at its border. Returns the
/// CPU seconds of adding them, and of the film's filter if it has one.
double fill_film(ImageFilm& film, const Film& image);

}  // namespace etalon::frames
