#include "core/formats/spectrum/read_spectrum.h"

#include <cmath>

#include "core/formats/spectrum/number_text.h"

namespace etalon {

std::vector<SpectralSample> read_spectrum(std::string_view text, DiagnosticLog& log) {
    const std::vector<PlacedNumber> numbers = read_number_text(text, log);
    if (numbers.size() % 2 != 0) {
        log.warn(numbers.back().offset, "count",
                 "the last number is left out: expected pairs of a wavelength and a value");
    }
    std::vector<SpectralSample> samples;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        const SpectralSample sample{numbers[i].value, numbers[i + 1].value};
        if (std::isnan(sample.wavelength) || std::isnan(sample.value)) {
            log.warn(numbers[i].offset, "range", "pair left out: a number of it is too large");
        } else {
            samples.push_back(sample);
        }
    }
    return samples;
}

}  // namespace etalon
