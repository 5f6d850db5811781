// Plots: one dot for each level, only finite numbers, and all text escaped for XML.
#include "measure/accuracy/plot.hpp"
#include "puzzle/data/game_data.hpp"
#include "tests/measure/accuracy/three_rungs.hpp"

#include <gtest/gtest.h>

namespace trembler::accuracy {
namespace {

TEST(AccuracyPlot, HasADotForEachLevelAndEscapesTextForXml) {
    std::vector<Ladder> all = climb(GameData{}, {}, {.brief = true, .runs = 1});
    all.push_back(threeRungs());
    markFront(all.back());
    for (Ladder const& one : all) {
        std::string const svg = asSvg(one);
        auto const count = [&](std::string const& what) {
            std::size_t found = 0;
            for (std::size_t at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1)) {
                ++found;
            }
            return found;
        };
        EXPECT_EQ(count("<circle"), one.rungs.size());
        EXPECT_EQ(count("<text"), count("</text>"));
        EXPECT_EQ(svg.find("nan"), std::string::npos) << one.scene;
        EXPECT_EQ(svg.find("inf"), std::string::npos) << one.scene;
        EXPECT_EQ(svg.find("<made-up>"), std::string::npos);
    }
}

} // namespace
} // namespace trembler::accuracy
