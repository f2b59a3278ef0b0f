#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace etalon {

/// Something of a scene that a format cannot say, and how often that came up.
struct Loss {
    std::string what;
    std::size_t count;
};

/// Each kind of loss once, in the order of first appearance.
class Losses {
  public:
    void add(std::string_view what);
    std::vector<Loss> take() { return std::move(list_); }

  private:
    std::vector<Loss> list_;
};

}  // namespace etalon
