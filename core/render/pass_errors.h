#pragma once

#include "core/render/error_estimate.h"
#include "core/render/image_film.h"

namespace etalon {

/// Estimates the error of an image from how it changes from pass to pass.
class PassErrors {
  public:
    /// Estimates for images like this one, which must outlive this.
    PassErrors(const ImageFilm& image, const RenderSettings& settings);

    /// Looks at the image after a pass.
    void look();

    const ErrorEstimate& estimate() const { return estimate_; }

    /// Returns the relMSE of the image; nothing before samples were doubled.
    std::optional<double> expected() const;

    template <class Bytes>
    void transfer(Bytes& bytes) {
        estimate_.transfer(bytes);
        bytes(filtered_before_);
    }

  private:
    const ImageFilm& image_;
    const RenderSettings& settings_;
    ErrorEstimate estimate_;
    std::vector<Vec3> filtered_before_;  ///< filtered values at the last call
};

}  // namespace etalon
