// The words of a picture and their places, read back from what ImGui draws: for tests of the layout.
#pragma once

#include "game/ui/shared/layout.hpp"

#include <string>
#include <vector>

namespace trembler::ui::test {

/// Words on one line, as they are drawn: without the parts outside their clip rectangle.
struct DrawnText {
    std::string text;       ///< UTF-8; gaps between letters are single spaces
    std::string window;     ///< ImGui's name of the window
    Rect rect;              ///< around the letters' ink, pixels
    double line = 0;        ///< height of a line of this font, pixels
    double top = 0;         ///< of the line, pixels
    bool cutAcross = false; ///< some letter lacks its left or right side
    bool cutAlong = false;  ///< some letter lacks its top or bottom
    bool scrolled = false;  ///< the window scrolls up and down, so letters may be cut along its edges
};

/// All words of the picture that GameApp::frame() last made, drawn or not, in the order in which they are
/// drawn. Faint ones, such as the halo around names on the paper, are left out. Window thread only, before
/// the next picture.
[[nodiscard]] std::vector<DrawnText> drawnTexts();

/// Whether `second` continues `first` on the next line and a number is separated there from its digits, its
/// unit ("4 | seconds") or its other part ("0 | of 5").
[[nodiscard]] bool breaksANumber(DrawnText const& first, DrawnText const& second);

} // namespace trembler::ui::test
