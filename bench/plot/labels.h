// Labels beside what they name, placed without overlap.
#pragma once

#include <string>
#include <vector>

#include "bench/plot/svg.h"

namespace etalon::plot {

struct Rectangle {
    double left, top, right, bottom;
};

struct Label {
    std::string text;
    bool is_bold;
    Position mark;  ///< what is labelled
    Position at{0, 0};
    Anchor anchor = Anchor::start;
    bool is_far = false;  ///< so that a line must lead from the mark to the text
};

/// Returns the area of the text with a margin; its width is an estimate, for a wide sans-serif font
/// of 12 pixels.
Rectangle extent(const Label& label);

/// Returns the point below or above the text that is nearest to the mark.
Position leader_end(const Label& label);

/// Chooses `at` for each label: inside `page`, off the marks, off the positions in `avoid` if
/// possible, near its mark.
void place_labels(std::vector<Label>& labels, const Rectangle& page,
                  const std::vector<Position>& avoid);

}  // namespace etalon::plot
