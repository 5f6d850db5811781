// A bar with a number at its right end, in a row of a table.
#pragma once

#include <string>

namespace trembler::ui {

/// All lengths in points of the interface at 100 %.
struct TimeBar {
    float share = 0;     ///< of the bar that is filled, 0 to 1; at least a round spot unless it is 0
    float limit = 0;     ///< share at which a line is drawn; 0: none
    bool over = false;   ///< the time is beyond its limit: a colour that warns
    std::string text{};  ///< the number
    bool grey = false;   ///< the number is of no importance
    float half = 4;      ///< half of the bar's height
    float numbers = 58;  ///< width that is kept for the number
    bool framed = false; ///< as high as a button or a field of the row, else as a line of text
};

/// As wide as what is left of the table's cell.
void drawTimeBar(TimeBar const& bar);

} // namespace trembler::ui
