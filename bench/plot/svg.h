// The few SVG elements of a plot. bench/plot/style.h defines their appearance.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace etalon::plot {

/// A position on the page, in pixels from its upper left.
struct Position {
    double x, y;
};

/// Returns the text with the special characters of HTML and XML escaped, for attributes too.
std::string escaped(std::string_view text);

/// Point of a text's baseline that is at the text's position.
enum class Anchor { start, middle, end };

/// An SVG image. `classes` below are those of the style sheet.
class Svg {
  public:
    /// `title` and `description` are for readers who cannot see the image.
    Svg(double width, double height, std::string_view title, std::string_view description);

    void text(Position at, Anchor anchor, std::string_view text, std::string_view classes);
    void line(Position from, Position to, std::string_view classes);
    void polyline(const std::vector<Position>& positions, std::string_view classes);
    /// Draws the area that the positions enclose.
    void polygon(const std::vector<Position>& positions, std::string_view classes);
    /// Draws a disk that shows `hint` under a pointer.
    void dot(Position at, double radius, std::string_view hint, std::string_view classes);

    /// Returns an element for a page that has the style sheet.
    std::string inlined() const;
    /// Returns a file with the style sheet, on white, as a page that shows it may be dark. Its
    /// colours are no variables, which many viewers of such files do not know.
    std::string standalone() const;

  private:
    std::string document(std::string_view attributes, std::string_view beginning) const;

    double width_, height_;
    std::string text_;
};

}  // namespace etalon::plot
