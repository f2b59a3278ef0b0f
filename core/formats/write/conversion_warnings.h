#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace etalon {

/// Something of a scene that a format cannot say, and how often that came up.
struct ConversionWarning {
    std::string what;
    std::size_t count;
};

/// Each kind of warning once, in the order of first appearance.
class ConversionWarnings {
  public:
    void add(std::string_view what);
    std::vector<ConversionWarning> take() { return std::move(list_); }

  private:
    std::vector<ConversionWarning> list_;
};

}  // namespace etalon
