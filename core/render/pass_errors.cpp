#include "core/render/pass_errors.h"

#include "core/render/filtered_errors.h"

namespace etalon {

PassErrors::PassErrors(const ImageFilm& image, const RenderSettings& settings)
    : image_(image),
      settings_(settings),
      estimate_(image.samples().width(),
                static_cast<int>(image.samples().size()) / image.samples().width(),
                settings.decodes()) {}

void PassErrors::look() {
    const Film& film = image_.samples();
    if (!image_.is_filtered()) return estimate_.look(film);
    const Film image = image_.filtered();
    filtered_before_.resize(image.size(), Vec3(0));
    const FilteredErrors errors =
        filtered_errors(image, filtered_before_, film.window(), settings_);
    estimate_.look(film, &errors);
    for (std::size_t i = 0; i < image.size(); ++i) filtered_before_[i] = image.mean(i);
}

std::optional<double> PassErrors::expected() const {
    return estimate_.exists() ? std::optional(estimate_.total()) : std::nullopt;
}

}  // namespace etalon
