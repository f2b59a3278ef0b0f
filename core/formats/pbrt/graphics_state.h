#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/formats/pbrt/frame.h"
#include "core/formats/pbrt/parameter_list.h"

namespace etalon::pbrt {

/// The current transformation at both times, and its numbers in the frame once it has been used.
class TransformState {
  public:
    TransformState() = default;
    TransformState(const Matrix4& start, const Matrix4& end) : start_(start) {
        if (end != start) end_ = end;
    }
    explicit TransformState(const Matrix4& always) : start_(always) {}

    const Matrix4& start() const { return start_; }
    const Matrix4& end() const { return end_ ? *end_ : start_; }
    bool is_animated() const { return end_.has_value(); }

    std::optional<TransformPair> numbers{};

  private:
    Matrix4 start_{};
    std::optional<Matrix4> end_{};  ///< only if it differs from that at the start
};

/// A material as it was stated, so that a shape can restate it with values of its own.
struct StatedMaterial {
    const PluginType* type;
    ParameterList parameters;
    std::uint32_t number;  ///< number of the material as stated
    FileLoc where;
};

/// State that AttributeBegin saves and AttributeEnd restores, apart from the transformation.
struct GraphicsState {
    std::shared_ptr<const StatedMaterial> material;
    std::uint32_t area_light = none;
    std::shared_ptr<const std::array<std::string, 2>> media;  ///< inside, outside; null: none
    bool reverse_orientation = false;
};

/// State that TransformBegin saves and TransformEnd restores. The matrices are changed in place
/// only where nothing else refers to them.
struct TransformScope {
    std::shared_ptr<TransformState> current = std::make_shared<TransformState>();
    std::array<bool, 2> active = {true, true};
};

}  // namespace etalon::pbrt
