// The few elements of SVG that a plot is made of. What they look like is in bench/plot/style.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace etalon::plot {

/// A place on the page, in pixels from its upper left.
struct Place {
    double x, y;
};

/// The text with what HTML and XML take for their own replaced, in attributes too.
std::string escaped(std::string_view text);

/// Point of a text's baseline that is at the text's position.
enum class Anchor { start, middle, end };

/// `classes`, in what follows, are those of the style sheet.
class Svg {
  public:
    /// `title` and `description` are for who cannot see the image.
    Svg(double width, double height, std::string_view title, std::string_view description);

    void text(Place at, Anchor anchor, std::string_view text, std::string_view classes);
    void line(Place from, Place to, std::string_view classes);
    void polyline(const std::vector<Place>& places, std::string_view classes);
    /// Round the area that the places border.
    void polygon(const std::vector<Place>& places, std::string_view classes);
    /// A disk that says `hint` where a pointer rests on it.
    void dot(Place at, double radius, std::string_view hint, std::string_view classes);

    /// An element for a page that has the style sheet.
    std::string inlined() const;
    /// A file, with the style sheet, on white: a page that shows it may be dark.
    std::string standalone() const;

  private:
    std::string document(std::string_view attributes, std::string_view beginning) const;

    double width_, height_;
    std::string text_;
};

}  // namespace etalon::plot
