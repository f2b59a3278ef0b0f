// The few elements of SVG that a plot is made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace etalon::accuracy {

/// A place on the page, in pixels from its upper left.
struct Place {
    double x, y;
};

/// Which point of a text's baseline is where the text is said to be.
enum class Anchor { start, middle, end };

class Svg {
  public:
    Svg(double width, double height);

    /// `style`, here and below, is further attributes.
    void text(Place at, Anchor anchor, std::string_view text, std::string_view style);
    void line(Place from, Place to, std::string_view style);
    void polyline(const std::vector<Place>& places, std::string_view style);
    /// A disk that says `hint` where a pointer rests on it.
    void dot(Place at, double radius, std::string_view hint, std::string_view style);

    std::string finished() const { return text_ + "</svg>\n"; }

  private:
    std::string text_;
};

}  // namespace etalon::accuracy
