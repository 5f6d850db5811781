// A bar with a number at its right end, in a row of a table.
#pragma once

#include <string>

namespace trembler::ui {

/// All lengths in pixels at UI scale 1.
struct TimeBar {
    float share = 0;     ///< filled share of the bar, 0 to 1; at least a dot is drawn unless it is 0
    float limit = 0;     ///< share at which a line is drawn; 0: none
    bool over = false;   ///< the time exceeds its limit: uses the warning colour
    std::string text{};  ///< the number
    bool grey = false;   ///< draws the number in grey, as unimportant
    float half = 4;      ///< half of the bar's height
    float numbers = 58;  ///< width reserved for the number
    bool framed = false; ///< as high as a framed widget of the row, else as a line of text
};

/// Uses the remaining width of the table's cell.
void drawTimeBar(TimeBar const& bar);

} // namespace trembler::ui
