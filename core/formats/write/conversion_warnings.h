#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace etalon {

/// A property of a scene that a format cannot express, and how often it occurred.
struct ConversionWarning {
    std::string what;
    std::size_t count;
};

/// Warnings without duplicates, in the order of first appearance.
class ConversionWarnings {
  public:
    void add(std::string_view what);
    std::vector<ConversionWarning> take() { return std::move(list_); }

  private:
    std::vector<ConversionWarning> list_;
};

}  // namespace etalon
