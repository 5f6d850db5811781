// Circuits solved by elimination, compared with Ohm's law and textbook cases.
#include "measure/accuracy/ladders/wiring.hpp"

#include <gtest/gtest.h>

namespace trembler::accuracy {
namespace {

TEST(AccuracyWiring, CurrentsFollowOhmsLaw) {
    Wiring w;
    std::uint32_t const plus = w.add(Part::source, wireOhms);
    std::uint32_t const minus = w.add(Part::earth, wireOhms);
    std::uint32_t const a = w.add(Part::lamp, lampOhms);
    std::uint32_t const b = w.add(Part::lamp, lampOhms);
    std::uint32_t const loose = w.add(Part::lamp, lampOhms);
    w.cable(plus, a);
    w.cable(a, b);
    w.cable(b, minus);
    w.cable(b, loose);
    std::vector<double> const amperes = currents(w, potentials(w));
    double const expected = sourceVolts / (sourceOhms + 2 * wireOhms + 2 * lampOhms);
    EXPECT_NEAR(amperes[a], expected, 1e-12);
    EXPECT_NEAR(amperes[b], expected, 1e-12);
    EXPECT_NEAR(amperes[loose], 0, 1e-12);
}

TEST(AccuracyWiring, LampsGlowAsInTextbookCases) {
    auto const all = schoolbook(72);
    for (std::size_t i = 0; i < all.size(); ++i) {
        Wiring const& w = all[i];
        std::vector<bool> const glow = glowing(w);
        std::vector<bool> lamps;
        for (std::size_t p = 0; p < w.parts.size(); ++p) {
            if (w.parts[p] == Part::lamp) {
                lamps.push_back(glow[p]);
            }
        }
        switch (i % 6) {
        case 0: // a balanced bridge: the four arms are lit, the lamp across is dark
            EXPECT_EQ(lamps, (std::vector<bool>{true, true, true, false, true}));
            break;
        case 3: // a bridge with a wire in one arm: all lamps are lit
            EXPECT_EQ(lamps, (std::vector<bool>{true, true, true, true}));
            break;
        case 1: // a wire bypasses the middle lamp
            EXPECT_EQ(lamps, (std::vector<bool>{true, false, true}));
            break;
        case 2: { // each has 1/k² of its rated power: dark for k of 10 or more
            bool const bright = lamps.size() < 10;
            EXPECT_EQ(lamps, std::vector<bool>(lamps.size(), bright)) << lamps.size();
            break;
        }
        case 4:
            EXPECT_EQ(lamps, (std::vector<bool>{true, true, true, false}));
            break;
        default:
            EXPECT_EQ(lamps, (std::vector<bool>{false, false, true}));
        }
    }
}

} // namespace
} // namespace trembler::accuracy
