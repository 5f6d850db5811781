// A ladder with fixed figures instead of measured ones.
#pragma once

#include "measure/accuracy/ladder.hpp"

#include <limits>

namespace trembler::accuracy {

inline Ladder threeRungs() {
    Ladder one;
    one.effect = "gravity";
    one.scene = "a <made-up> scene & more";
    one.unit = "m";
    one.error = "distance";
    one.reference = "nothing";
    one.rungs = {{"cheap", 1, 0.5, "much", false, {}},
                 {"silly", 10, 0.6, "much | more", false, {}},
                 {"expensive", 100, 0, "little", false, {}},
                 {"as expensive", 102, 0, "little", false, {}},
                 {"torn", 5, std::numeric_limits<double>::infinity(), "all", false, {}}};
    return one;
}

} // namespace trembler::accuracy
