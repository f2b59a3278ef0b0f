#pragma once

#include <cstdint>
#include <vector>

#include "core/sampling/point_names.h"

namespace etalon {

/// The vertices of many paths, in SoA layout: the pixel, the name of the ray (see PathDimension)
/// and the sample of each. Padded to a multiple of sobol_lanes.
class VertexNames {
  public:
    void clear() { size_ = 0; }

    /// Adds the vertex that ray `name` of sample number `index` of a pixel hits.
    void add(std::uint32_t pixel, std::uint32_t name, std::uint32_t index) {
        if (size_ == pixels_.size()) {
            for (auto* row : {&pixels_, &names_, &indices_}) row->resize(2 * size_ + sobol_lanes);
        }
        pixels_[size_] = pixel;
        names_[size_] = name;
        indices_[size_] = index;
        ++size_;
    }

    /// Replaces `points` by point number `k` of `parts` of a choice at each vertex: see
    /// SampleSource::stratified(), whose dimension is the hash of the ray's name and the choice.
    void name_points(std::uint32_t choice, std::uint32_t k, std::uint32_t parts,
                     PointNames& points) const;

  private:
    std::size_t size_ = 0;
    std::vector<std::uint32_t> pixels_, names_, indices_;
};

}  // namespace etalon
